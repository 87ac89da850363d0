"""Hostile names, links, pipes and folders: one sentence and code 2, or the expected result."""

import os
from pathlib import Path

import pytest
from hostile.command_line import accepted, refused, run

from stylit_ref import read_image

pytestmark = pytest.mark.usefixtures("folder")


def made(name="out.png"):
    assert read_image(name).shape == (11, 14, 3)


# Names of inputs


def test_a_missing_image():
    refused(run("--style", "none.png"), "none.png: no such file")


def test_a_folder_as_an_image():
    Path("levels.png").mkdir()
    refused(run("--style", "levels.png"), "levels.png: is a folder; name an image file")


def test_a_link_to_itself_as_an_image():
    Path("loop.png").symlink_to("loop.png")
    refused(
        run("--style", "loop.png"), "loop.png: is a link that leads back to itself; name a file"
    )


def test_a_name_of_300_letters():
    refused(run("--style", f"{'x' * 300}.png"), "…x.png: cannot be used: File name too long")


def test_a_name_that_is_no_text_in_utf_8():
    refused(run("--style", "\udcff.png"), "…: is not valid UTF-8; give the file another name")


def test_names_with_spaces_and_unicode():
    Path("style.png").rename("mein Stil, ψ 猫.png")
    accepted(run("--style", "mein Stil, ψ 猫.png", "--output", "à côté.png"))
    made("à côté.png")


def test_a_name_with_a_line_break():
    Path("style.png").rename("a\nb.png")
    accepted(run("--style", "a\nb.png"))
    made()


def test_a_name_with_a_line_break_of_a_file_that_is_not_there():
    refused(run("--style", "a\nb.png"), "a b.png: no such file")


def test_a_name_that_would_act_on_the_terminal():
    refused(run("--style", "a\x1b[31m\rb\u3000λ 猫.png"), "a�[31m b λ 猫.png: no such file")


def test_an_option_that_would_act_on_the_terminal():
    refused(run("--a\rb\x07"), "there is no option --a b� …")


# Names of outputs


def test_a_name_that_begins_with_a_dash():
    refused(
        run("--output", "-out.png"),
        "--output -out.png: a name cannot begin with a dash; write ./-out.png …",
    )


def test_a_name_that_begins_with_a_dash_after_an_equals_sign():
    accepted(run("--output=-out.png"))
    made("-out.png")


def test_an_output_that_is_a_folder():
    Path("made.png").mkdir()
    refused(run("--output", "made.png"), "made.png: is a folder; name a file")


def test_an_output_that_is_a_pipe():
    os.mkfifo("pipe.png")
    refused(run("--output", "pipe.png"), "pipe.png: is a device or a pipe; name an ordinary file")


def test_a_saved_field_that_is_a_pipe():
    os.mkfifo("pipe.npy")
    refused(run("--nnf", "pipe.npy"), "pipe.npy: is a device or a pipe; name an ordinary file")


def test_an_output_where_nothing_can_be_made():
    refused(run("--output", "/proc/out.png"), "/proc/out.png: cannot be written: …")


def test_an_output_of_a_format_that_makes_no_file():
    refused(
        run("--output", "out.null"),
        "out.null: no image format has the suffix '.null'; use .png, .tif or .exr",
    )


# Links


def test_an_output_that_is_a_link_replaces_the_file_it_leads_to():
    Path("deep").mkdir()
    Path("deep/real.png").write_bytes(b"old")
    Path("link.png").symlink_to("deep/real.png")
    accepted(run("--output", "link.png"))
    assert Path("link.png").is_symlink()
    made("deep/real.png")


def test_an_output_that_is_a_link_to_no_file_makes_it():
    Path("link.png").symlink_to("new.png")
    accepted(run("--output", "link.png"))
    assert Path("link.png").is_symlink()
    made("new.png")


def test_an_output_that_is_a_link_into_a_missing_folder():
    Path("link.png").symlink_to("none/new.png")
    accepted(run("--output", "link.png"))
    assert Path("link.png").is_symlink()
    made("none/new.png")


def test_an_output_that_is_a_link_to_itself():
    Path("loop.png").symlink_to("loop.png")
    refused(
        run("--output", "loop.png"), "loop.png: is a link that leads back to itself; name a file"
    )


# Outputs that would overwrite other files


def test_an_output_that_is_the_style():
    refused(
        run("--output", "style.png"),
        "style.png: the output would overwrite this input; name another file",
    )


def test_an_output_that_is_a_link_to_the_style():
    Path("link.png").symlink_to("style.png")
    refused(
        run("--output", "link.png"),
        "link.png: the output would overwrite this input; name another file",
    )


def test_an_output_that_is_a_hard_link_of_the_style_leaves_the_style_alone():
    os.link("style.png", "hard.png")
    before = Path("style.png").read_bytes()
    accepted(run("--output", "hard.png"))
    assert Path("style.png").read_bytes() == before
    made("hard.png")


def test_a_style_that_saved_levels_would_overwrite():
    Path("style.png").rename("level_1.png")
    refused(
        run("--style", "level_1.png", "--save-levels", "."),
        "level_1.png: the output would overwrite this input; name another file",
    )


def test_an_output_among_the_saved_levels():
    refused(
        run("--output", "level_2.png", "--save-levels", "."),
        "level_2.png: two outputs have this name; name another file",
    )


def test_an_output_among_the_saved_guide_maps():
    refused(
        run("--output", "guide_map_2.png", "--save-levels", ".", "--method", "guide_map"),
        "guide_map_2.png: two outputs have this name; name another file",
    )


def test_an_output_named_as_a_guide_map_of_a_method_without():
    accepted(run("--output", "guide_map_2.png", "--save-levels", "."))
    made("guide_map_2.png")


# Folders


def test_an_example_in_a_folder_of_300_letters():
    refused(["example", "x" * 300], "…x: cannot be used: File name too long")


def test_an_example_in_a_folder_whose_name_is_no_text_in_utf_8():
    refused(["example", "a\udcffb"], "…: is not valid UTF-8; give the file another name")


def test_an_example_in_a_file():
    refused(["example", "style.png/new"], "style.png/new: cannot be written: Not a directory")
