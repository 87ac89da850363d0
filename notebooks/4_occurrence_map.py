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
# # 4. Wash-out and the occurrence map
#
# ![A sphere in crayon, and a dinosaur stylized with λ = 0, 10000 and 100000; below, their
# grain](pictures/4_occurrence_map.webp)
#
# Texture optimization takes the closest patches, and smooth patches are close to everything. So it
# uses few patches often and loses what makes a style rich: it washes out. The occurrence map
# counts how often each pixel of the style is used and makes what is used too often dearer. This
# notebook shows the wash-out and where patches come from, weighs one choice by hand, and puts λ on
# a slider (thesis 1.2, 2.1, 2.2 and 4.3).

# %% tags=["hide-input"]
from base64 import b64encode
from importlib.resources import files
from io import BytesIO

import matplotlib.pyplot as plt
import numpy as np
from IPython.display import HTML
from matplotlib.colors import LogNorm
from scipy.stats import entropy
from skimage.filters import gaussian

from stylit_ref import Params, passes, read_uint8, stylize
from stylit_ref.formulae.improve_assignment import phi
from stylit_ref.formulae.patch_penalization import omega_best
from stylit_ref.formulae.patch_similarity import delta
from stylit_ref.metric.packing import ONE, make_packing, occurrence_weight
from stylit_ref.passes import box_sum, count_assignments

DATA = files("data_gen") / "bundled"
GUIDES = "FULL", "LDE", "LSE", "LDDE", "LD12E"


def guides_of(scene, names=GUIDES):
    """Renderings of a bundled scene."""
    return [read_uint8(DATA / scene / f"{name}.png") for name in names]


style = read_uint8(DATA / "source/styles/crayon.png")
source_guides, target_guides = guides_of("source"), guides_of("stego")
images = style, source_guides, target_guides
[source_ids], [target_ids] = guides_of("source", ["IDMASK"]), guides_of("stego", ["IDMASK"])
WIDTH = 5
RADIUS = WIDTH // 2
SMALL = {"votes": 4, "patchmatch_iterations": 3}  # a third of the thesis' work, for each run
source_size, target_size = style.shape[:2], target_guides[0].shape[:2]
target_patches = target_size[0] * target_size[1]
best = omega_best(WIDTH, source_size[0] * source_size[1], target_patches)


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
    seen = place.imshow(image, **how)
    place.set_title(title, fontsize=9)
    place.axis("off")
    return seen


# %% [markdown]
# ## Wash-out
#
# λ is the weight of the occurrence map. We stylize with each λ of the thesis' tables (4.2); λ = 0
# does without the map.


# %% tags=["picture"]
def detail(image):
    """Fine detail of each pixel: its squared difference from a Gaussian blur, σ = 1."""
    blurred = gaussian(image.astype(float), 1, channel_axis=2, preserve_range=True)
    return ((image - blurred) ** 2).mean(axis=2)


def richness(image, style):
    return detail(image).mean() / detail(style).mean()


runs = {
    uniformity: stylize(*images, Params(uniformity=uniformity, **SMALL))
    for uniformity in (0, 5000, 10000, 15000, 50000, 100000)
}

on_sphere, on_body = np.s_[90:150, 105:195], np.s_[95:155, 85:175]
pictures = {"the style": (style, on_sphere)} | {
    f"λ = {uniformity}": (runs[uniformity].image, on_body) for uniformity in (0, 10000, 100000)
}
fig, axes = plt.subplots(2, 4, figsize=(12, 4.6), layout="constrained")
for column, (title, (image, part)) in enumerate(pictures.items()):
    show(axes[0, column], image, f"{title}: richness {richness(image, style):.2f}")
    show(axes[1, column], image[part], "in part", interpolation="nearest")
plt.show()

# %% [markdown]
# Crayon on grained paper leaves white grains, on the sphere as everywhere. With λ = 0 the body of
# the dinosaur has far fewer. Each patch went where its match is closest, and that is where the
# crayon is plain; as the picture becomes plain so do the closest patches. Larger λ bring the
# grains back. *Richness* puts a number to it: the fine detail of a picture over that of the style.
#
# ## Where patches come from
#
# The occurrence map Ω has for each pixel of the style the number of assigned patches that cover it
# (2.1):
#
# $$\Omega(x, y) = \left| \{ P \in \bar B : (x, y) \in \varkappa(\mathrm{NNF}(P)) \} \right|$$
#
# If all pixels were used alike, each would be used
# $\omega_{best} = w_Q^2 \, \frac{w_{\bar B} h_{\bar B}}{w_{\bar A} h_{\bar A}}$ times. The heat
# maps show Ω over ω_best, on a logarithmic scale; what no patch covers is black.

