# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 8. Textures from patches
#
# ![Bricks, a texture of them, and a cheaper one that has lost the mortar](pictures/8_textures.webp)
#
# The other notebooks copy small patches and average them. Lasram & Lefebvre (2012) copy large ones
# and average nothing: each is cut out along a line where it fits, and laid over what is there.
# This notebook follows one patch from its place to its cut, aligns its features, then watches the
# energy of a whole texture fall, and ends with a picture whose energy is low and which is no good.
# It covers sections 3 to 6 and 8 of the paper.

# %% tags=["hide-input"]
import matplotlib.pyplot as plt
import numpy as np
from scipy.stats import wasserstein_distance
from skimage.util import view_as_windows

from data_gen.textures import make_texture
from stylit_ref import TextureParams, TextureSession, synthesize_texture
from stylit_ref.texture.formulae.polar import BLOCKED, WEIGHT_BITS, make_polar
from stylit_ref.texture.formulae.seam_cost import ONE
from stylit_ref.texture.passes.cut import accumulate, closed_path

flowers = make_texture("flowers")


def show(place, image, title, **how):
    place.imshow(image, **how)
    place.set_title(title, fontsize=9)
    place.axis("off")


# %% [markdown]
# ## A texture is a map
#
# The synthesizer does not hold colours but a map $S$ of places in the exemplar $E$; the picture is
# $E[S]$. Where two neighbours in $S$ are neighbours in $E$, nothing can be seen. Everywhere else
# there is a *seam*, and section 4 says what it costs. With $a = S[t]$ and $b = S[t + \delta]$:
#
# $$M = \left( \frac{|E[a] - E[b - \delta]|^2 + |E[b] - E[a + \delta]|^2}
# {\eta + |E[a] - E[a + \delta]|^2 + |E[b] - E[b - \delta]|^2} \right)^d$$
#
# Above: does $b$ look like what follows $a$ in the exemplar, and $a$ like what comes before $b$?
# Below: is there so much contrast that nobody will notice? We write it down and compare it with the
# library's seams on white noise, with which synthesis begins.

# %%
session = TextureSession([flowers], (256, 256), TextureParams(), seed=3)
noise = session.image


def seam_costs(coordinates, image, eta=1000):
    """M of the edge to the right of every pixel, d = 2; whole pixels."""
    y, x = coordinates[..., 1] // 4, coordinates[..., 2] // 4
    colours = np.pad(image.astype(float), ((1, 1), (1, 1), (0, 0)), mode="edge")

    def colour(dx, places=(y, x)):
        return colours[places[0] + 1, places[1] + 1 + dx]

    after = tuple(np.roll(place, -1, axis=1) for place in (y, x))
    squared = lambda a, b: ((a - b) ** 2).sum(axis=-1)  # noqa: E731
    above = squared(colour(0), colour(-1, after)) + squared(colour(0, after), colour(1))
    below = squared(colour(0), colour(1)) + squared(colour(0, after), colour(-1, after))
    return (above / (eta + below)) ** 2


seams_right, _ = session.seams
mine = seam_costs(session.coordinates, flowers)
assert np.allclose(seams_right / ONE, mine, rtol=1e-5, atol=1 / ONE)
print(f"mean cost of a seam in white noise: {mine.mean():.0f}")

for _ in range(4):
    session.step()
before = session.image

fig, axes = plt.subplots(1, 4, figsize=(12, 3.2), layout="constrained")
show(axes[0], flowers, "E")
show(axes[1], noise, "E[S], white noise")
show(axes[2], before, "E[S] after 4 iterations")
cost = sum(session.seams) / ONE
show(axes[3], np.log10(cost + 1e-2), "log₁₀ of what its seams cost", cmap="magma")
plt.show()

# %% [markdown]
# ## Round and closed: the polar table
#
# A patch is a disc of radius $R$. It shall be cut out along a closed line around its centre. In
# polar coordinates a line around the centre is a path from top to bottom, one radius $C[y]$ for
# each angle $y$, and that is a case for dynamic programming:
#
# $$T[y, i] = \min_{|i - j| \le J} (T[y - 1, j] + V(j, i, y)) + H(i, y) - \mathcal{E}(i, y)$$
#
# $H$ is what the new seam costs, $V$ what a step along the ray costs, and $\mathcal{E}$ what is
# gained: the old seams that the patch would hide. Here is the map from the plane to the table, on
# the disc in the middle of the picture above.

