"""Procedural models: one family a file, all in the units of the stage."""

from data_gen.models.golem import golem
from data_gen.models.hand import hand
from data_gen.models.helmet import helmet
from data_gen.models.pumpkin import pumpkin
from data_gen.models.scorpion import scorpion
from data_gen.models.sphere import sphere
from data_gen.models.stego import stego
from data_gen.models.teapot import teapot

TARGETS = {
    "stego": stego,
    "scorpion": scorpion,
    "hand": hand,
    "teapot": teapot,
    "helmet": helmet,
    "pumpkin": pumpkin,
    "golem": golem,
}
"""In the order of the thesis' tables. The names say which row a model stands in for."""

__all__ = ["TARGETS", "sphere"]
