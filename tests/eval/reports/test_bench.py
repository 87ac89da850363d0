"""The report bench on a tiny scene."""

import re
import sys

import pandas as pd
import pytest

from eval.__main__ import main
from eval.reports.bench import THESIS


@pytest.mark.slow
def test_bench_measures_both_programs_alike(folder, capsys, monkeypatch):
    """With a program that copies the style in place of ebsynth."""
    monkeypatch.setattr("eval.reports.bench.THESIS", {**THESIS, "levels": 1, "votes": 1})
    monkeypatch.setattr("eval.reports.bench.EBSYNTH_DEFAULTS", {**THESIS, "levels": 1, "votes": 1})
    monkeypatch.setattr("eval.reports.bench.SCALES", (1, 2))
    program = folder.parent / "program"
    program.write_text(
        f"#!{sys.executable}\n"
        "import sys\n"
        "from stylit_ref import read_image, write_image\n"
        "from pathlib import Path\n"
        "options = sys.argv\n"
        "Path('arguments.txt').write_text(' '.join(options))\n"
        "image = read_image(options[options.index('-style') + 1])\n"
        "write_image(options[options.index('-output') + 1], image[:38, :44])\n"
    )
    program.chmod(0o755)
    assert main(["bench", "--scene", str(folder), "--ebsynth", str(program)]) == 0
    arguments = (folder.parent / "arguments.txt").read_text()
    assert re.search(r"-guide \S+source_fullgi.png \S+target_fullgi.png -weight 1.5 ", arguments)
    assert re.search(r"source_id.png \S+target_id.png -weight 0.5 -uniformity 10000", arguments)
    assert "-pyramidlevels 1 -searchvoteiters 1 -patchmatchiters 6" in arguments
    numbers = pd.read_csv(folder.parent / "build" / "reports" / "bench_small_44x38" / "bench.csv")
    assert list(numbers["program"]) == ["stylit-ref"] + ["stylit-ref", "ebsynth"] * 2
    printed = capsys.readouterr().out
    assert "one thread takes" in printed
    assert "preset fast: ebsynth (ebsynth's defaults) takes" in printed
    assert re.search(r"compilation: the first process on a machine takes \d", printed)
    assert "44x38" in printed
    assert "88x76" in printed
