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
# # 2. PatchMatch
#
# ![Three fields in the shape of a hand: after one iteration of each schedule, and after
# six](pictures/2_patchmatch.webp)
#
# For every patch of the target we want the closest patch of the source. Comparing all pairs is out
# of the question; PatchMatch guesses, and lets good guesses spread. This notebook watches it: one
# patch against all others, then a nearest-neighbour field from noise to order, commit by commit,
# with a slider. It covers thesis 1.3 and 2.4, and the parallel kernels of 3.3.

# %% tags=["hide-input"]
from base64 import b64encode
from dataclasses import replace
from importlib.resources import files
from io import BytesIO

import matplotlib.pyplot as plt
import numpy as np
from IPython.display import HTML
from scipy.spatial.distance import cdist
from skimage.color import lab2rgb
from skimage.util import view_as_windows

from stylit_ref import Params, passes, read_uint8, replay, stylize
from stylit_ref.formulae.candidates import propagation_candidate
from stylit_ref.formulae.patch_similarity import delta
from stylit_ref.machine.replaced import replaced
from stylit_ref.metric.packing import ONE
from stylit_ref.stylization import schedules
from stylit_ref.stylization.backends import Backend
from stylit_ref.stylization.problem import make_synthesis

DATA = files("data_gen") / "bundled"
GUIDES = "FULL", "LDE", "LSE", "LDDE", "LD12E"


def half(name):
    """A bundled image at 150x114, so that nothing takes long."""
    return passes.downsample(read_uint8(DATA / name))


style = half("source/styles/crayon.png")
source_guides = [half(f"source/{guide}.png") for guide in GUIDES]
target_guides = [half(f"hand/{guide}.png") for guide in GUIDES]
SEED = 1


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


def nnf_colours(nnf, source_size):
    """Green to red from left to right, blue to yellow from top to bottom; all equally light."""
    down, along = np.moveaxis(nnf / np.array(source_size), 2, 0)
    return lab2rgb(np.stack([np.full_like(down, 70), 90 * along - 45, 90 * down - 45], axis=2))


def show(place, image, title, **how):
    place.imshow(image, **how)
    place.set_title(title, fontsize=9)
    place.axis("off")


# %% [markdown]
# ## What is searched
#
# We take a finished picture $B'$ and ask where in the painting each of its patches has its closest
# likeness. Here that is the hand, stylized without an occurrence map (λ = 0; notebook 4 adds it),
# so that the metric is the patch similarity of thesis 2.1 alone:
#
# $$\varphi(P, Q) = \delta(P, Q) = \frac{\mu}{n_g} \sum_{\text{guides}} (f^P - f^Q)^2
# + \frac{1}{n_s} \sum_{\text{style}} (f^P - f^Q)^2$$
#
# A `Level` holds what a search needs: source and target with guides and style packed together, the
# NNF, and δ of every assignment. It is built here as the library builds it, with a random NNF.

# %%
params = Params(uniformity=0, levels=5)
finished = stylize(style, source_guides, target_guides, params).image


def random_level(passes=passes):
    """A level of the finished picture whose NNF is random."""
    one_level, backend = replace(params, levels=1), Backend(passes)
    synthesis = make_synthesis(
        style, source_guides, target_guides, one_level, seed=SEED, backend=backend
    )
    level = synthesis.begin_level(1)
    level.set_style(finished)
    level.update_moments()
    return level


level = random_level()
packing = level.packing
rows, columns = style.shape[:2]
radius = params.patch_width // 2
centres = (rows - 2 * radius) * (columns - 2 * radius)
print(f"{level.delta.size} target patches, {centres} source patches")
print(f"{level.delta.size * centres / 1e6:.0f} million pairs, 25 pixels of 18 channels each")

# %% [markdown]
# ## One patch against all
#
# For one target patch we can afford to compare all source patches. The map on the right has δ at
# every source centre, dark where the patches are alike.

# %%
y, x = 70, 76  # in the palm of the hand
landscape = np.full((rows, columns), np.nan)
for source_y in range(radius, rows - radius):
    for source_x in range(radius, columns - radius):
        landscape[source_y, source_x] = (
            delta(
                level.textures.source, level.textures.target, packing.weights,
                params.patch_width, y, x, source_y, source_x,
            )
            / ONE
        )  # fmt: skip