# %%
R = 60
polar = make_polar(R, 2.0, 1.5, "arc_length")
rows, columns = polar.inside.shape
side = int(np.sqrt(polar.radius_at.size))
middle = 128 - side // 2
window = before[middle : middle + side, middle : middle + side].reshape(-1, 3)
hidden = cost[middle : middle + side, middle : middle + side].ravel()

fig, axes = plt.subplots(1, 2, figsize=(9, 5), layout="constrained")
disc = np.where((polar.radius_at < R * 256)[:, None], window, 255).reshape(side, side, 3)
show(axes[0], disc, f"the disc, R = {R}")
show(axes[1], window[polar.inside], f"its table: {rows} angles, {columns} radii")
axes[1].set_aspect("auto")
plt.show()

area = (hidden[polar.inside] * polar.area / (1 << WEIGHT_BITS)).sum()
print(f"seams in the disc {hidden[polar.radius_at < R * 256].sum():.0f}, in the table {area:.0f}")

# %% [markdown]
# The left of the table is the centre, blown up: each of its samples stands for little area. The
# normalization $\mathcal{N}$ of Appendix A weighs it, so that both sums nearly agree.
#
# ## A path that closes
#
# The path must end where it began. One dynamic programming for each first column would find the
# best, and take 120 times as long. The paper's observation: best paths never cross. Follow all of
# them from the bottom to the top. If the one that ends in column 1 begins further to the right, the
# one that ends in column 2 cannot begin further to the left... and the last has nowhere to go. So
# one of them closes (Appendix B), and the cheapest of those that do is taken.
#
# We make tables of our own, with a valley of low cost that wiggles, and draw all best paths.

# %%
J = 3
rng = np.random.default_rng(5)
table_rows, table_columns = 90, 60
valley = 30 + 12 * np.sin(np.arange(table_rows) * 2 * np.pi / table_rows)
distance = abs(np.arange(table_columns) - valley[:, None])
crossing = np.full((table_rows, table_columns + 2 * J), BLOCKED, np.int32)
crossing[:, J:-J] = 300 + 20 * distance + rng.integers(0, 900, distance.shape)
steps = np.zeros_like(crossing)  # V: steps along a ray are free here


def solve(arrivals):
    """T, and the closed path that the library takes from it."""
    totals = np.empty((table_rows + 1, crossing.shape[1]), np.int32)
    accumulate(crossing, steps, J, arrivals, totals, *np.empty((2, totals.shape[1]), np.int32))
    path = np.empty(table_rows, np.int32)
    ends = np.empty((2, totals.shape[1] + 1), np.int32)
    return totals, path, closed_path(totals, steps, J, arrivals, path, *ends)


def followed(totals, end):
    """The best path to a column of the last row, from top to bottom; ties to the left."""
    path = [end + J]
    for y in range(table_rows, 0, -1):
        reach = totals[y - 1, path[-1] - J : path[-1] + J + 1]
        path.append(path[-1] - J + int(reach.argmin()))
    return np.array(path[::-1]) - J


anywhere = np.zeros(table_columns + 2 * J, np.int32)
totals, path, cost_of_one_pass = solve(anywhere)
everyone = [followed(totals, end) for end in range(table_columns)]
closed = [way for way in everyone if way[0] == way[-1]]
only = np.full((table_columns, anywhere.size), BLOCKED, np.int32)
only[np.arange(table_columns), J + np.arange(table_columns)] = 0
optimum = min(solve(one)[2] for one in only)
arrived = np.minimum(totals[-1] - totals[-1].min(), BLOCKED)
_, again, cost_of_two = solve(arrived)

fig, axes = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
for place in axes:
    place.imshow(crossing[:, J:-J], cmap="gray", aspect="auto")
    place.axis("off")
for way in everyone:
    axes[0].plot(way, np.arange(table_rows + 1), color="orange", linewidth=0.8)
for way in closed:
    axes[0].plot(way, np.arange(table_rows + 1), color="lime", linewidth=2)
