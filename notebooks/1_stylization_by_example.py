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
# # 1. Stylization by example
#
# ![A sphere, rendered and painted in oil; below, a golem, rendered and painted by the
# program](pictures/1_stylization_by_example.webp)
#
# An artist paints over the rendering of a plain sphere. A program looks at the rendering and the
# painting, and paints any other scene under the same light in the same manner. This notebook says
# what goes in and what comes out: the four pictures of the analogy (thesis, Introduction), the
# guides and the light paths they show (1.5), the nearest-neighbour field (2.1), and the weight of
# the guides, μ (3.2). The notebooks that follow explain how the result is found.

# %% tags=["hide-input"]
from dataclasses import replace
from importlib.resources import files

import matplotlib.pyplot as plt
import numpy as np
from scipy.spatial import cKDTree
from skimage.color import lab2rgb
from skimage.filters import gaussian

from stylit_ref import Params, read_uint8, replay, stylize
from stylit_ref.files.colour.bit_depth import to_linear, to_uint8

DATA = files("data_gen") / "bundled"
GUIDES = "FULL", "LDE", "LSE", "LDDE", "LD12E"


def guides_of(scene, names=GUIDES):
    """Renderings of a bundled scene."""
    return [read_uint8(DATA / scene / f"{name}.png") for name in names]


style = read_uint8(DATA / "source/styles/oil.png")
source_guides, target_guides = guides_of("source"), guides_of("golem")
rendered = target_guides[0]
[source_ids], [target_ids] = guides_of("source", ["IDMASK"]), guides_of("golem", ["IDMASK"])


def show(place, image, title):
    place.imshow(image)
    place.set_title(title, fontsize=9)
    place.axis("off")


# %% [markdown]
# ## Four pictures
#
# The problem has four pictures, written as an analogy:
#
# $$A : A' :: B : B'$$
#
# $A$ is a rendering of the source scene, $A'$ the artist's painting over it, pixel upon pixel. $B$
# is a rendering of the target scene. We want $B'$, which shows the target as $A'$ shows the
# source. Images are arrays of 8-bit values, and one call does it all. (`QUICK` does a
# third of the default's work, so that nothing takes long.)

# %% tags=["picture"]
QUICK = Params(votes=4, patchmatch_iterations=3)
result = stylize(style, source_guides, target_guides, QUICK, seed=0)

fig, axes = plt.subplots(2, 2, figsize=(7.4, 5.9), layout="constrained")
show(axes[0, 0], source_guides[0], "A: source, rendered")
show(axes[0, 1], style, "A': source, painted (the style)")
show(axes[1, 0], rendered, "B: target, rendered")
show(axes[1, 1], result.image, "B': target, painted (the output)")
plt.show()

# %% [markdown]
# Look at what was carried over. The orange of lit paint is on the shoulders and the purple of
# shaded paint between the legs; the strokes of the wall are on the wall and those of the ground on
# the ground. Nobody told the program what an arm or a wall is. It compared renderings.
#
# ## Guides and light paths
#
# One rendering says too little. A pixel may be bright because the lamp shines on it, because the
# lamp is mirrored in it, or because a bright wall is near; an artist paints these three
# differently. So the renderer hands out the light by the *path* it took from the lamp to the eye
# (thesis 1.5, figure I.3). In Heckbert's notation a path begins at the light, L, ends at the eye,
# E, and on its way is reflected diffusely, D, or specularly, S:
#
# | guide | light that |
# |---|---|
# | FULL | came on any path, L(D\|S)\*E |
# | LDE | one diffuse reflection sent to the eye: lit sides, cast shadows |
# | LSE | one specular reflection sent to the eye: highlights |
# | LDDE | two diffuse reflections sent: the glow between things |
# | LD12E | one or two diffuse reflections sent: LDE and LDDE together |
#
# Each of them is rendered for the source and for the target. Together they are the *guides*.

# %%
fig, axes = plt.subplots(2, 5, figsize=(12, 3.9), layout="constrained")
for column, name in enumerate(GUIDES):
    show(axes[0, column], source_guides[column], f"source, {name}")
    show(axes[1, column], target_guides[column], f"target, {name}")
plt.show()

