"""The figures of one patch (2, 6, 7), and of patches about to be laid (1, right)."""

import numpy as np

from eval.documents.lasram.one_patch import OnePatch
from eval.pages.figures import contact_sheet
from stylit_ref.texture.formulae.polar import BLOCKED
from stylit_ref.texture.formulae.seam_cost import ONE
from stylit_ref.texture.overlay import overlay
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession

TRIED = 75
"""Random patches of which the one that shows most is drawn."""

_GREEN = (60, 255, 60)


def overlay_figure(plan, file):
    """Figure 1, right: seams, and the patches of the next iteration."""
    session = _session(plan, "flowers", 10)
    rows = [[("E[S]", session.image), ("seams and patches", overlay(session))]]
    contact_sheet(rows, file, tile=400)


def patch_figure(plan, file):
    """Figure 2: a patch, its polar table, its cut, and the texture with it."""
    patch = _most_telling(_session(plan, "canes", 3), lambda each: -each.cost)
    polar, work = patch.polar, patch.work
    jump = patch.settings.max_jump
    crossed = work.crossing[0][:, jump:-jump].astype(np.int64) + work.saved[0]
    crossed[work.crossing[0][:, jump:-jump] >= BLOCKED // 2] = 0
    errors = np.minimum(255, 30 * np.log1p(np.maximum(crossed, 0) / 16)).astype(np.uint8)
    errors = np.repeat(errors[..., None], 3, axis=2)
    for step in (0, 1):
        columns = np.minimum(patch.path + step, errors.shape[1] - 1)
        errors[np.arange(len(columns)), columns] = _GREEN
    disc = polar.radius_at < 256 * patch.settings.radius
    laid = np.where(disc, _translated(patch), -1)
    own = _shown(patch, laid, background=False)
    polar_view = own.reshape(-1, 3)[polar.inside]
    rows = [
        [("(a) P", own), ("(b) P on E[S]", _shown(patch, laid)),
         ("(c) P, polar, a row for an angle", _widened(polar_view))],
        [("(d) errors, cut", _widened(errors)), ("(e) cut on P", _with_border(patch, own)),
         ("(f) stitched", _shown(patch, patch.patch))],
    ]  # fmt: skip
    contact_sheet(rows, file, tile=260)


def alignment_figure(plan, file):
    """Figure 6: a patch whose features are aligned."""
    patch = _most_telling(_session(plan, "canes", 6), _saved_by_alignment)
    before, after = _shown(patch, patch.patch), _shown(patch, patch.deformed)
    inside = patch.polar.inside
    beside = _along(patch, before), _along(patch, after)
    polar_views = [_widened(view.reshape(-1, 3)[inside]) for view in (before, after)]
    rows = [
        [("(a) seams", before), ("(b) aligned", after)],
        [("(c) polar, before", polar_views[0]), ("(d) polar, after", polar_views[1])],
        [("(e) inside and outside of C, before", beside[0]), ("(f) after", beside[1])],
    ]
    contact_sheet(rows, file, tile=340)


def initial_state_figure(plan, file):
    """Figure 7: a round cut, D from the worst fixed first shift, and ours."""
    patch = _most_telling(_session(plan, "canes", 6), _saved_by_alignment)
    patch.path[:] = patch.polar.inside.shape[1] * 3 // 4
    patch.begin_alignment()
    costs = []
    shifts = range(2 * patch.settings.max_shift + 1)
    for start in shifts:
        patch.align(start)
        costs.append(patch.aligned)
    row = []
    for title, start in (("a fixed first shift", shifts[int(np.argmax(costs))]), ("ours", -1)):
        patch.align(start)
        patch.write()
        cost = f"{patch.aligned / ONE:.0f}"
        row.append((f"{title}: {cost}", _shown(patch, patch.deformed)))
    contact_sheet([[("a round cut", _shown(patch, patch.patch)), *row]], file, tile=300)


def _session(plan, exemplar, iterations):
    params = TextureParams.preset("paper")
    texture = plan.paper(exemplar).scene
    session = TextureSession([texture.exemplar], texture.shape, params)
    for _ in range(iterations):
        session.step()
    return session


def _most_telling(session, telling):
    """Of some random patches, all stages done, the one with the largest number."""
    rng = np.random.default_rng(0)
    centres = session.exemplars.centres(2 * session.params.radius)  # whole patches alone
    best, most = None, -np.inf
    for _ in range(TRIED):
        patch = OnePatch(session, tuple(rng.integers(0, session.size)), int(rng.choice(centres)))
        for stage in (patch.read, patch.begin_cut, patch.cut, patch.begin_alignment, patch.align):
            stage()
        if telling(patch) > most:
            best, most = patch, telling(patch)
    best.write()
    return best


def _saved_by_alignment(patch):
    """What the crossings of the cut cost, less what they cost when aligned."""
    rows = np.arange(patch.path.size)
    jump = patch.settings.max_jump
    crossed = (
        patch.work.crossing[0][rows, patch.path + jump] + patch.work.saved[0][rows, patch.path]
    )
    return int(crossed.sum()) - patch.aligned


def _window(patch):
    """Places of the patch's window in the texture."""
    reach = patch.polar.half_width.size // 2
    offsets = np.arange(-reach, reach + 1)
    return offsets, np.ix_(
        *((at + offsets) % side for at, side in zip(patch.place, patch.session.size, strict=True))
    )


def _translated(patch):
    """The exemplar around the patch's centre, as addresses of its window."""
    offsets, _ = _window(patch)
    return (patch.source + offsets[:, None] * patch.settings.stride + offsets).ravel()


def _shown(patch, addresses, background=True):
    """Colours of a window: what the patch writes, over the texture or over white."""
    _, places = _window(patch)
    side = patch.polar.half_width.size
    written = addresses.reshape(side, side)
    under = patch.session.texture.addresses[places]
    image = patch.session.exemplars.show(
        np.ascontiguousarray(np.where(written >= 0, written, under), np.int32)
    )
    image = np.array(np.broadcast_to(image, (side, side, 3)))
    if not background:
        image[written < 0] = 255
    return image


def _with_border(patch, image):
    image = image.copy()
    written = patch.patch.reshape(image.shape[:2]) >= 0
    inner = written.copy()
    for axis in (0, 1):
        inner &= np.roll(written, 1, axis) & np.roll(written, -1, axis)
    image[written & ~inner] = _GREEN
    return image


def _along(patch, image):
    """Colours just inside of the cut, and just outside, row by row, from left to right."""
    polar, rows = patch.polar, np.arange(patch.path.size)
    last = polar.inside.shape[1] - 1
    columns = np.maximum(patch.path - 1, 0), np.minimum(patch.path + 2, last)
    lines = [image.reshape(-1, 3)[polar.inside[rows, each]] for each in columns]
    return np.repeat(np.stack(lines), len(rows) // 2, axis=0)


def _widened(table):
    """A polar table as wide as it is high: its columns are radii, from the centre outwards."""
    return np.repeat(table, max(1, round(table.shape[0] / table.shape[1])), axis=1)