axes[0].set_title(f"all {table_columns} best paths; {len(closed)} close", fontsize=9)
axes[1].plot(path, np.arange(table_rows), color="lime", label=f"one pass: {cost_of_one_pass}")
axes[1].plot(again, np.arange(table_rows), color="red", ls="--", label=f"two: {cost_of_two}")
axes[1].set_title(f"the cut; the best of {table_columns} starts costs {optimum}", fontsize=9)
axes[1].legend()
plt.show()
assert optimum <= cost_of_two <= cost_of_one_pass

# %% [markdown]
# The paths run together from below, like rivers seen from the sea. Usually the cut of one pass is
# the best there is, or nearly; now and then it is much worse. A path may begin in every column for
# nothing, and one that begins cheaply keeps all others from the columns where they end. The library
# runs a second pass, which the paper has not. It goes around once more, and begins in every column
# with what the first pass paid to arrive there. Its cut is nearly always the best.
#
# ## Why the energy must fall
#
# A patch is taken only if it lowers the cost of $S$. The polar table estimates that; but it is made
# of samples, and the patch of pixels. So the library writes the patch to the side, sums the exact
# change over all edges it touches, in integers, and takes it if that is below zero. The paper's
# predicates use the table alone. What is the difference?

# %%
SIZE, ITERATIONS = (192, 192), 14
runs = {}
for predicate in ("exact", "before", "none"):
    params = TextureParams(radius=32, candidates=1, predicate=predicate)
    running = TextureSession([flowers], SIZE, params, seed=7)
    runs[predicate] = [running.step().cost / 192**2 for _ in range(ITERATIONS)]
    assert running.cost == running.recount()

fig, place = plt.subplots(figsize=(7, 3.4), layout="constrained")
for predicate, costs in runs.items():
    place.plot(range(1, ITERATIONS + 1), costs, ".-", label=predicate)
place.set(xlabel="iteration", ylabel="cost a pixel", yscale="log")
place.legend()
plt.show()

assert (np.diff(runs["exact"]) <= 0).all()

# %% [markdown]
# With `none` every patch is laid down, and the cost stays higher and rises at times. The other two
# fall together.
# `exact` cannot rise: each patch lowers the total, patches of one iteration do not touch, and so
# their changes add up to the last bit, with any number of threads.
#
# ## Aligning features
#
# A regular texture leaves a patch no good place to be cut: somewhere the lines do not meet. Section
# 5 lets the colours along the cut slide by up to $D_{max}$ samples until they meet what lies
# outside, by the same dynamic programming, and spreads the slide inwards. We lay bricks without
# rejection, once stiff and once soft.

# %%
bricks = make_texture("bricks")
laid = {}
for shift in (0, 32):
    params = TextureParams.preset("paper", radius=48, predicate="none", max_deformation=shift)
    running = TextureSession([bricks], (192, 192), params, seed=2)
    for _ in range(5):
        done = running.step()
    laid[shift] = running.image, done

fig, axes = plt.subplots(1, 3, figsize=(11, 3.8), layout="constrained")
show(axes[0], bricks, "E")
for place, (shift, (image, done)) in zip(axes[1:], laid.items(), strict=True):
    show(place, image, f"D_max {shift}: cost a pixel {done.cost / 192**2:.2f}")
plt.show()

# %% [markdown]
# ## Why low energy is not beauty
#
# Now we have an energy that can only fall. Shall we let it fall for as long as it likes? Small
# patches and many iterations find the cheapest texture. On the right it costs least by far.

# %% tags=["picture"]
settings = {
    "24 iterations, R = 64": TextureParams(radius=64, radius_step=0, candidates=64),
    "150 iterations, R = 16": TextureParams(radius=16, iterations=150, candidates=1),
}
textures = {
    name: synthesize_texture(bricks, (256, 256), params, seed=1)
    for name, params in settings.items()
}


def patch_distance(image, exemplar, width=7, directions=64):
    """Sliced Wasserstein distance between the patches of two pictures."""
    rng = np.random.default_rng(0)
    axes = rng.normal(size=(width * width * 3, directions))
    axes /= np.linalg.norm(axes, axis=0)

    def projected(picture):
        patches = view_as_windows(picture, (width, width, 3), 3).reshape(-1, width * width * 3)
        return patches.astype(float) @ axes

    ours, theirs = projected(image), projected(exemplar)
    return np.mean([wasserstein_distance(*pair) for pair in zip(ours.T, theirs.T, strict=True)])


