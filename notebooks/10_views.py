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
# # 10. Views: a drawing that turns
#
# ![A drawn house between four views: blended, pictures shifted, NNFs shifted, and
# searched](pictures/10_views.webp)
#
# An architect draws over one rendering of a house, and the drawing is carried over to nine other
# views of it. Each of the nine is good. Why does the house boil as soon as it turns? And what do
# you show *between* two views, when a drawing takes a second and a screen wants sixty of them?
#
# This notebook answers with chapter 3 of Hauptfleisch (2020): it shifts pictures along the motion
# of the scene (3.2.1), lets views pull at each other while they are drawn (equation 3.1 and
# 3.2.2), and then makes pictures of places that nobody has drawn, from images and from
# nearest-neighbour fields (3.3).

# %% tags=["hide-input"]
from base64 import b64encode
from importlib.resources import files
from io import BytesIO
from tempfile import TemporaryDirectory

import matplotlib.pyplot as plt
import numpy as np
from IPython.display import HTML
from PIL import Image
from skimage.filters import gaussian

from stylit_ref import (
    ArrayShot,
    Coherence,
    Params,
    grid_pairs,
    read_motion,
    read_uint8,
    stylize_views,
    to_uint8,
    views_of_run,
)
from stylit_ref.views import passes
from stylit_ref.views.problem import make_problem
from stylit_ref.views.run_writer import RunWriter

HOUSE = files("data_gen") / "bundled" / "house"
NAMES = [f"{row}_{column}" for row in range(3) for column in range(3)]
GUIDES = "FULL", "LDE", "LDDE", "LSE", "LIGHTMASK", "WIREFRAME"


def slider(files):
    """Pictures of bytes, of which a slider shows one; it works without a network."""
    pictures = "".join(
        f'<img alt="picture {number}" style="display: {"none" if number else "block"}" '
        f'src="data:image/webp;base64,{b64encode(file).decode()}">'
        for number, file in enumerate(files)
    )
    choose = (
        "for (const [n, picture] of [...this.parentNode.querySelectorAll('img')].entries()) "
        "picture.style.display = n == this.value ? 'block' : 'none'"
    )
    return HTML(
        f'<div><input type="range" value="0" max="{len(files) - 1}" style="width: min(30em, 100%)" '
        f'aria-label="which picture" oninput="{choose}">{pictures}</div>'
    )


def show(place, image, title, **how):
    place.imshow(image, **how)
    place.set_title(title, fontsize=9)
    place.axis("off")


# %% [markdown]
# ## One drawing, nine views
#
# The views stand in a grid on a sphere around the house, five degrees apart (figure 3.1). Each has
# six guides: four kinds of light, a mask of light and shadow, and the wireframe, which keeps lines
# where they belong (2.4.1). Our architect is a few lines of Python: ink along the wires, a wash of
# the colours, hatching in the shade, all with an unsteady hand. The drawing is over one corner of
# the grid.

# %%
guides = [[read_uint8(HOUSE / name / f"{guide}.png") for guide in GUIDES] for name in NAMES]
height, width = guides[0][0].shape[:2]


def draw_over(view, seed=1):
    """A drawing over a rendering."""
    full, lde, wires = (view[GUIDES.index(name)] / 255 for name in ("FULL", "LDE", "WIREFRAME"))
    noise = np.random.default_rng(seed).normal(size=(3, height, width))
    grain, wobble = gaussian(noise[0], 1), 14 * gaussian(noise[1:], (0, 4, 4))
    rows, columns = (np.mgrid[:height, :width] + wobble).round().astype(int)
    hand = np.clip(rows, 0, height - 1), np.clip(columns, 0, width - 1)

    shade = np.where(lde.any(axis=2), 0.7 - 2.2 * gaussian(lde.mean(axis=2), 1), 0)[hand]
    hatching = np.cos((rows + columns + wobble[0]) * np.pi / 3) / 2 + 0.5 < shade
    wires = wires.squeeze()[hand]
    ink = np.clip(0.7 * gaussian(hatching.astype(float), 0.6) + 1.6 * gaussian(wires, 0.5), 0, 1)
    colours = np.where(lde.any(axis=2, keepdims=True), gaussian(full, 1.5, channel_axis=2), 1)
    wash = 1 - 0.7 * (1 - colours) * (1 + 0.5 * grain[:, :, None])
    return to_uint8(np.clip(wash * (1 - 0.85 * ink[:, :, None]), 0, 1), curve="none")


