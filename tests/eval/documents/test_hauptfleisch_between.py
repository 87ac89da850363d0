"""Views between views, angles and failures in the report on views: when their claims hold."""

from types import SimpleNamespace

import numpy as np
import pandas as pd
import pytest
from small_run import cameras_of_grid, write_run

from eval import between_views
from eval.documents.hauptfleisch import angles, between, failures
from eval.documents.hauptfleisch.between import SHOWN, Between
from eval.pages.claims import HELD, NOT_HELD, OPEN
from stylit_ref.views.interpolation.of_run import views_of_run

GRID = {"cameras": cameras_of_grid((-10, 0, 10), (10, 15, 20)), "grid": (3, 3)}


def test_every_mode_is_measured_on_a_grid_that_is_coherent_and_one_that_is_not(
    tmp_path, monkeypatch
):
    run = write_run(tmp_path / "run", **GRID)
    asked = []

    def stylized(self, folder, seed, options):
        asked.append(options)
        return views_of_run(run.folder)

    monkeypatch.setattr(between_views, "STEP", 4.0)
    monkeypatch.setattr(Between, "_stylized", stylized)
    outcome = Between("views.json", "0").run(None, 0)
    assert asked == [(), ("--coherence", "0")]
    assert outcome.image.shape[0] == len(SHOWN)
    table = outcome.history.set_index("mode")
    assert set(between.NUMBERS) <= set(table)
    needed = ["limited", "linear", "nnf"]
    assert not table.loc[needed, list(between.NUMBERS)].isna().any(axis=None)
    assert table.loc["limited, views stylized alone", "switch"] == table.loc["limited", "switch"]


def good_table():
    """Numbers with which all claims hold."""
    columns = "mode", "change", "switch", "middle", "outlines", "ghosts", "error", "kept", "cpu"
    rows = [
        ("the views themselves", np.nan, np.nan, 11.0, 0.3, 0.003, np.nan, np.nan, np.nan),
        ("linear", 1.6, 1.7, 8.0, 0.3, 0.001, 12.0, 0.7, 2.0),
        ("image", 2.3, 4.8, 11.9, 0.3, 0.003, 8.0, 1.2, 9.0),
        ("blend", 2.0, 2.1, 9.8, 0.3, 0.002, 6.0, 0.9, 10.0),
        ("nnf", 2.0, 4.5, 10.4, 0.3, 0.003, 7.3, 0.95, 9.0),
        ("limited", 2.0, 3.8, 10.5, 0.29, 0.003, 7.0, 0.96, 18.0),
        ("limited, views stylized alone", 2.3, 6.7, np.nan, np.nan, np.nan, np.nan, np.nan, 18.0),
        ("limited, thesis' masks", np.nan, np.nan, 10.0, 0.2, 0.007, np.nan, np.nan, np.nan),
    ]
    return pd.DataFrame(rows, columns=columns)


def verdicts(monkeypatch, table):
    monkeypatch.setattr(between, "stored", lambda job: SimpleNamespace(history=table))
    return [claim.verdict for claim in between.claims("a run")]


def test_claims_of_views_between_hold(monkeypatch):
    assert set(verdicts(monkeypatch, good_table())) == {HELD}


@pytest.mark.parametrize(
    ("mode", "number", "value", "claim"),
    [
        ("limited, views stylized alone", "switch", 3.9, 0),
        ("nnf", "change", 2.4, 1),
        ("nnf", "switch", 3.7, 2),
        ("linear", "middle", 9.0, 3),
        ("blend", "middle", 11.5, 4),
        ("limited, thesis' masks", "ghosts", 0.004, 5),
        ("limited", "kept", 0.8, 6),
        ("image", "cpu", 17.0, 7),
    ],
)
def test_one_number_turns_one_claim(monkeypatch, mode, number, value, claim):
    table = good_table().set_index("mode")
    table.loc[mode, number] = value
    found = verdicts(monkeypatch, table.reset_index())
    assert [k for k, each in enumerate(found) if each == NOT_HELD] == [claim]


def test_what_is_not_rendered_cannot_be_judged(tmp_path):
    assert between.method(tmp_path) is None
    assert not angles.is_rendered(tmp_path, "inked")
    found = [
        *between.claims(None),
        *angles.claims(tmp_path, None),
        *failures.claims(has_pictures=False),
    ]
    assert {claim.verdict for claim in found} == {OPEN}
    assert all(claim.rule and claim.evidence for claim in found)


@pytest.mark.parametrize(
    ("apart", "errors", "lost", "expected"),
    [
        (4.0, (1, 2, 3, 4, 9), (0, 0.1, 0.1, 0.1, 0.3), [HELD, HELD, HELD]),
        (6.0, (1, 2, 3, 4, 9), (0, 0.1, 0.1, 0.1, 0.3), [NOT_HELD, HELD, HELD]),
        (4.0, (1, 3, 2, 4, 9), (0, 0.1, 0.1, 0.1, 0.3), [HELD, NOT_HELD, HELD]),
        (4.0, (1, 2, 3, 4, 9), (0, 0.1, 0.1, 0.4, 0.3), [HELD, HELD, NOT_HELD]),
    ],
)
def test_claims_of_angles(monkeypatch, tmp_path, apart, errors, lost, expected):
    rows = [
        {
            "view": view,
            "degrees": degrees,
            "apart": apart if view == "0" else np.nan,
            "guide_error": errors[(0, 10, 20, 30, 180).index(degrees)],
            "lost_lines": lost[(0, 10, 20, 30, 180).index(degrees)],
        }
        for view, degrees in angles.VIEWS.items()
    ]
    monkeypatch.setattr(angles, "table", lambda data, style: pd.DataFrame(rows))
    assert [claim.verdict for claim in angles.claims(tmp_path, "inked")] == expected
