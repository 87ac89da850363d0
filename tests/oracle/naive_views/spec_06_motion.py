"""6. The motion of an edge."""

import numpy as np

from .spec_01_names import NOWHERE, Motion, pixels, place_of, told
from .spec_03_vectors import cancelling, composed
from .spec_04_splatting import inverted, unhidden
from .spec_05_silhouettes import along, inverse_depths


class Files:
    """What the files of a sequence hold."""

    def __init__(self, p, a):
        self.tells_visible, self.a = p["tells_visible"], a

    def known(self, name, frame):
        """Give depth or labels of a frame, or None."""
        return self.a.get(f"{name}_{frame}")

    def motion(self, frame, other):
        """Give the motion that the file of a frame holds towards a neighbour, or None."""
        way = "forward" if other > frame else "backward"
        field = self.known(way, frame)
        return None if field is None else Motion(field, self.known(f"{way}_shown", frame))

    def of_both(self, name, *frames):
        """Give depth or labels of two frames, or None if they are not known of both."""
        found = [self.known(name, frame) for frame in frames]
        return None if any(each is None for each in found) else found


def same_labels(motion, labels, other):
    """Tell which pixels lead to their own label."""
    found = np.zeros(motion.visible.shape, bool)
    for pixel in pixels(found.shape):
        place = place_of(motion, pixel)
        found[pixel] = place != NOWHERE and labels[pixel] == other[place]
    return found


def one_step(files, frame, neighbour):
    """Give the motion from a frame into a neighbouring one."""
    ahead, back = files.motion(frame, neighbour), files.motion(neighbour, frame)
    if ahead is None:
        motion = inverted(back, files.known("depth", neighbour))
    elif files.tells_visible:
        motion = ahead
    elif back is not None:
        motion = Motion(ahead.field, cancelling(ahead, back))
    else:
        motion = Motion(ahead.field, unhidden(ahead, files.known("depth", frame)))
    labels = files.of_both("labels", frame, neighbour)
    if labels is None:
        return motion
    return Motion(motion.field, motion.visible & same_labels(motion, *labels))


def motion_between(files, to, other):
    """Give the motion from a frame into any other."""
    step = 1 if other > to else -1
    whole = None
    for frame in range(to, other, step):
        motion = one_step(files, frame, frame + step)
        whole = motion if whole is None else composed(whole, motion)
    depths, labels = (files.of_both(name, to, other) for name in ("depth", "labels"))
    if depths is not None:
        return along(whole, *(inverse_depths(depth, None) for depth in depths))
    if labels is not None:
        return along(whole, *(inverse_depths(None, of_frame) for of_frame in labels))
    return whole


def stage_motion(p, a):
    """Do stage motion."""
    return told(motion_between(Files(p, a), p["to"], p["other"]))


STAGES = {"motion": stage_motion}