drawing = draw_over(guides[0])

fig, axes = plt.subplots(3, 4, figsize=(12, 7), layout="constrained", width_ratios=(1.4, 1, 1, 1))
for place in axes[:, 0]:
    place.axis("off")
show(axes[1, 0], drawing, "the drawing, over view 0_0")
for row in range(3):
    for column in range(3):
        number = 3 * row + column
        show(axes[2 - row, column + 1], guides[number][0], f"view {NAMES[number]}")
plt.show()

# %% [markdown]
# ## Where a point has gone
#
# A renderer knows for each pixel of a view where its point is in a neighbouring view: the *motion
# field*. We keep it with the view that a picture is shifted *to*. So a pixel adds its vector to its
# own place, and takes the colour that it finds there; none is left without, and none is hit twice.
# Where the neighbour does not show the point (it is hidden there, or outside) the pixel is masked,
# as in figure 3.2.

# %%
PAIRS = list(grid_pairs(3, 3))
motion = {
    (to, other): read_motion(HOUSE / f"motion/{NAMES[to]}_to_{NAMES[other]}.exr").forward
    for to, other in PAIRS
}
y, x = np.mgrid[:height, :width]


def shifted(picture, motion):
    """A neighbour's picture, shifted; and which pixels the neighbour shows."""
    rows = np.floor(y + motion.field[:, :, 1] + 0.5).astype(int)
    columns = np.floor(x + motion.field[:, :, 0] + 0.5).astype(int)
    inside = (rows >= 0) & (rows < height) & (columns >= 0) & (columns < width)
    known = motion.visible & inside
    return picture[rows * known, columns * known], known


to, other = 4, 3  # the middle of the grid, and the view to its left
came, known = shifted(guides[other][0], motion[to, other])
pixels = np.hypot(*np.moveaxis(motion[to, other].field, 2, 0))

fig, axes = plt.subplots(1, 4, figsize=(13, 2.7), layout="constrained")
show(axes[0], guides[other][0], f"view {NAMES[other]}")
show(axes[1], np.where(known[:, :, None], came, 0), f"shifted to {NAMES[to]}; masked: black")
show(axes[2], guides[to][0], f"view {NAMES[to]}")
show(axes[3], np.where(known, pixels, np.nan), "length of the vectors in pixels", cmap="magma")
fig.colorbar(axes[3].images[0], ax=axes[3])
plt.show()

# %% [markdown]
# Left and right of the chimney and along the porch is what only one of the two views sees. The rest
# fits so well that it is hard to tell the second picture from the third. So a number: how much do
# points change that two neighbours both show? For the renderings this is small, and the little
# that is left are lights that wander, and half pixels. It is the floor that no drawing can go below
# by much.


# %%
def change(pictures):
    """Mean difference of neighbours, one shifted to the other, in 8-bit steps."""
    apart = []
    for (to, other), field in motion.items():
        came, known = shifted(pictures[other], field)
        apart.append(np.abs(came.astype(int) - pictures[to])[known].mean())
    return np.mean(apart)


print(f"renderings change by {change([view[0] for view in guides]):.2f}")

# %% [markdown]
# ## Every view for itself
#
# First without any coherence: nine runs that know nothing of each other.

# %%
PARAMS = Params.preset("fast")


def draw_all(weight):
    """All views, and what shows places between them."""
    shot, coherence = ArrayShot(guides, motion, NAMES), Coherence(weight=weight)
    problem = make_problem(drawing, guides[0], shot, PARAMS, coherence)
    drawn = {}
    with TemporaryDirectory() as folder:
        writer = RunWriter(folder, problem, grid=(3, 3))
        for result in stylize_views(drawing, guides[0], shot, PARAMS, coherence):
            writer.add(result)
            drawn[result.frame] = result
        return [drawn[frame] for frame in range(9)], views_of_run(writer.finish())


