"""Command lines that make a picture of the studio again."""

import shlex
from collections.abc import Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any

from stylit_ref.parameters import option_words
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.studio.engine.parameters import DENSE_PRESETS
from stylit_ref.studio.engine.shown import Shown
from stylit_ref.stylization.params import Params


def command_lines(
    shown: Shown,
    guides: Sequence[tuple[str, str]],
    *,
    style: Path,
    nnf: Path,
) -> tuple[str, ...]:
    """Command lines, each of which gives the bytes of the picture.

    Parameters
    ----------
    shown : Shown
    guides : sequence of (str, str)
        Files of source and target.
    style, nnf : Path
        Files that were written. Beside them each command writes an image that bears its name,
        to be compared with the picture.

    Returns
    -------
    tuple of str
        What a replay or a warm frame came of is its NNF alone; ``run`` makes all others again.
    """
    replay = ["replay", "--nnf", _file(nnf), "--style", _file(style)]
    lines = [replay] if shown.which in ("replay", "warm") else [_run(shown, guides, style, nnf)]
    if shown.which not in ("replay", "warm"):
        lines.append(replay)
    return tuple(
        shlex.join(
            ["stylit-ref", *words, "--output", _file(nnf.with_name(f"{words[0]}.png")), "--quiet"]
        )
        for words in lines
    )


def _run(shown: Shown, guides, style: Path, nnf: Path) -> list[str]:
    settings = shown.settings
    if shown.which == "coherent":
        words = ["run", "--method", "realtime"]
        params, plain = settings.live, RealtimeParams()
    else:
        preset = DENSE_PRESETS[shown.which]
        words = ["run", "--preset", preset]
        params = settings.dense_params(shown.which, shown.scene.buffers)
        plain = Params.preset(preset)
    words += ["--style", _file(style)]
    weights = settings.weights_of(shown.scene.buffers)
    for (source, target), weight in zip(guides, weights, strict=True):
        words += ["--guide", _file(source), _file(target)]
        if weight != 1 and shown.weighs_buffers:
            words += ["--weight", str(weight)]
    for name, value in _changed(params, plain).items():
        words += option_words(name, value)
    if settings.seed:
        words += ["--seed", str(settings.seed)]
    if shown.scene.steps > 1 and shown.scene.encodings:
        words += ["--guide-encoding", _file(nnf)]  # that of all steps, not of this one alone
    return words


def _changed(params: RealtimeParams | Params, plain: RealtimeParams | Params) -> dict[str, Any]:
    names = [each.name for each in fields(params) if each.name != "guide_weights"]
    values = {name: getattr(params, name) for name in names}
    return {name: value for name, value in values.items() if value != getattr(plain, name)}


def _file(path: str | Path) -> str:
    """A name that a command line does not take for an option."""
    return f"./{path}" if str(path).startswith("-") else str(path)
