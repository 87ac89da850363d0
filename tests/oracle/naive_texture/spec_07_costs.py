"""7. Costs of a cut."""

import numpy as np

from .spec_01_names import BLOCKED, in_disc, offset_of, r10, reach
from .spec_05_seams import guide_cost, seam, seams


class Patch:
    """A patch of the exemplar at ``source``, over the pixel (y, x) of S."""

    def __init__(self, p, a, source, y, x):
        self.p, self.a, self.source, self.y, self.x = p, a, source, y, x
        self.stride = a["valid"].shape[1]
        if "seams_x" not in a:
            given = a["addresses"], a["colours"], self.stride, p["eta"], p["exponent"]
            a["seams_x"], a["seams_y"] = seams(*given)
        self.anything_locked = bool(np.any(a.get("lock", False)))

    def pixel(self, dy, dx):
        """Give the pixel of S."""
        height, width = self.a["addresses"].shape
        return (self.y + dy) % height, (self.x + dx) % width

    def old(self, dy, dx):
        """Give the address that S shows."""
        return int(self.a["addresses"][self.pixel(dy, dx)])

    def new(self, dy, dx):
        """Give the address that the patch would show."""
        return self.source + dy * self.stride + dx

    def locked(self, dy, dx):
        """Tell whether a pixel is locked."""
        return self.anything_locked and bool(self.a["lock"][self.pixel(dy, dx)])

    def seam(self, a, b, step):
        """Cost of a seam."""
        return seam(self.a["colours"], a, b, step, self.p["eta"], self.p["exponent"])

    def new_edge(self, dy, dx, down):
        """Cost of an edge that a cut crosses, when costs are halved."""
        after = (dy + 1, dx) if down else (dy, dx + 1)
        step = self.stride if down else 1
        if self.locked(dy, dx) and self.locked(*after):
            return 0
        if (dy if down else dx) < 0:
            cost = self.seam(self.old(dy, dx), self.new(*after), step)
        else:
            cost = self.seam(self.new(dy, dx), self.old(*after), step)
        return min(cost >> self.halved, self.p["new_limit"])

    def hides(self, dy, dx):
        """Give what a place of the reach hides."""
        weight, inside = self.p["guide_weight"], in_disc(self.p["radius"], dy, dx)
        pixel = self.pixel(dy, dx)
        costs = int(self.a["seams_x"][pixel]), int(self.a["seams_y"][pixel])
        total = 0
        if not self.anything_locked:
            total = sum(costs)
        elif inside:
            for down, cost in enumerate(costs):
                after = (dy + 1, dx) if down else (dy, dx + 1)
                step = self.stride if down else 1
                first, second = self.locked(dy, dx), self.locked(*after)
                if first and second:
                    continue
                total += cost
                if first:
                    total -= self.seam(self.old(dy, dx), self.new(*after), step)
                elif second:
                    total -= self.seam(self.new(dy, dx), self.old(*after), step)
        if weight > 0 and inside and not self.locked(dy, dx):
            guides, wanted = self.a["guide_colours"], self.a["guide"][pixel]
            total += guide_cost(guides[self.old(dy, dx)], wanted, weight)
            total -= guide_cost(guides[self.new(dy, dx)], wanted, weight)
        return total

    def halve(self):
        """Find how often costs are halved, and what places hide then."""
        hidden = {place: self.hides(*place) for place in reach(self.p["radius"])}
        self.halved = 0
        while sum(abs(cost) for cost in hidden.values()) >> self.halved > self.p["hidden_limit"]:
            self.halved += 1
        limit = self.p["existing_limit"]
        return {p: max(-limit, min(limit, hidden[p] >> self.halved)) for p in hidden}

    def tables(self):
        """Fill saved, crossing and steps."""
        hides = self.halve()
        a, radius = self.a, self.p["radius"]
        valid = a["valid"].ravel()
        rows, columns = a["inside"].shape
        saved, crossing, steps = (np.zeros((rows, columns), int) for _ in range(3))

        def edges(table, y, x):
            (y_x, x_x), (y_y, x_y) = (
                offset_of(int(a[f"{table}_{axis}"][y, x]), radius) for axis in "xy"
            )
            return self.new_edge(y_x, x_x, False), self.new_edge(y_y, x_y, True)

        for y in range(rows):
            hidden = stepped = 0
            ended = None
            for x in range(columns):
                offset = offset_of(int(a["inside"][y, x]), radius)
                hidden += r10(hides[offset] * int(a["area"][x]))
                saved[y, x] = hidden
                along, across = edges("cut", y, x)
                cost = r10(along * int(a["cut_cosine"][y]) + across * int(a["cut_sine"][y]))
                crossing[y, x] = r10(cost * int(a["cut_weight"][x])) - hidden
                along, across = edges("step", y, x)
                cost = r10(along * int(a["step_sine"][y]) + across * int(a["step_cosine"][y]))
                stepped += r10(cost * int(a["step_weight"][x]))
                steps[y, x] = stepped
                if ended is None and not valid[self.new(*offset)]:
                    ended = x
            if ended is not None:
                crossing[y, max(ended - 1, 0) :] = BLOCKED
        return saved, crossing, steps


def stage_costs(p, a):
    """Do stage costs."""
    patch = Patch(p, a, p["source"], p["y"], p["x"])
    saved, crossing, steps = patch.tables()
    return {"saved": saved, "crossing": crossing, "steps": steps, "halved": patch.halved}


STAGES = {"costs": stage_costs}