def pictures_of(drawn):
    return [result.image for result in drawn]


def difference(pictures, to, other):
    """Four times what changes between two neighbours; grey is not known."""
    came, known = shifted(pictures[other], motion[to, other])
    apart = np.abs(came.astype(int) - pictures[to]).mean(axis=2)
    return np.where(known, 255 - np.minimum(4 * apart, 255), 128)


alone, between_alone = draw_all(0)

fig, axes = plt.subplots(1, 3, figsize=(12, 3.1), layout="constrained")
show(axes[0], alone[3].image, "view 1_0")
show(axes[1], alone[4].image, "view 1_1")
show(axes[2], difference(pictures_of(alone), 4, 3), "what changes", cmap="gray", vmin=0, vmax=255)
plt.show()
print(f"the drawings change by {change(pictures_of(alone)):.2f}")

# %% [markdown]
# Both pictures are fine, and hardly a stroke of one is in the other: each search found patches of
# equal quality, but other ones. On still pictures nobody minds. In motion the eye sees nothing
# else.
#
# ## Views that pull at each other
#
# Equation 3.1 adds a term to the patch error. Let $G_c$ be the picture of the neighbour $c$,
# shifted to this view; then
#
# $$E_c(p, q) = \|A'(p) - B'(q)\|^2
# + \sum_{g} \lambda_g \|G_g^S(p) - G_g^T(q)\|^2
# + \sum_{c} \lambda_c \|A'(p) - G_c(q)\|^2 .$$
#
# The new term says: be like what your neighbours show here. It looks like a lot to compute: four
# neighbours are four pictures to compare with. But all of them are compared with the same $A'(p)$,
# and squares around several values are squares around their mean and a rest:
#
# $$(a - b)^2 + \sum_c \lambda_c (a - g_c)^2
# = \Bigl(1 + \sum_c \lambda_c\Bigr) \bigl((a - M)^2 + S\bigr), \qquad
# M = \frac{b + \sum_c \lambda_c g_c}{1 + \sum_c \lambda_c} .$$
#
# $S$, the spread of $b$ and the $g_c$, does not depend on the patch $p$ that is looked for. So the
# search goes on as ever, with $M$ in the place of $B'$. In numbers:

# %%
a, b, g, weights = 90.0, 120.0, np.array([60.0, 75.0, 110.0]), np.array([0.5, 1.0, 2.0])
total = 1 + weights.sum()
mean = (b + weights @ g) / total
spread = (b**2 + weights @ g**2) / total - mean**2
left = (a - b) ** 2 + weights @ (a - g) ** 2
print(f"M = {mean:.1f}, S = {spread:.1f}: {left:.1f} = {total * ((a - mean) ** 2 + spread):.1f}")
assert np.isclose(left, total * ((a - mean) ** 2 + spread))

# %% [markdown]
# In which order are views drawn? Frames of a film come one after the other, each pulled by the one
# before. A grid has no first view. Its energy is that of all views together (equation 3.2),
#
# $$E_M = \sum_{T} \sum_{q \in T} E_c(p_q, q),$$
#
# so all of them take one search-vote iteration, exchange their pictures, and take the next (3.2.2):
# *intermediate shifting*. Let us see what different $\lambda_c$ do. Beside the change we look at
# the mean gradient of the pictures, for blur does not change either.


# %%
def gradient(pictures):
    return np.mean([np.abs(np.diff(image.astype(int), axis=1)).mean() for image in pictures])


runs = {0: (alone, between_alone)} | {weight: draw_all(weight) for weight in (0.5, 2)}
print("λ_c   change   of alone   gradient")
for weight, (drawn, _) in runs.items():
    found = change(pictures_of(drawn))
    share = found / change(pictures_of(alone))
    print(f"{weight:3}{found:9.2f}{share:11.2f}{gradient(pictures_of(drawn)):11.2f}")

coherent, between = runs[2]
assert change(pictures_of(coherent)) < 0.7 * change(pictures_of(alone))

