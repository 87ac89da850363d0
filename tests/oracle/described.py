"""Hold the text of a family against its cases."""

import re
from fnmatch import fnmatchcase

import numpy as np

from oracle.cases import read_cases
from oracle.families import folder_of, spec_of, stages_of


def text_of(family):
    """The text of a family's newest version."""
    return spec_of(family.versions[-1]).read_text(encoding="utf-8")


def assert_every_stage_has_cases_and_a_section(family):
    """And that the sections that are named are there."""
    text = text_of(family)
    assert set(family.sections) == set(stages_of(family.versions[-1]))
    assert all(f"\n## {section}. " in text for section in family.sections.values())


def stages_in_table(family):
    """The stages in the table of what goes in and comes out."""
    table = text_of(family).partition("\n| stage |")[2].partition("\n\n")[0]
    rows = re.findall(r"^\| (\w.*?) \|", table, re.MULTILINE)
    return {stage for row in rows for stage in row.split(", ")}


def assert_every_name_of_a_case_is_explained(family, plain=lambda case: case.name):
    """And that no name is explained that no case has; ``plain`` gives the name to look for."""
    table = text_of(family).partition("\n| name | why it is there |")[2].partition("\n\n")[0]
    rows = re.findall(r"^\| (`.+`) \|", table, re.MULTILINE)
    explained = {name.strip("`") for row in rows for name in row.split(", ")}
    used = set()
    for case in read_cases(family.versions[-1]):
        found = {name for name in explained if fnmatchcase(plain(case), name)}
        assert found, case.title
        used |= found
    assert used == explained


def assert_types_of_files_are_those_that_occur(family, section):
    """The types that the text names from a section on."""
    told = set(re.findall(r"`([|<]\w\d)`", text_of(family).partition(f"## {section}.")[2]))
    files = folder_of(family.versions[-1]).rglob("*.npy")
    assert {np.lib.format.dtype_to_descr(np.load(file).dtype) for file in files} == told