closest = np.unravel_index(np.nanargmin(landscape), landscape.shape)

fig, axes = plt.subplots(1, 3, figsize=(12, 3), layout="constrained")
show(axes[0], finished, "B' and the target patch P")
axes[0].plot(x, y, "s", color="lime", markerfacecolor="none", markersize=8)
show(axes[1], style, "the style and the patch closest to P")
axes[1].plot(*closest[::-1], "s", color="lime", markerfacecolor="none", markersize=8)
seen = axes[2].imshow(np.log10(landscape), cmap="magma")
axes[2].plot(*closest[::-1], "s", color="lime", markerfacecolor="none", markersize=8)
axes[2].set_title("log₁₀ δ(P, Q) for every source patch Q", fontsize=9)
axes[2].axis("off")
fig.colorbar(seen, ax=axes[2])
plt.show()

below = (landscape <= 2 * np.nanmin(landscape)).sum()
print(f"least δ {np.nanmin(landscape):.0f}, median {np.nanmedian(landscape):.0f}")
print(f"{below} of {centres} source patches have a δ of at most twice the least")

# %% [markdown]
# Two things make PatchMatch work. The map is smooth in the large: the sphere is dark, the wall is
# bright, so a candidate near a good one tends to be good. And the target has neighbours: if $P$
# goes to $Q$, the patch to the right of $P$ probably goes to the right of $Q$.
#
# ## The two halves of an iteration
#
# *Propagation* asks a neighbour at distance $d$ where it is assigned, and steps back (2.4, 3.3):
#
# $$Q_c = \mathrm{NNF}(P \odot (d; 0)) \odot (-d; 0)$$
#
# and likewise for the other three sides. *Random search* draws one candidate each from squares
# around the current assignment; their radii are 1, 2, 4, ... up to half the target's larger side.
# A candidate is taken where its φ is lower.
#
# In the thesis' CPU version (2.4) the patches take turns in scan-line order. On a GPU all patches
# go at once (3.3), so propagation is a kernel of its own, run with $d = 4$, then 2, then 1: a jump
# flood. The default schedule here, `propose_commit`, is that, made deterministic: a kernel only
# *proposes*, and a *commit* takes the proposals up. One iteration has four commits.
#
# ## Watching it
#
# The passes are an argument of everything that runs them. So we hand over passes whose `commit`
# also keeps a copy of the NNF. Nothing else is changed: this is the library's own search.

# %%
ITERATIONS = 6


def search(propagation=passes.propagation, random_search=passes.random_search):
    """NNF and mean δ before the first commit and after each."""
    frames = []

    def commit(nnf, delta, *others):
        passes.commit(nnf, delta, *others)
        frames.append((nnf.copy(), delta.mean() / ONE))

    watched = replaced(passes, commit=commit, propagation=propagation, random_search=random_search)
    level = random_level(watched)
    frames.append((level.nnf.copy(), level.delta.mean() / ONE))
    for iteration in range(1, ITERATIONS + 1):
        schedules.propose_commit(level, SEED, 1, 1, iteration)
    return frames


frames = search()
kernels = ("propagation 4", "propagation 2", "propagation 1", "random search")
titles = ["random"] + [
    f"iteration {n}, {kernel}" for n in range(1, ITERATIONS + 1) for kernel in kernels
]

# %% tags=["hide-input"]
chosen = [*range(9), 12, 16, 24]
fig, axes = plt.subplots(1, 2, figsize=(6.4, 2.8), dpi=72, layout="constrained")
for place in axes:
    place.axis("off")
source_size = style.shape[:2]
colours = axes[0].imshow(nnf_colours(frames[0][0], source_size), interpolation="nearest")
painted = axes[1].imshow(replay(frames[0][0], style), interpolation="nearest")
title = fig.suptitle("", fontsize=9)


def drawn(number):
    nnf, mean_delta = frames[number]
    colours.set_data(nnf_colours(nnf, source_size))
    painted.set_data(replay(nnf, style))
    title.set_text(f"{titles[number]}: mean δ {mean_delta:.0f}")
    file = BytesIO()
    fig.savefig(file, format="webp")
    return file.getvalue()


