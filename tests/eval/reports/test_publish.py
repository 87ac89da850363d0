"""The committed copies of reports, and how ``make reports`` makes them."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from eval.pages.figures import contact_sheet
from eval.pages.page import BUILT, new_report
from eval.reports.publish import MOST_BYTES, MOST_OF_COPY, publish, small_figures
from stylit_ref import InputError

ROOT = Path(__file__).parents[3]


def committed(*places):
    """The files that git holds in some places, and their bytes."""
    command = ["git", "-C", ROOT, "ls-files", "-z", "--", *places]
    names = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    files = (ROOT / name for name in names.split("\0") if name)
    return {file.relative_to(ROOT): file.stat().st_size for file in files if file.exists()}


def test_committed_reports_are_slim():
    files = committed("reports")
    assert files
    assert sum(files.values()) <= 8_000_000
    assert {file.suffix for file in files} <= {".md", ".csv", ".json", ".webp"}
    assert max(files.values()) <= 400_000


def test_pictures_of_the_pages_are_slim():
    pictures = committed("docs/*.webp", "docs/*.png", "*.png", ":!data_gen", ":!oracle", ":!tests")
    assert pictures
    assert {file.suffix for file in pictures} == {".webp"}
    assert max(pictures.values()) <= 400_000


@pytest.fixture
def built(tmp_path, monkeypatch):
    """A report with three figures: one that is not chosen, a small one, and one of noise."""
    monkeypatch.chdir(tmp_path)
    noise = np.random.default_rng(0).integers(0, 256, (900, 900, 3), np.uint8)
    sheet = [[("noise", noise)] * 3]
    with new_report(BUILT / "noise") as report:
        report.page(
            "Noise",
            [
                report.figure("whole", "all of it", contact_sheet, sheet),
                "Text.",
                report.figure("small", "a part", contact_sheet, [sheet[0][:1]], committed=True),
                report.figure("large", "all", draw_large, sheet, committed=True),
            ],
        )
    return BUILT / "noise"


def draw_large(rows, file):
    """A sheet of many pixels."""
    contact_sheet(rows, file, tile=900)


@pytest.mark.slow
def test_only_what_a_report_chooses_is_committed_and_it_is_small(built, tmp_path):
    assert (built / "large.webp").stat().st_size > 4 * MOST_BYTES
    assert publish(["noise"]) == [Path("reports/noise")]
    copy = tmp_path / "reports" / "noise"
    assert {file.name for file in copy.iterdir()} == {"report.md", "small.webp", "large.webp"}
    text = (copy / "report.md").read_text(encoding="utf-8")
    assert text == "# Noise\n\nText.\n\n![a part](small.webp)\n\n![all](large.webp)\n"
    assert (copy / "small.webp").read_bytes() == (built / "small.webp").read_bytes()
    assert (copy / "large.webp").stat().st_size <= MOST_BYTES
    with Image.open(built / "large.webp") as whole, Image.open(copy / "large.webp") as small:
        shape = whole.height / whole.width
        assert small.height / small.width == pytest.approx(shape, rel=0.01)


@pytest.mark.slow
def test_the_largest_figures_give_way_if_all_are_too_many_bytes(built):
    files = [built / "small.webp", built / "large.webp"]
    small = files[0].stat().st_size
    found = small_figures(files, small + 100_000)
    assert found["small.webp"] == files[0].read_bytes()
    assert 50_000 < len(found["large.webp"]) <= 100_000


@pytest.mark.parametrize("document", MOST_OF_COPY)
def test_the_committed_copy_of_a_document_is_within_its_bounds(document):
    assert 0 < sum(committed(f"reports/{document}_*").values()) <= MOST_OF_COPY[document]


@pytest.mark.slow
def test_without_names_the_committed_reports_are_made_anew(built, tmp_path):
    with pytest.raises(InputError, match="holds none of the committed reports"):
        publish()
    publish(["noise"])
    (tmp_path / "reports" / "noise" / "old.csv").touch()
    (tmp_path / "reports" / "other").mkdir()
    assert publish() == [Path("reports/noise")]
    assert not (tmp_path / "reports" / "noise" / "old.csv").exists()
    with pytest.raises(InputError, match=r"build/reports/none: is not a finished report"):
        publish(["none"])
