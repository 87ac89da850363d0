"""Calls of the command line, at a small size."""

from stylit_ref.cli import main

QUICK = ["--pyramid-levels", "2", "--search-vote-iters", "1", "--patchmatch-iters", "1"]


def run(
    folder, *more, style="style.png", guides=("source_{}.png", "target_{}.png"), quick=QUICK
):  # fmt: skip
    """Call ``run`` on the scene's files; ``more`` comes after them."""
    command = ["run", "--style", f"{folder / style}", "--output", f"{folder / 'out.png'}"]
    for k in range(2):
        command += ["--guide", *(f"{folder / guide.format(k)}" for guide in guides)]
    return main([*command, *quick, *map(str, more)])


def sequence(folder, *more, guides=2, quick=QUICK):
    """Call ``sequence`` on the shot's files; ``more`` comes after them."""
    command = ["sequence", "--style", f"{folder}/style.png", "--output", f"{folder}/out.%04d.png"]
    for k in range(guides):
        command += ["--guide", f"{folder}/source_{k}.png", f"{folder}/target_{k}.%04d.png"]
    return main([*command, *quick, *map(str, more)])


def refused(capsys, code):
    """The one sentence a refusal printed."""
    assert code == 2
    message = capsys.readouterr().err.strip()
    assert message.startswith("stylit-ref: ")
    assert "\n" not in message
    return message