# %% [markdown]
# Compare the columns. LSE is black but for the highlights: one on the sphere, many small ones on
# the golem. LDE is black where the lamp is hidden, under the sphere and in its cast shadow. LDDE
# turns the sphere round: it is bright below, where the white ground shines on it, and dark on top.
#
# ## Why one guide is not enough
#
# Guide weights let us switch guides off. Each of the $n_g$ guide channels weighs $\mu / n_g$ times
# the weight of its guide, so a weight of 5 on the first of five guides and 0 on the others gives
# FULL alone what all five have together.
#
# To judge the outcome we follow the paint back. `result.nnf` holds for every target pixel the
# source pixel it was assigned to. The renderer also knows which object each pixel shows; these
# colours were no guide, so they can be the judge. *Spilled* is what was painted with the paint of
# another object.

# %%
full_alone = stylize(
    style,
    source_guides,
    target_guides,
    replace(QUICK, guide_weights=(5, 0, 0, 0, 0)),
)


def carried(image, nnf):
    """What an image of the source shows at the source pixel of every target pixel."""
    return image[nnf[:, :, 0], nnf[:, :, 1]]


def spilling(nnf):
    """Target patches whose source patch is centred on another object than they are."""
    return (source_ids[nnf[:, :, 0], nnf[:, :, 1]] != target_ids).any(axis=2)


def guides_apart(nnf):
    """Mean difference of each guide from what the NNF carries to its place."""
    pairs = zip(source_guides, target_guides, strict=True)
    return [np.abs(carried(source, nnf).astype(int) - target).mean() for source, target in pairs]