fig, axes = plt.subplots(1, 3, figsize=(12, 3.1), layout="constrained")
show(axes[0], coherent[3].image, "view 1_0, λ_c = 2")
show(axes[1], coherent[4].image, "view 1_1, λ_c = 2")
show(
    axes[2], difference(pictures_of(coherent), 4, 3), "what changes", cmap="gray", vmin=0, vmax=255
)
plt.show()

# %% [markdown]
# The change is halved, and the hatching of one picture is now that of the other. The chimney, which
# view 1_0 alone had painted with the ground, is a chimney again: its neighbours knew better. The
# price is in the last column. $M$ is a mean of pictures that do not quite agree, and patches that
# fit a mean are a little smoother. A weight of 0.5 already has most of the gain.
#
# ## Between two views
#
# Now the client turns the model, to a place where nobody has drawn. The four views around it are
# known, and so is the motion from the place to each of them (figure 3.4). There are several ways
# (3.3):
#
# - *linear*: blend the four pictures, each by how near it is;
# - *image*: shift the picture of the closest view; what it does not show comes from the next ones;
# - *nnf*: shift not colours but coordinates, the nearest-neighbour fields, and vote;
# - *limited*: the same, and then let every pixel choose once among the shifted patches.
#
# Which entry a pixel of the new field takes says equation 3.3,
#
# $$\mathrm{NNF}_c(p) = \mathrm{NNF}_g(p - V^g(p)),$$
#
# with $g$ the closest view of the grid in which $p$ is not masked, and $V^g$ the motion from there.
# (Our motion leads the other way, so ours has a plus.) We stand half a step to the right of the
# middle of the grid, and a little above it.

# %% tags=["picture"]
place = 0.5, 0.4
modes = {
    "linear": "blended",
    "image": "pictures shifted",
    "nnf": "NNFs shifted, vote",
    "limited": "and a limited search",
}
fig, axes = plt.subplots(2, 4, figsize=(13, 5.6), layout="constrained")
for column, (mode, title) in enumerate(modes.items()):
    picture = between.picture(place, mode)
    show(axes[0, column], picture, f"{title}: gradient {gradient([picture]):.1f}")
    show(axes[1, column], picture[90:180, 130:230], "in part", interpolation="nearest")
plt.show()
print(f"gradient of the drawn views around: {gradient(pictures_of(coherent)[4:]):.1f}")

# %% [markdown]
# Blended, four houses lie over each other. Shifted pictures are as crisp as what they are shifted
# from, too crisp: look at the right edge of the gable, where pixels of three views stand side by
# side, each cut off where its view ends, and at the crumbs of outline in the sky. That is a model
# with a sketch for its texture.
#
# An NNF knows more than a colour: it knows what was around that colour in the drawing. After the
# shift all 25 patches over a pixel vote, so one patch repairs what its neighbours tore. The limited
# search finds, among the four patches at hand, one that agrees with the vote around it, and by that
# gives back some of the sharpness that the vote took. It looks at the style alone: there are no
# guides at a place that nobody has rendered.
#
# ## Where the closest view changes
#
# All these ways but the first jump where another view becomes the closest. How far they jump is
# decided by how alike the views were drawn (figure 3.7). We take the place just before the middle
# between two views and just behind it.

# %%
before, behind = (0.49, 0.0), (0.51, 0.0)


def jump(views, mode):
    one, other = (views.picture(place, mode).astype(int) for place in (before, behind))
    return np.abs(one - other).mean(axis=2)


jumps = {
    "each for itself": jump(between_alone, "limited"),
    "λ_c = 2": jump(between, "limited"),
    "λ_c = 2, with a fade": jump(between, "fade"),
}
assert list(jumps) == sorted(jumps, key=lambda title: -jumps[title].mean())

fig, axes = plt.subplots(1, 3, figsize=(12, 3.1), layout="constrained")
for place, (title, apart) in zip(axes, jumps.items(), strict=True):
    show(place, 255 - 4 * apart, f"{title}: {apart.mean():.1f}", cmap="gray", vmin=0, vmax=255)
plt.show()

# %% [markdown]
# What is left of the jump is spread by a *fade*: around the middle both views lead, and the two
# pictures are mixed. The thesis does without; it is the default here. Turn the house yourself: on
# the left nine drawings that know nothing of each other, on the right nine that do.