# %%
heat = plt.get_cmap("turbo").with_extremes(bad="black", under="black")
scale = LogNorm(1 / 16, 16)


def usage(omega):
    return np.ma.masked_equal(omega, 0) / best


def coverage(omega):
    """Share of the style's pixels that an assigned patch covers."""
    return (omega > 0).mean()


def distinct_patches(nnf):
    """Number of different source patches over the number of target patches."""
    return len(np.unique(nnf.reshape(-1, 2), axis=0)) / nnf[:, :, 0].size


fig, axes = plt.subplots(1, 3, figsize=(12, 3), layout="constrained")
show(axes[0], style, "the style")
for place, uniformity in zip(axes[1:], (0, 10000), strict=True):
    seen = show(place, usage(runs[uniformity].omega), f"λ = {uniformity}", cmap=heat, norm=scale)
fig.colorbar(seen, ax=axes, label="Ω / ω_best", shrink=0.9)
plt.show()

print(f"ω_best = {best:g}\n")
print("     λ   style covered   distinct patches   most used, Ω/ω_best")
for uniformity in (0, 10000):
    run = runs[uniformity]
    print(
        f"{uniformity:6}{coverage(run.omega):16.1%}{distinct_patches(run.nnf):19.1%}"
        f"{run.omega.max() / best:22.1f}"
    )

used, detailed = runs[0].omega / best, detail(style)
print("\nΩ/ω_best at λ = 0   share of the style   fine detail there")
for low, high in ((0, 0), (0, 1), (1, 2), (2, 4), (4, used.max())):
    there = (used > low) & (used <= high) if high else used == 0
    name = f"{low:.0f} to {high:.0f}" if high else "0"
    print(f"{name:>17}{there.mean():21.1%}{detailed[there].mean():20.0f}")

# %% [markdown]
# With λ = 0 a quarter of the style is black, and a few spots are dark red. The second table tells
# which: what is not used at all has several times the fine detail of what is used most. That is
# wash-out by numbers. With λ = 10000 little is black, and nothing is dark red.
#
# ## λ by hand
#
# A patch is penalized by how often its pixels are used, on average, against ω_best, and this is
# added to its dissimilarity with weight λ (2.1, 2.2):
#
# $$\rho(Q) = \frac{\omega(Q)}{\omega_{best}}, \qquad
# \omega(Q) = \frac{1}{w_Q^2} \sum_{(x, y) \in \varkappa(Q)} \Omega(x, y), \qquad
# \varphi(P, Q) = \lambda \rho(Q) + \delta(P, Q)$$
#
# For one target patch $P$ we work out δ and ρ of every source patch, with the picture and Ω of λ =
# 0 as they are, and ask which has the lowest φ. The search does the same for a few candidates.

# %%
packing = make_packing([3] * 5, 3, Params().guide_influence, [1.0] * 5)
washed = runs[0]
source = packing.pack(source_guides, style)
target = passes.repeat_edge(packing.pack(target_guides, washed.image), RADIUS)
omega_sums = box_sum(washed.omega, WIDTH)  # Ω summed over each patch

y, x = 120, 100  # on the body
inner = np.s_[RADIUS:-RADIUS, RADIUS:-RADIUS]
rho = (omega_sums / (WIDTH**2 * best))[inner]
deltas = np.array(
    [
        [
            delta(source, target, packing.weights, WIDTH, y, x, q_y, q_x) / ONE
            for q_x in range(RADIUS, source_size[1] - RADIUS)
        ]
        for q_y in range(RADIUS, source_size[0] - RADIUS)
    ]
)

print("     λ   chosen Q (y, x)        δ        ρ   φ = λρ + δ")
chosen = {}
for uniformity in runs:
    index = np.unravel_index(np.argmin(uniformity * rho + deltas), deltas.shape)
    chosen[uniformity] = index
    print(
        f"{uniformity:6}{index[0] + RADIUS:11}, {index[1] + RADIUS:3}{deltas[index]:11.0f}"
        f"{rho[index]:9.2f}{uniformity * rho[index] + deltas[index]:13.0f}"
    )