pictures = [drawn(number) for number in chosen]
plt.close(fig)
slider(pictures)

# %% [markdown]
# Move the slider. On the left is the NNF, in colours that name the place in the source (notebook 1
# has the key); on the right what the patches paint when their votes are averaged. At first all is
# noise, and the votes cancel out to brown. The first commit already shows the hand: each patch has
# seen five random guesses, its own and four neighbours', and one of five often has the right
# light. What comes late are the white grains of the crayon. They need neighbours that agree to the
# pixel: areas of one smooth shade, which grow with every iteration while their borders wander.
#
# ## How good is it?
#
# For a sample of target patches we can find the exact answer, by comparing each with every source
# patch. SciPy does so on the patches as vectors, each channel times the root of its weight.

# %%
sample = np.random.default_rng(0).choice(level.delta.size, 200, replace=False)
width = params.patch_width
scale = np.sqrt(packing.weights / ONE)
target_patches, source_patches = (
    view_as_windows(texture * scale, (width, width, packing.channels)).reshape(-1, width**2 * 32)
    for texture in (level.textures.target, level.textures.source)
)
exact = cdist(target_patches[sample], source_patches, "sqeuclidean").min(axis=1)


def sampled_delta(nnf):
    """δ of the sampled target patches."""
    level.nnf[:] = nnf
    level.update_similarity()
    return level.delta.ravel()[sample] / ONE


print(f"exact mean δ of the sample: {exact.mean():.0f}\n")
print("iteration   mean δ   over exact   within 10 % of exact")
for iteration in range(ITERATIONS + 1):
    found = sampled_delta(frames[4 * iteration][0])
    assert (found >= exact * (1 - 1e-4)).all()
    close = (found <= 1.1 * exact).mean()
    print(f"{iteration:9}{found.mean():9.0f}{found.mean() / exact.mean():13.3f}{close:23.0%}")