fig, axes = plt.subplots(2, 2, figsize=(7.4, 5.9), layout="constrained")
print(f"{'':12}{'spilled':>9}" + "".join(f"{name:>8}" for name in GUIDES))
for row, (name, run) in enumerate({"five guides": result, "FULL alone": full_alone}.items()):
    spilled = spilling(run.nnf)
    apart = "".join(f"{each:8.2f}" for each in guides_apart(run.nnf))
    print(f"{name:12}{spilled.mean():9.1%}{apart}")
    show(axes[row, 0], run.image, name)
    show(axes[row, 1], np.where(spilled[:, :, None], [255, 60, 0], run.image // 2), "spilled")
plt.show()

# %% [markdown]
# The table says how far each guide of the target is from the source's guide at the assigned pixel,
# on average, in 8-bit steps. With FULL alone FULL matches better and the other four match worse.
# At the bottom left of the lower pictures the ground has the paint of the wall: both are grey
# there, and the metric compared nothing else. Even five guides do not tell every ground from every
# wall; a guide that names the objects would (thesis 5.2.4).
#
# ## What comes out: a nearest-neighbour field
#
# The output is made of the style's own patches, squares of $w \times w$ pixels, $w = 5$. Which
# patch goes where is the *nearest-neighbour field* (2.1):
#
# $$\mathrm{NNF}(P) = \arg\min_{Q \in \mathcal{N}_{\bar A}} \varphi(P, Q)$$
#
# For every patch $P$ of the target it names a patch $Q$ of the source, the closest by a metric
# $\varphi$. As a picture, each target pixel gets the colour that the key shows at its source
# pixel.


# %%
def nnf_colours(nnf, source_size):
    """Green to red from left to right, blue to yellow from top to bottom; all equally light."""
    down, along = np.moveaxis(nnf / np.array(source_size), 2, 0)
    return lab2rgb(np.stack([np.full_like(down, 70), 90 * along - 45, 90 * down - 45], axis=2))


height, width = style.shape[:2]
identity = np.stack(np.mgrid[:height, :width], axis=2)

fig, axes = plt.subplots(1, 3, figsize=(11, 3), layout="constrained")
show(axes[0], nnf_colours(identity, (height, width)), "key: the places of the source")
show(axes[1], nnf_colours(result.nnf, (height, width)), "NNF of the golem")
show(axes[2], style, "the style, for comparison")
plt.show()

# %% [markdown]
# Pieces of one smooth shade are pieces of the painting taken whole. The wall is put together from
# few large ones, the golem from many small ones: all of it comes from the sphere, whose shape it
# does not have.
#
# An NNF is independent of the paint. `replay` sends another image of the source through it: the
# style itself gives the output again, to the byte; another painting of the same sphere gives the
# golem in that paint; and the rendering of the sphere gives the rendering of the golem, as well as
# pieces of a sphere can.

# %%
again = replay(result.nnf, style)
print("the style again is the output:", np.array_equal(again, result.image))

fig, axes = plt.subplots(1, 3, figsize=(11, 3), layout="constrained")
watercolour = read_uint8(DATA / "source/styles/watercolour.png")
show(axes[0], replay(result.nnf, watercolour), "the watercolour sphere through the NNF")
show(axes[1], replay(result.nnf, source_guides[0]), "the rendered sphere through the NNF")
show(axes[2], rendered, "what it should be: B")
plt.show()

# %% [markdown]
# ## Guides against style: μ
#
# How alike two patches are is a sum of squared differences over guides and style (thesis 2.1, with
# the weights of 3.2):
#
# $$\delta(P, Q) = \frac{\mu}{n_g} \sum_{\text{guides}} (f^P - f^Q)^2
# + \frac{1}{n_s} \sum_{\text{style}} (f^P - f^Q)^2$$
#
# The guides' part asks whether the patch shows the right light. The style's part asks whether it
# fits the paint that is already there. $\mu$ decides between them; the thesis takes 2. What
# happens at the ends?


# %%
def detail(image):
    """Fine detail of each pixel: its squared difference from a Gaussian blur, σ = 1."""
    blurred = gaussian(image.astype(float), 1, channel_axis=2, preserve_range=True)
    return ((image - blurred) ** 2).mean(axis=2)


def richness(image, style):
    return detail(image).mean() / detail(style).mean()


fig, axes = plt.subplots(1, 3, figsize=(11, 3), layout="constrained")
for place, influence in zip(axes, (0, 2, 20), strict=True):
    run = stylize(style, source_guides, target_guides, replace(QUICK, guide_influence=influence))
    apart, rich = np.mean(guides_apart(run.nnf)), richness(run.image, style)
    show(place, run.image, f"μ = {influence}: guides {apart:.1f} apart, richness {rich:.2f}")
plt.show()

# %% [markdown]
# Without guides the painting goes on as it likes: strokes, a sphere, and no golem. With μ = 20 the
# guides match better, and highlights appear that μ = 2 left out, while whether a patch fits its
# neighbours counts for less. *Richness* is the fine detail of the output over that of the style.
#
# ## Exercises
#
# Each exercise is a task, a solution that is folded away, and a test. Write a function of the same
# name in place of the solution, and unfold the solution only after yours passes the test below it.
#
# ### Light adds up
#
# LD12E is said to be LDE and LDDE together. Light adds up, but the guides hold *display* values:
# the sRGB curve has been applied to the light. `to_linear` takes it off and `to_uint8` puts it on
# again. Write `together(lde, ldde)` for two 8-bit guides.


# %% tags=["hide-input"]
def together(lde, ldde):
    return to_uint8(to_linear(lde) + to_linear(ldde), curve="srgb")


# %%
guides = dict(zip(GUIDES, target_guides, strict=True))
off = np.abs(together(guides["LDE"], guides["LDDE"]).astype(int) - guides["LD12E"])
assert off.mean() < 0.5, "on average more than rounding to 8 bits explains"
assert off.max() <= 2, "some pixel is far off"
print(f"{off.mean():.2f} 8-bit steps off on average, {off.max()} at most")

# %% [markdown]
# ### Paint by lookup
#
# Patches are there for the strokes. To see what happens without them, give every target pixel the
# colour of the source pixel whose 15 guide values are closest, each pixel by itself. Write
# `lookup(source_guides, target_guides)`, which returns the NNF of it, (H, W, 2). `cKDTree` of
# SciPy finds nearest neighbours.


# %% tags=["hide-input"]
def lookup(source_guides, target_guides):
    source, target = (np.concatenate(guides, axis=2) for guides in (source_guides, target_guides))
    _, index = cKDTree(source.reshape(-1, source.shape[2])).query(target)
    return np.stack(np.unravel_index(index, source.shape[:2]), axis=2)


# %%
closest = lookup(source_guides, target_guides)


def squared_distances(nnf):
    pairs = zip(source_guides, target_guides, strict=True)
    return sum(((carried(a, nnf).astype(int) - b) ** 2).sum(axis=2) for a, b in pairs)


assert closest.shape == result.nnf.shape
assert (squared_distances(closest) <= squared_distances(result.nnf)).all(), "not the closest"

fig, axes = plt.subplots(1, 2, figsize=(7.4, 3), layout="constrained")
show(axes[0], carried(style, closest), "by lookup, pixel by pixel")
show(axes[1], result.image, "by patches")
plt.show()

# %% [markdown]
# No choice of pixels has closer guides. Where the target is lit as the source is, high on the
# wall, lookup copies whole strokes; on the golem and the ground it breaks them up, for a stroke is
# how a pixel goes with its neighbours. The next notebook looks for patches.
