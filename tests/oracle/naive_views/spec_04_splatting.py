"""4. Splatting."""

import numpy as np

from .spec_01_names import NOWHERE, Motion, pixels, place_of, told
from .spec_03_vectors import differ, fixed


def depth_of_things(depth):
    """Give depth that is infinite where nothing is."""
    found = np.full(depth.shape, np.inf)
    for pixel in pixels(depth.shape):
        if 0 < depth[pixel] < 1e9:
            found[pixel] = depth[pixel]
    return found


class Landing:
    """Where the pixels of a frame land, and who wins."""

    def __init__(self, motion, depth):
        size = motion.visible.shape
        self.motion = motion
        self.depth = np.ones(size) if depth is None else depth_of_things(depth)
        self.winners = np.full((*size, 2), -1)
        self.beaten, self.contested = np.zeros(size, bool), np.zeros(size, bool)
        for pixel in pixels(size):
            place = place_of(motion, pixel)
            if place != NOWHERE and self.wins(pixel, place):
                self.winners[place] = pixel
        for pixel in pixels(size):
            place = place_of(motion, pixel)
            if place != NOWHERE:
                winner = tuple(self.winners[place])
                self.beaten[pixel] = differ(motion.field[pixel], motion.field[winner])
                self.contested[place] |= self.beaten[pixel]

    def distance(self, pixel, place):
        """Tell how far from the middle of its place a pixel lands, squared."""
        dx, dy = self.motion.field[pixel]
        away_x = fixed(dx) + 256 * (pixel[1] - place[1])
        away_y = fixed(dy) + 256 * (pixel[0] - place[0])
        return away_x**2 + away_y**2

    def wins(self, pixel, place):
        """Tell whether a pixel is the winner of those so far."""
        before = tuple(self.winners[place].tolist())
        if before == NOWHERE:
            return True
        if self.depth[pixel] == self.depth[before]:
            return self.distance(pixel, place) < self.distance(before, place)
        return self.depth[pixel] < self.depth[before]


def close(vector, other):
    """Tell whether neither component differs by more than 1."""
    return bool((np.abs(vector - other) <= 1).all())


def fill_cracks(field, visible, empty, down, right):
    """Fill cracks between neighbours in one direction, from what was before."""
    before, seen = field.copy(), visible.copy()
    for y, x in pixels(visible.shape):
        one, two = (y - down, x - right), (y + down, x + right)
        inside = min(one) >= 0 and two[0] < seen.shape[0] and two[1] < seen.shape[1]
        if inside and empty[y, x] and seen[one] and seen[two] and close(before[one], before[two]):
            field[y, x], visible[y, x] = before[one], True


def inverted(motion, depth):
    """Give the motion back."""
    landing = Landing(motion, depth)
    empty = landing.winners[:, :, 0] < 0
    field, visible = np.zeros(motion.field.shape, np.float32), ~empty
    for pixel in np.argwhere(visible).tolist():
        field[tuple(pixel)] = -motion.field[tuple(landing.winners[tuple(pixel)])]
    if depth is None:
        visible &= ~landing.contested
    certain = visible.copy()
    fill_cracks(field, visible, empty, 0, 1)
    fill_cracks(field, visible, empty, 1, 0)
    filled = Motion(field, visible.copy())
    for pixel in np.argwhere(visible & ~certain).tolist():
        pixel = tuple(pixel)
        place = place_of(filled, pixel)
        visible[pixel] = (
            place != NOWHERE
            and motion.visible[place]
            and bool((np.abs(motion.field[place] + field[pixel]) <= 1).all())
        )
    return Motion(field, visible)


def unhidden(motion, depth):
    """Tell which pixels the other frame shows."""
    landing = Landing(motion, depth)
    found = np.zeros(motion.visible.shape, bool)
    for pixel in pixels(found.shape):
        place = place_of(motion, pixel)
        if place != NOWHERE:
            hidden = landing.contested[place] if depth is None else landing.beaten[pixel]
            found[pixel] = not hidden
    return found


def of_case(a):
    """Give motion and depth of a case."""
    return Motion(a["field"], a["visible"]), a.get("depth")


def stage_splat(p, a):
    """Do stage splat."""
    landing = Landing(*of_case(a))
    return {name: getattr(landing, name) for name in ("winners", "beaten", "contested")}


def stage_invert(p, a):
    """Do stage invert."""
    return told(inverted(*of_case(a)))


def stage_unhidden(p, a):
    """Do stage unhidden."""
    return {"visible": unhidden(*of_case(a))}


STAGES = {"splat": stage_splat, "invert": stage_invert, "unhidden": stage_unhidden}