tried = ITERATIONS * (12 + (max(level.delta.shape) // 2).bit_length())
print(f"\nat most {tried} candidates a patch, of {centres}: {tried / centres:.2%}")

# %% [markdown]
# The field is approximate, and for most patches as good as exact, after a look at one source patch
# in a hundred. Mind the scale: δ falls most in the first iteration, the share of close patches
# rises most in the third, once coherent areas have formed.
#
# ## Both halves are needed
#
# What if one half proposes nothing? We put a pass in its place that offers each patch what it has.


# %%
def propose_nothing(textures, omega_sums, weight, patch_width, nnf, delta, new_nnf, new_delta, *_):
    new_nnf[:], new_delta[:] = nnf, delta


runs = {
    "both": frames,
    "propagation alone": search(random_search=propose_nothing),
    "random search alone": search(propagation=propose_nothing),
}

scanline = random_level()
scanline_deltas = [scanline.delta.mean() / ONE]
for iteration in range(1, ITERATIONS + 1):
    schedules.scanline(scanline, SEED, 1, 1, iteration)
    scanline_deltas.append(scanline.delta.mean() / ONE)

fig, place = plt.subplots(figsize=(7, 3.6), layout="constrained")
for name, run in runs.items():
    deltas = [mean_delta for _, mean_delta in run]
    place.plot(np.arange(len(deltas)) / 4, deltas, ".-", label=name)
place.plot(scanline_deltas, "s--", color="black", label="scan-line order (2.4)")
place.set(xlabel="iteration", ylabel="mean δ", yscale="log")
place.legend()
plt.show()
for name, run in runs.items():
    print(f"{name:20} {run[-1][1]:8.0f}")
print(f"{'scan-line order':20} {scanline_deltas[-1]:8.0f}")

# %% [markdown]
# Each dot is a commit. Propagation alone slows down once the best of the first guesses have
# spread: nothing new comes in. Random search alone goes on but slowly, since every patch must be
# lucky by itself. Together, what one patch finds all can use.
#
# Scan-line order is ahead for some iterations: a good assignment travels along the whole row in
# one of them, while the jump flood carries it 4 + 2 + 1 pixels. But its patches wait for each
# other, and in the end the two are level. See the fields after one iteration each:

# %% tags=["picture"]
one = random_level()
schedules.scanline(one, SEED, 1, 1, 1)

fig, axes = plt.subplots(1, 3, figsize=(11, 3), layout="constrained")
show(axes[0], nnf_colours(one.nnf, source_size), "after one scan-line iteration")
show(axes[1], nnf_colours(frames[4][0], source_size), "after one propose-and-commit iteration")
show(axes[2], nnf_colours(frames[-1][0], source_size), f"after {ITERATIONS} of these")
plt.show()

# %% [markdown]
# ## Exercises
#
# Write a function of the same name in place of each solution, and unfold the solution only after
# yours passes the test below it.
#
# ### δ by hand
#
# Write `similarity(guides, style, other_guides, other_style)` for two patches: lists of five guide
# patches, (5, 5, 3) uint8 each, and a style patch. μ is 2. Beware of differences of uint8.


# %% tags=["hide-input"]
def similarity(guides, style, other_guides, other_style):
    def squares(a, b):
        return ((a.astype(float) - b) ** 2).sum()

    channels = sum(guide.shape[2] for guide in guides)
    by_guides = sum(squares(a, b) for a, b in zip(guides, other_guides, strict=True))
    return 2 / channels * by_guides + squares(style, other_style) / style.shape[2]


# %%
def patch(image, y, x):
    return image[y - 2 : y + 3, x - 2 : x + 3]


level = random_level()
for y, x in np.random.default_rng(3).integers(2, [rows - 2, columns - 2], (50, 2)):
    q_y, q_x = level.nnf[y, x]
    mine = similarity(
        [patch(guide, y, x) for guide in target_guides], patch(finished, y, x),
        [patch(guide, q_y, q_x) for guide in source_guides], patch(style, q_y, q_x),
    )  # fmt: skip
    assert np.isclose(mine, level.delta[y, x] / ONE, rtol=1e-3), (y, x)
print("50 patches agree")

# %% [markdown]
# ### A step of propagation
#
# Write `candidate(nnf, y, x, dy, dx, source_size)`: what the neighbour at offset `(dy, dx)` of
# `(y, x)` proposes, as a source centre `(y, x)`. A centre stays two pixels away from the source's
# border; what would leave is moved to the nearest that is allowed.


# %% tags=["hide-input"]
def candidate(nnf, y, x, dy, dx, source_size):
    shifted = nnf[y + dy, x + dx] - (dy, dx)
    return tuple(np.clip(shifted, 2, np.array(source_size) - 3))


# %%
rng = np.random.default_rng(5)
clamped = 0
for _ in range(2000):
    y, x = rng.integers(4, [rows - 4, columns - 4])
    dy, dx = ((0, 4), (2, 0), (0, -1), (-4, 0))[rng.integers(4)]
    expected = propagation_candidate(*level.nnf[y + dy, x + dx], dy, dx, radius, rows, columns)
    assert candidate(level.nnf, y, x, dy, dx, (rows, columns)) == expected, (y, x, dy, dx)
    clamped += expected != tuple(level.nnf[y + dy, x + dx] - (dy, dx))
assert clamped > 0
print(f"2000 candidates agree, {clamped} of them moved back into the source")

# %% [markdown]
# ### Coherence
#
# Write `coherence(nnf)`: the share of target pixels whose neighbour to the right is assigned one
# pixel further to the right in the source as well, over all pixels that have one. Guess first what
# it is in the random field and in the last.


# %% tags=["hide-input"]
def coherence(nnf):
    steps = nnf[:, 1:] - nnf[:, :-1]
    return (steps == (0, 1)).all(axis=2).mean()


# %%
whole = np.stack(np.mgrid[:rows, :columns], axis=2)
assert coherence(whole) == 1
assert coherence(whole[:, ::-1]) == 0
torn = np.where(np.arange(columns)[:, None] < 50, whole, 9)
assert np.isclose(coherence(torn), 49 / (columns - 1))
shares = [coherence(nnf) for nnf, _ in frames[::4]]
assert shares[0] < 0.01 < 0.3 < shares[-1]
print("coherent after each iteration:", " ".join(f"{share:.0%}" for share in shares))