fig, axes = plt.subplots(1, 2, figsize=(11, 3.6), layout="constrained", width_ratios=(1.2, 1))
axes[0].plot(rho.ravel(), deltas.ravel(), ".", ms=2, color="grey")
ends = np.array([0, 6])
for n, (uniformity, index) in enumerate(chosen.items()):
    line = deltas[index] + uniformity * (rho[index] - ends)
    axes[0].plot(ends, line, color=f"C{n}", lw=0.7)
    axes[0].plot(rho[index], deltas[index], "o", ms=9 - n, color=f"C{n}", label=f"λ = {uniformity}")
    axes[1].plot(index[1] + RADIUS, index[0] + RADIUS, "o", ms=9 - n, color=f"C{n}")
axes[0].set(xlim=(-0.1, 6), ylim=(0, 20000), xlabel="ρ(Q)", ylabel="δ(P, Q)")
axes[0].set_title("every source patch Q, and the choice of each λ", fontsize=9)
axes[0].legend(fontsize=8)
show(axes[1], style, "where they are in the style")
plt.show()

# %% [markdown]
# Each grey dot is a source patch; down is closer to $P$, left is less used. On a line φ is
# constant; no dot lies below the line of the λ that chose. λ = 0 takes the lowest dot, however
# worn. The larger λ, the steeper the line, and the choice moves along the lower left edge of the
# cloud to patches that nobody has taken. λ is a price: so many units of δ for one ω_best of wear.
#
# But Ω changes with every choice. If all target patches argued like this at once, all would rush
# to the same unused places. So the search changes assignments in turns and keeps Ω up to date
# (`stylit_ref.stylization.schedules`).
#
# ## λ on a slider

# %% tags=["hide-input"]
fig, axes = plt.subplots(1, 2, figsize=(7, 2.7), dpi=72, layout="constrained")
painted = show(axes[0], runs[0].image, "")
heated = show(axes[1], usage(runs[0].omega), "Ω / ω_best", cmap=heat, norm=scale)
fig.colorbar(heated, ax=axes[1], shrink=0.8)


def drawn(uniformity, run):
    painted.set_data(run.image)
    heated.set_data(usage(run.omega))
    axes[0].set_title(f"λ = {uniformity}", fontsize=9)
    file = BytesIO()
    fig.savefig(file, format="webp")
    return file.getvalue()


pictures = [drawn(uniformity, run) for uniformity, run in runs.items()]
plt.close(fig)
slider(pictures)

# %% [markdown]
# ## What λ buys, and what it costs
#
# The table has for each λ how evenly the style is used (the entropy of Ω, 1 for perfectly even)
# and how rich the output is; and what that costs: δ, which grows as worse matches are taken, and
# the share of the target that is *spilled*, painted with the paint of another object.


# %%
def spilling(nnf):
    """Target patches whose source patch is centred on another object than they are."""
    return (source_ids[nnf[:, :, 0], nnf[:, :, 1]] != target_ids).any(axis=2)


table = {
    "style covered": [coverage(run.omega) for run in runs.values()],
    "distinct patches": [distinct_patches(run.nnf) for run in runs.values()],
    "entropy of Ω": [entropy(run.omega.ravel()) / np.log(run.omega.size) for run in runs.values()],
    "richness": [richness(run.image, style) for run in runs.values()],
    "mean δ": [run.history[-1].delta for run in runs.values()],
    "spilled": [spilling(run.nnf).mean() for run in runs.values()],
}
print(f"{'λ':18}" + "".join(f"{uniformity:>9}" for uniformity in runs))
for name, values in table.items():
    digits = 0 if name == "mean δ" else 3
    print(f"{name:18}" + "".join(f"{value:9.{digits}f}" for value in values))

fig, axes = plt.subplots(1, 4, figsize=(12, 2.6), layout="constrained")
shown = ("entropy of Ω", "richness", "mean δ", "spilled")
for place, name in zip(axes, shown, strict=True):
    place.plot([f"{uniformity // 1000}" for uniformity in runs], table[name], "o-")
    place.axvspan("5", "15", color="tab:green", alpha=0.2)
    place.set(title=name, xlabel="λ / 1000")
plt.show()

# %% [markdown]
# Evenness is won early: most of what entropy gains it has gained by λ = 15000. Richness goes on
# rising, and with it δ and the spilled share. The thesis found its best results from 5000 to 15000
# (4.3), the green band: most of the style is in use, and little is in the wrong place yet.
#
# ## Why not perfectly even?
#
# Because the target needs other things than the source has. Here is which parts of the style the
# *dinosaur* takes, by counting its assignments alone.

# %%
colour = target_ids[y, x]  # of the object that the patch above lies on
on_target = (target_ids == colour).all(axis=2)
on_source = (source_ids == colour).all(axis=2)
print(
    f"the object covers {on_source.mean():.1%} of the source and {on_target.mean():.1%} of the "
    f"target: {on_target.mean() / on_source.mean():.2f} times as much"
)

