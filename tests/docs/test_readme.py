"""README is short, its pictures are small, and on the package index its links lead somewhere."""

import subprocess
import sys

from docs.test_links import ROOT, places_of

README = ROOT / "README.md"


def test_it_is_short():
    assert README.stat().st_size <= 6000


def test_its_pictures_are_small():
    places = places_of(README.read_text(encoding="utf-8"))
    sizes = [(ROOT / place).stat().st_size for place in places if place.endswith(".webp")]
    assert len(sizes) > 1
    assert max(sizes) < 300_000
    assert sum(sizes) - max(sizes) < 100_000


def test_links_are_whole_on_the_package_index():
    command = sys.executable, "-m", "hatchling", "metadata", "readme"
    shown = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    places = list(places_of(shown))
    assert len(places) == len(list(places_of(README.read_text(encoding="utf-8"))))
    assert [place for place in places if not place.startswith("https://")] == []
