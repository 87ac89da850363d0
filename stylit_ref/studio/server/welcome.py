"""What a page is told at first: all that it shows, but for pictures and its role."""

from collections.abc import Sequence
from typing import Any

from stylit_ref.studio.engine.parameters import FIELDS, Field, Settings
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.painting.easel import Easel
from stylit_ref.studio.painting.folder import Setting
from stylit_ref.studio.scene_files.offer import Offer
from stylit_ref.studio.scene_files.shelf import Shelf
from stylit_ref.studio.server.protocol import VERSION


def welcome(
    easel: Easel,
    shelf: Shelf,
    scene: Scene,
    panels: Sequence[str],
    notes: Sequence[str],
) -> dict[str, Any]:
    """All of it.

    Parameters
    ----------
    easel : Easel
    shelf : Shelf
    scene : Scene
        That is open.
    panels : sequence of str
    notes : sequence of str
    """
    height, width = easel.size
    return {
        "version": VERSION,
        "painting": {
            "width": width,
            "height": height,
            "name": str(easel.folder.root.resolve()),
            "serial": easel.serial,
        },
        "scenes": [_offered(offer, scene) for offer in shelf],
        "seed": easel.setting.seed,
        "panels": list(panels),
        "notes": list(notes),
        **panels_of_scene(shelf.offer(scene.name), easel.setting),
    }


def panels_of_scene(offer: Offer, setting: Setting) -> dict[str, Any]:
    """What changes with the scene.

    Parameters
    ----------
    offer : Offer
        Of the scene that is open.
    setting : Setting
    """
    values = Settings().with_parameters(setting.parameters).values
    return {
        "scene": offer.name,
        "step": setting.step,
        "parameters": {"fields": [_field(field) for field in FIELDS], "values": values},
        "weights": dict(setting.weights),
        "layers": list(setting.layers.get(offer.name) or offer.usual),
    }


def _offered(offer: Offer, scene: Scene) -> dict[str, Any]:
    height, width = offer.target_size
    buffers = scene.buffers if offer.name == scene.name else offer.usual
    return {
        "name": offer.name,
        "title": offer.title,
        "steps": len(offer.targets),
        "width": width,
        "height": height,
        "buffers": list(buffers),
        "layers": list(offer.layers),
    }


def _field(field: Field) -> dict[str, Any]:
    return {
        "name": field.name,
        "kind": field.kind,
        "least": field.least,
        "most": field.most,
        "choices": list(field.choices),
        "help": field.help,
        "of": field.of,
        "odd": field.is_odd,
        "optional": field.is_optional,
    }