fig, axes = plt.subplots(1, 3, figsize=(12, 3), layout="constrained")
show(axes[0], on_target, "the object in the target", cmap="gray")
for place, uniformity in zip(axes[1:], (0, 100000), strict=True):
    nnf = np.where(on_target[:, :, None], runs[uniformity].nnf, -1)
    omega = box_sum(count_assignments(nnf, source_size), WIDTH)
    seen = show(place, usage(omega), f"used by the object, λ = {uniformity}", cmap=heat, norm=scale)
    outside, worn = omega[~on_source].sum() / omega.sum(), omega[on_source].mean() / best
    print(f"λ = {uniformity:6}: {outside:.1%} of what it takes lies outside the sphere; ", end="")
    print(f"on the sphere Ω is {worn:.2f} ω_best on average")
fig.colorbar(seen, ax=axes, label="Ω / ω_best", shrink=0.9)
plt.show()

# %% [markdown]
# The sphere is smaller than the dinosaur. If all of the style had to be used equally often, a good
# part of the dinosaur would get the paint of other things, as happens with methods that enforce
# even use (1.2). λ is a price, not a rule: even the largest λ lets the dinosaur use the sphere more
# than the rest, all of it evenly.
#
# ## Exercises
#
# Write a function of the same name in place of each solution, and unfold the solution only after
# yours passes the test below it.
#
# ### Ω by hand
#
# Write `occurrences(nnf, source_size)`: Ω of an NNF, for patches of width 5.


# %% tags=["hide-input"]
def occurrences(nnf, source_size):
    omega = np.zeros(source_size, int)
    for dy in range(-2, 3):
        for dx in range(-2, 3):
            np.add.at(omega, (nnf[:, :, 0] + dy, nnf[:, :, 1] + dx), 1)
    return omega


# %%
for run in runs.values():
    mine = occurrences(run.nnf, source_size)
    assert (mine == run.omega).all()
    assert np.isclose(mine.mean(), best), "ω_best is the mean of Ω, whatever the NNF"
print(f"{len(runs)} occurrence maps agree, and the mean of each is ω_best")

# %% [markdown]
# ### The penalization
#
# Write `mean_penalization(nnf, omega, uniformity)`: the mean of λρ over all target patches, which
# a run reports as `penalization` after each step. (`omega_best` is at hand as `best`.)


# %% tags=["hide-input"]
def mean_penalization(nnf, omega, uniformity):
    windows = np.lib.stride_tricks.sliding_window_view(omega, (5, 5))
    mean_omega = windows.mean(axis=(2, 3))[nnf[:, :, 0] - 2, nnf[:, :, 1] - 2]
    return uniformity * mean_omega.mean() / best


# %%
for uniformity, run in runs.items():
    mine = mean_penalization(run.nnf, run.omega, uniformity)
    assert np.isclose(mine, run.history[-1].penalization, rtol=1e-4), uniformity
    print(f"λ = {uniformity:6}: {mine:9.0f}")

# %% [markdown]
# ### The turning point
#
# Of two source patches one is closer, with $(\delta_1, \rho_1)$, and the other less used, with
# $(\delta_2, \rho_2)$. Write `turning_point(delta_1, rho_1, delta_2, rho_2)`: the λ at which the
# choice changes. The test asks the library's φ on both sides of it.


# %% tags=["hide-input"]
def turning_point(delta_1, rho_1, delta_2, rho_2):
    return (delta_2 - delta_1) / (rho_1 - rho_2)


# %%
def library_phi(uniformity, index):
    weight = occurrence_weight(uniformity, WIDTH, washed.omega.size, target_patches)
    q_y, q_x = index[0] + RADIUS, index[1] + RADIUS
    return phi(source, target, packing.weights, washed.omega, weight, WIDTH, y, x, q_y, q_x)


tested = 0
pairs = np.random.default_rng(0).integers(0, deltas.shape, (2000, 2, 2))
for first, second in pairs:
    a, b = sorted((tuple(first), tuple(second)), key=lambda index: deltas[index])
    if deltas[b] > 1.1 * deltas[a] and rho[a] > rho[b] + 0.1:
        turn = turning_point(deltas[a], rho[a], deltas[b], rho[b])
        assert library_phi(0.99 * turn, a) < library_phi(0.99 * turn, b)
        assert library_phi(1.01 * turn, a) > library_phi(1.01 * turn, b)
        tested += 1
assert tested > 100
print(f"{tested} pairs turn where they should")