# %% tags=["hide-input"]
frames = []
for step in np.linspace(-1, 1, 17):
    halves = [views.picture((step, 0.2), "fade") for views in (between_alone, between)]
    file = BytesIO()
    Image.fromarray(np.hstack(halves)).save(file, "webp", quality=80)
    frames.append(file.getvalue())
slider(frames)

# %% [markdown]
# The library moves by the mesh of a scene, or by passes of positions, where it has them; here it
# had nothing but the motion between neighbours. `stylit-ref view` and `stylit-ref viewer` do all
# this on files, and the second makes a page that turns the model in a browser.
#
# ## Exercises
#
# Write a function of the same name in place of each solution, and unfold the solution only after
# yours passes the test below it.
#
# ### Fold
#
# Write `folded(own, shifted, weight)`: $M$ of a picture, (H, W, 3) uint8, and a list of shifted
# pictures that all have the weight $\lambda_c$ = `weight`. The library rounds half up.


# %% tags=["hide-input"]
def folded(own, shifted, weight):
    total = own + weight * np.sum(shifted, axis=0, dtype=float)
    return np.floor(total / (1 + weight * len(shifted)) + 0.5).astype(np.uint8)


# %%
own = coherent[4].image
came = [shifted(coherent[other].image, motion[4, other]) for other in (1, 3, 5, 7)]
pulls = [np.where(known[:, :, None], picture, own) for picture, known in came]
for weight in (0.25, 0.5, 2):
    mixed, spreads = np.empty_like(own), np.empty_like(own[:, :, :1])
    passes.fold(own, np.array(pulls), np.full(4, int(256 * weight)), mixed, spreads)
    assert (folded(own, pulls, weight) == mixed).all(), weight
print("three weights agree, to the byte")

# %% [markdown]
# ### The weights of four views
#
# Write `weights(right, up)`: how much each of the four views around a place counts in a linear
# blend, as a dictionary from `(row, column)` to a share. The middle of the grid, row 1 and column
# 1, is the place (0, 0), and views are one step apart; the place lies in the cell to the right of
# the middle and above it.


# %% tags=["hide-input"]
def weights(right, up):
    return {
        (1, 1): (1 - right) * (1 - up),
        (1, 2): right * (1 - up),
        (2, 1): (1 - right) * up,
        (2, 2): right * up,
    }


# %%
for right, up in np.random.default_rng(0).random((100, 2)):
    mine, around = weights(right, up), between.grid.around((right, up), 0)
    assert np.isclose(sum(mine.values()), 1)
    for view, share in zip(around.views, around.linear, strict=True):
        assert abs(mine[divmod(view, 3)] - share / 65536) < 0.005, (right, up, view)
    assert max(mine, key=mine.get) == divmod(around.views[0], 3), "the closest counts most"
print("100 places agree")

# %% [markdown]
# ### Equation 3.3
#
# Write `chosen(candidates)`: the NNF of the new place, (H, W, 2), from the four shifted ones,
# (4, H, W, 2), of which the closest comes first. Masked entries are (-1, -1). Where all four are
# masked, leave (-1, -1).


# %% tags=["hide-input"]
def chosen(candidates):
    first = (candidates[..., 0] >= 0).argmax(axis=0)
    return np.take_along_axis(candidates, first[None, :, :, None], axis=0)[0]


# %%
def unpacked(entries):
    """(y, x) of entries that hold both in 32 bits."""
    return np.where(entries[..., None] < 0, -1, np.stack([entries >> 16, entries & 65535], axis=-1))


for place in ((0.5, 0.4), (-0.3, 0.2), (-0.6, -0.9)):
    packed, nnf = between.fetch(between.shift(place))
    masked = packed < 0
    nowhere = masked.all(axis=0)
    mine = chosen(unpacked(packed))
    assert (mine[~nowhere] == unpacked(nnf)[~nowhere]).all()
    assert (mine[nowhere] == -1).all()
    print(f"{place}: {masked[0].mean():.0%} of the closest view is masked, all four at ", end="")
    print(f"{nowhere.mean():.0%} of the pixels")