fig, axes = plt.subplots(1, 3, figsize=(12, 4), layout="constrained")
show(axes[0], bricks, "E")
for place, (name, result) in zip(axes[1:], textures.items(), strict=True):
    cost = result.history[-1].cost / 256**2
    away = patch_distance(result.image, bricks)
    show(place, result.image, f"{name}\ncost {cost:.4f}, distance of patches {away:.1f}")
plt.show()
good, cheap = textures.values()
assert cheap.history[-1].cost < good.history[-1].cost
assert patch_distance(cheap.image, bricks) > patch_distance(good.image, bricks)

# %% [markdown]
# The energy asks whether anything is there that is not in the exemplar. It does not ask whether all
# that is in the exemplar is there. Mortar makes seams, so small patches without mortar win, one by
# one, until it is gone. So reports show the energy beside the distance between all patches of the
# texture and all patches of the exemplar, and the pictures.
#
# ## Exercises
#
# Write a function of the same name in place of each solution, and unfold the solution only after
# yours passes the test below it.
#
# ### The share of seams
#
# Write `seam_share(coordinates)`: of all pixels, how many have a right neighbour in $S$ that is not
# their right neighbour in $E$? The texture wraps around; coordinates are `(exemplar, y, x)`, in
# quarters of a pixel.


# %% tags=["hide-input"]
def seam_share(coordinates):
    after = np.roll(coordinates, -1, axis=1)
    return (after - coordinates != (0, 0, 4)).any(axis=2).mean()


# %%
y, x = np.mgrid[:8, :10]
whole = np.stack([0 * y, 4 * y, 4 * x], axis=2)
assert seam_share(whole) == 1 / 10  # where it wraps
assert seam_share(whole[:, ::-1]) == 1
assert seam_share(textures["24 iterations, R = 64"].coordinates) < 0.2
print(f"{seam_share(textures['24 iterations, R = 64'].coordinates):.1%} of the pixels")

# %% [markdown]
# ### A closed path by hand
#
# Write `cheapest_closed(table, jump)`: the least sum of a path with one entry for each row, of
# which neighbours differ by at most `jump` columns, the last and the first too. Take your time: the
# table is small.


# %% tags=["hide-input"]
def cheapest_closed(table, jump):
    count = table.shape[1]
    best = np.inf
    for start in range(count):
        totals = np.full(count, np.inf)
        totals[start] = table[0, start]
        for row in table[1:]:
            reach = [totals[max(0, i - jump) : i + jump + 1].min() for i in range(count)]
            totals = np.array(reach) + row
        best = min(best, totals[max(0, start - jump) : start + jump + 1].min())
    return best


# %%
assert cheapest_closed(np.ones((5, 4)), 1) == 5
slope = np.full((4, 6), 9.0)
slope[range(4), range(4)] = 0  # cheap, but it ends three columns from where it began
assert cheapest_closed(slope, 1) == 9
assert cheapest_closed(slope, 3) == 0
assert cheapest_closed(crossing[:, J:-J], J) <= cost_of_one_pass
print("the cut of one pass costs", cost_of_one_pass / cheapest_closed(crossing[:, J:-J], J))

# %% [markdown]
# ### Does it tile?
#
# Write `border(image)`: the mean absolute step between the last and the first column and between
# the last and the first row, over the mean absolute step between neighbours inside. Guess what it
# is for the exemplar and for a texture.


# %% tags=["hide-input"]
def border(image):
    picture = image.astype(float)
    inside = abs(np.diff(picture, axis=0)).mean() + abs(np.diff(picture, axis=1)).mean()
    across = abs(picture[0] - picture[-1]).mean() + abs(picture[:, 0] - picture[:, -1]).mean()
    return across / inside


# %%
ramp = np.tile(np.arange(0, 200, 10), (20, 1))
assert np.isclose(border(np.stack([ramp] * 3, axis=2)), 19)
torus = synthesize_texture(flowers, (200, 200), seed=1).image
assert border(torus) < 1.5 < border(flowers)
print(f"the exemplar {border(flowers):.1f}, the texture {border(torus):.1f}")
