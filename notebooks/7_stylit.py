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
# # 7. StyLit: the style looks for its place
#
# ![A teapot by λ = 0, by λ = 10000 and by StyLit; below, how often the style was
# used](pictures/7_stylit.webp)
#
# Everything so far searched from target to source: each target patch takes the source patch it
# likes best, and an occurrence map keeps them from liking the same ones. StyLit (Fišer et al.
# 2016; thesis 1.5) turns the question round. Each patch of the *style* looks for its place in the
# target, so that all of the style gets used. Some patches have no place there, and an *error
# budget* keeps those out.
#
# You will see the errors of one such retrieval, the hyperbola fitted to them and its knee; how
# retrieval after retrieval fills the target; and the picture beside those of the occurrence map.
# The formulas are told in Hauptfleisch 2020, sections 2.3 and 2.4; `docs/methods.md` lists what
# they leave open and what this library does there.

# %% tags=["hide-input"]
from importlib.resources import files

import matplotlib.pyplot as plt
import numpy as np
from skimage.filters import gaussian

from stylit_ref import Params, passes, read_uint8, stylize
from stylit_ref.formulae.patch_penalization import omega_best
from stylit_ref.metric.packing import ONE
from stylit_ref.passes.claims import FIXED
from stylit_ref.randomness.random_stream import RETRIEVAL_NNF, RETRIEVAL_SEARCH, random_stream
from stylit_ref.stylization.error_budget import (
    SAMPLES,
    correspondences_within_budget,
    fit_hyperbola,
    knee,
)
from stylit_ref.stylization.problem import make_synthesis
from stylit_ref.stylization.schedules import propose_commit
from stylit_ref.stylization.stylit import Retrieval

DATA = files("data_gen") / "bundled"
GUIDES = "FULL", "LDE", "LSE", "LDDE", "LD12E"


def half(name):
    """A bundled image at 150x114."""
    return passes.downsample(read_uint8(DATA / name))


style = half("source/styles/oil.png")
source_guides = [half(f"source/{guide}.png") for guide in GUIDES]
target_guides = [half(f"teapot/{guide}.png") for guide in GUIDES]
height, width = target_guides[0].shape[:2]


def run(**values):
    """Stylize the teapot; kept small, as all runs in this notebook."""
    params = Params(levels=5, votes=4, patchmatch_iterations=4, **values)
    return stylize(style, source_guides, target_guides, params)


washed_out = run(uniformity=0)

# %% [markdown]
# ## One retrieval
#
# We take a level as a run has it before a search: a picture, voted from an earlier field.
# StyLit's search begins from target to source, as the others do, but at $\lambda = 0$. Its errors
# $E_{best}$ say how well each target patch could be served.
#
# Then comes the *retrieval*. The library's `Retrieval` is PatchMatch with source and target in
# each other's place: for every source patch $p$ it finds
#
# $$E(p) = \min_q\, \delta(q, p)$$
#
# over all target patches $q$ that are still free. At first all of them are.


# %%
def start():
    """The finest level with the picture of λ = 0, searched from target to source."""
    params = Params(method="stylit", levels=1)
    level = make_synthesis(style, source_guides, target_guides, params).begin_level(1)
    level.nnf[:] = washed_out.nnf
    level.vote()
    level.init_occurrence_map()
    level.update_moments()
    for iteration in range(1, 5):
        propose_commit(level, seed=1, level_number=1, vote=1, iteration=iteration)
    return level


def improve(retrieval, number):
    """Four PatchMatch iterations from source to target, as between two settlements."""
    for iteration in range(4 * number + 1, 4 * number + 5):
        retrieval.improve(random_stream(0, RETRIEVAL_SEARCH, 1, 1, iteration))


level = start()
retrieval = Retrieval(level, random_stream(0, RETRIEVAL_NNF, 1, 1))
improve(retrieval, 0)

fig, axes = plt.subplots(1, 3, figsize=(12, 3.2), layout="constrained")
axes[0].imshow(style)
axes[0].set_title("style")
axes[1].imshow(level.style)
axes[1].set_title("picture before this search")
errors = axes[2].imshow(
    retrieval.errors / ONE, cmap="magma", vmax=np.percentile(retrieval.errors, 98) / ONE
)
axes[2].set_title("E(p) of each source patch")
fig.colorbar(errors, ax=axes[2])
for ax in axes:
    ax.axis("off")

# %% [markdown]
# The right picture lies over the style, pixel by pixel. A patch is bright if even its closest
# target patch is far from it. The white highlight is the brightest: the picture in the middle has
# lost it, so there is nothing white to go to. Then comes the outline of the sphere, which curves
# and shades as no outline of the teapot does. Most of wall and floor has found its like.

# %% [markdown]
# ## Budget and knee
#
# Sorted, the errors resemble a hyperbola: many small ones, then a steep end. One is fitted, and
# beyond its *knee*, where its slope is 1, correspondences are probably wrong (Hauptfleisch
# 2.3.1):
#
# $$f(x) = \frac{1}{a - b x} \qquad f'(x_k) = 1$$
#
# A slope needs units. Here $x$ runs from 0 at the smallest error to 1 at the largest, and $f$ is
# measured in units of $f(1)$; then $a - b x_k = \sqrt{b\,(a - b)}$. The *budget* is the sum of
# the errors up to the knee,
#
# $$T = \sum_{i \le x_k n} E_i,$$
#
# and as many correspondences are kept as fit into it, those of the smallest errors (2.5).


# %%
def budget_of(errors):
    """The library's fit of sorted errors: a, b, the knee, and the unit of f."""
    places = np.linspace(0, len(errors) - 1, min(SAMPLES, len(errors))).astype(int)
    middle = np.median(errors)
    a, b = fit_hyperbola(places / (len(errors) - 1), errors[places] / middle)
    return a, b, knee(a, b), middle / (a - b)


errors = np.sort(retrieval.errors, axis=None)
a, b, x_k, unit = budget_of(errors)
kept = correspondences_within_budget(errors, "hyperbola")
assert kept == int(x_k * (len(errors) - 1)) + 1
spent = errors[:kept].sum() / errors.sum()
print(f"a = {a:.2f}, b = {b:.2f}, knee at x = {x_k:.3f}")
print(f"budget: {spent:.1%} of the sum of all errors buys {kept / len(errors):.1%} of the patches")

x = np.linspace(0, 1, len(errors))
f_k = (a - b) / (a - b * x_k)
fig, axes = plt.subplots(1, 2, figsize=(10, 4.4), layout="constrained")
for ax in axes:
    ax.plot(x, errors / unit, linewidth=3, alpha=0.4, label="sorted errors")
    ax.plot(x, (a - b) / (a - b * x), color="tab:red", label="fitted hyperbola")
    ax.plot(x, f_k + x - x_k, "--", color="gray", linewidth=1, label="slope 1")
    ax.plot(x_k, f_k, "o", color="black", label=f"knee, x = {x_k:.2f}")
    ax.fill_between(x[:kept], errors[:kept] / unit, alpha=0.2, label="budget T")
    ax.set_aspect("equal")
    ax.set(xlabel="x: rank of the correspondence", ylabel="error in units of f(1)")
axes[0].set(ylim=(0, 1.05), title="All errors of the retrieval")
axes[1].set(xlim=(1 - 6 * f_k, 1), ylim=(0, 6 * f_k), title="The same about the knee")
axes[0].legend(loc="upper left")
plt.show()

# %% [markdown]
# The dashed line touches the hyperbola at the knee. What lies right of it costs much for few
# patches, as the numbers say, and is left out. Look also at where the errors leave the red curve:
# it is a model of their shape, and the fit weighs down the largest ones, so that a few of any
# size do not decide.

# %% [markdown]
# ## Claims, and more retrievals
#
# A correspondence within the budget is only a *claim*. Several source patches may claim the same
# target patch; the one with the smallest error gets it, the others go without this time. The
# target patches that have been given away are *fixed*, and the next retrieval searches among
# those that are left.
#
# So it goes on, until the share `fixed_share` (0.95) of the target is fixed; the rest keep what
# the search from target to source has found for them.

# %%
claims, claim_errors = retrieval.claims.copy(), retrieval.errors.copy()
no_limit = np.full(level.delta.shape, np.iinfo(np.int64).max)
fixed_by = np.zeros((height, width), int)
curves = []
while (fixed_by > 0).mean() < 0.95:
    if curves:
        improve(retrieval, len(curves))
    free = retrieval.taken[tuple(retrieval.claims.T)].T != FIXED
    curves.append(np.sort(retrieval.errors[free]))
    newly = retrieval.settle("hyperbola", no_limit)
    fixed = retrieval.taken == FIXED
    fixed_by[fixed & (fixed_by == 0)] = len(curves)
    within = correspondences_within_budget(curves[-1], "hyperbola")
    print(
        f"retrieval {len(curves)}: {within} claims within the budget fix {newly} patches, "
        f"{fixed.mean():.1%} in all; largest error {curves[-1][within - 1] / ONE:.0f}"
    )

fig, axes = plt.subplots(1, 2, figsize=(11, 3.6), layout="constrained")
colours = plt.get_cmap("viridis", len(curves) + 1)
shown = axes[0].imshow(fixed_by, cmap=colours, vmin=-0.5, vmax=len(curves) + 0.5)
axes[0].set_title("retrieval that fixed each target patch (0: none)")
axes[0].axis("off")
fig.colorbar(shown, ax=axes[0], ticks=range(len(curves) + 1))
for number, sorted_errors in enumerate(curves, 1):
    ranks = np.linspace(0, 1, len(sorted_errors))
    within = correspondences_within_budget(sorted_errors, "hyperbola")
    axes[1].plot(ranks, sorted_errors / ONE, color=colours(number), label=f"retrieval {number}")
    axes[1].plot(ranks[within - 1], sorted_errors[within - 1] / ONE, "o", color="black")
axes[1].set(yscale="log", xlabel="rank of the correspondence", ylabel="error")
axes[1].set_title("Errors of each retrieval, with its knee")
axes[1].legend()
plt.show()

# %% [markdown]
# The first retrieval fixes most: each patch of the style goes where it fits best. Each further
# one has fewer places to offer, and its curve lies higher. The budget is relative to the errors
# of its own retrieval, so the late ones fix patches at errors that the first would have refused.
#
# Look at what was given away last or not at all: handle, lid and spout of the teapot, and edges.
# There the style has nothing alike, and what sits there in the end is there for want of a better
# place.

# %% [markdown]
# ## Beside the occurrence map
#
# Whole runs now, from coarse to fine.


# %% tags=["picture"]
def detail(image):
    """Fine detail of each pixel: its squared difference from a Gaussian blur, σ = 1."""
    blurred = gaussian(image.astype(float), 1, channel_axis=2, preserve_range=True)
    return ((image - blurred) ** 2).mean(axis=2)


def richness(image, style):
    return detail(image).mean() / detail(style).mean()


def coverage(omega):
    """Share of the style's pixels that an assigned patch covers."""
    return (omega > 0).mean()


def distinct_patches(nnf):
    """Number of different source patches over the number of target patches."""
    return len(np.unique(nnf.reshape(-1, 2), axis=0)) / nnf[:, :, 0].size


results = {
    "λ = 0": washed_out,
    "ref, λ = 10000": run(),
    "StyLit": run(method="stylit"),
}
fig, axes = plt.subplots(2, 3, figsize=(12, 6), layout="constrained")
for (top, bottom), (name, result) in zip(axes.T, results.items(), strict=True):
    top.imshow(result.image)
    top.set_title(name)
    omega = bottom.imshow(result.omega, cmap="magma", vmin=0, vmax=100)
    bottom.set_title("Ω of the style's pixels")
fig.colorbar(omega, ax=axes[1, :], extend="max")
for ax in axes.flat:
    ax.axis("off")

best = omega_best(5, style[:, :, 0].size, height * width)
print(f"{'':16}     δ  distinct  coverage  peak Ω / ω_best  richness")
for name, result in results.items():
    print(
        f"{name:16} {result.history[-1].delta:5.0f}  {distinct_patches(result.nnf):8.1%}"
        f"  {coverage(result.omega):8.1%}  {result.omega.max() / best:15.1f}"
        f"  {richness(result.image, style):8.3f}"
    )

# %% [markdown]
# *Distinct* counts the different source patches among those assigned, *coverage* the style's
# pixels that are used at all, *peak* how often the most used one is beside an even use, and
# *richness* compares the energy of the fine detail with the style's.
#
# Compare the bottom row first. At $\lambda = 0$ whole regions of the style are black: unused. The
# occurrence map spreads the use evenly, as far as $\lambda$ asks for it. StyLit fills most of the
# black without any $\lambda$, and keeps peaks, since the patches that no retrieval fixed have
# chosen freely. Then compare the strokes above; and look at the top of the wall in StyLit's
# picture, to which we come back.

# %% [markdown]
# ## What it takes
#
# `Result.history` has one step for each retrieval. Here is how many of them a search takes, and
# how far they get.

# %%
history = results["StyLit"].history
last = {(step.level, step.vote): step for step in history}
finest = [step for step in history if step.level == step.levels]

fig, axes = plt.subplots(1, 2, figsize=(10, 3.4), layout="constrained")
for number in range(1, finest[0].levels + 1):
    counts = [step.retrieval for (at, _), step in last.items() if at == number]
    axes[0].plot(range(1, len(counts) + 1), counts, "o-", label=f"level {number}")
axes[0].set(xlabel="vote", ylabel="retrievals", ylim=(0, None), xticks=range(1, 5))
axes[0].set_title("Retrievals until 95 % is fixed (level 1 is the coarsest)")
axes[0].legend(ncols=2)
for vote in range(1, 5):
    steps = [step for step in finest if step.vote == vote]
    axes[1].plot([s.retrieval for s in steps], [s.fixed for s in steps], "o-", label=f"vote {vote}")
axes[1].axhline(0.95, color="gray", linestyle="--")
axes[1].set(xlabel="retrieval", ylabel="share of the target that is fixed")
axes[1].set_title("Finest level")
axes[1].legend()
plt.show()

# %% [markdown]
# Each retrieval is a whole PatchMatch. This is the price of StyLit: where the occurrence map
# searches once between two votes, it searches as often as the left plot says, and once more for
# $E_{best}$.
#
# The last fifth of the target takes most of the retrievals, as the right plot shows. The budget
# does not hold it up: a knee lies between 0.75 and 1, so that most claims are within. But as the
# list further up says, most claims of a late retrieval lose: many patches claim the same few
# places.

# %% [markdown]
# ## Other budgets, and α
#
# Hauptfleisch (4.1.2) does without the fit: $T$ is a share of the sum of all errors, 0.9. And
# since a budget is global, a correspondence may be cheap and still be much worse than what its
# target patch could have. So (2.4.1) a patch $q$ is fixed only if
#
# $$E \le \alpha\, E_{best}(q)$$
#
# with $\alpha = 5$. That is what the first search from target to source is good for.

# %%
variants = {
    "knee": results["StyLit"],
    "budget 0.9": run(method="stylit", budget=0.9),
    "α = 5": run(method="stylit", error_limit=5.0),
    "α = 1.5": run(method="stylit", error_limit=1.5),
}
fig, axes = plt.subplots(1, 4, figsize=(13, 2.7), layout="constrained")
for ax, (name, result) in zip(axes, variants.items(), strict=True):
    step = result.history[-1]
    ax.imshow(result.image)
    ax.set_title(name)
    ax.axis("off")
    print(
        f"{name:10} {step.retrieval} retrievals at last fix {step.fixed:.1%}; "
        f"mean δ {step.delta:.0f}, {distinct_patches(result.nnf):.1%} distinct"
    )
by_share = correspondences_within_budget(errors, 0.9)
print(
    f"of the first retrieval further up 0.9 buys {by_share / len(errors):.1%}, the knee {x_k:.1%}"
)

# %% [markdown]
# Look at the top of the wall. With the knee alone, paint of the floor has got there: its error is
# small beside others of that retrieval, and large beside what this piece of wall could have had.
# The budget makes the first comparison, $\alpha$ the second, and with $\alpha = 5$ the wall is
# clean.
#
# A budget of 0.9 buys nearly everything here. The highlight comes back with it, and so does what
# has no business on the wall; the mean $\delta$ pays. A small $\alpha$ goes the other way: it
# refuses more, refused patches keep their closest match, and $\delta$ falls towards that of
# $\lambda = 0$.
#
# ## Exercises
#
# Write a function of the same name in place of each solution, and unfold the solution only after
# yours passes the test below it.
#
# ### The knee
#
# Write `my_knee(a, b)` for $f(x) = (a - bx)^{-1}$: the $x$ at which the slope of $f / f(1)$ is 1,
# and 1 where the curve is too flat to have one. Derive it; do not search for it.


# %% tags=["hide-input"]
def my_knee(a, b):
    # f' / f(1) = b (a - b) / (a - b x)^2 = 1, and beyond x = 1 where b < a - b
    return min((a - np.sqrt(b * (a - b))) / b, 1.0) if b > 0 else 1.0


# %%
for sorted_errors in curves:
    fitted_a, fitted_b, fitted_knee, _ = budget_of(sorted_errors)
    assert abs(my_knee(fitted_a, fitted_b) - fitted_knee) < 1e-9
assert my_knee(1.0, 0.4) == my_knee(1.0, -0.5) == 1.0
slope = np.gradient((a - b) / (a - b * x), x)
assert abs(np.interp(my_knee(a, b), x, slope) - 1) < 1e-2

# %% [markdown]
# ### A budget as a share
#
# Write `within_share(errors, share)`: how many of the sorted errors, from the smallest on, sum up
# to at most `share` of them all; at least one.


# %% tags=["hide-input"]
def within_share(errors, share):
    return max(int((np.cumsum(errors, dtype=float) <= share * errors.sum(dtype=float)).sum()), 1)


# %%
for sorted_errors in curves:
    for share in (1e-9, 0.1, 0.5, 0.9):
        expected = correspondences_within_budget(sorted_errors, share)
        assert within_share(sorted_errors, share) == expected
zeros = np.zeros(5, np.int64)
assert within_share(zeros, 0.9) == correspondences_within_budget(zeros, 0.9) == 5

# %% [markdown]
# ### Settling claims
#
# Write `settle(claims, errors, kept)` for a first retrieval, all target patches free. `claims[y,
# x]` is the target patch that the source patch `(y, x)` claims at `errors[y, x]`; the `kept`
# smallest errors are within the budget, of equal ones the first in the order of rows. Return a
# dictionary from target patch to source patch, tuples both. The test compares it with what the
# first retrieval above has fixed.


# %% tags=["hide-input"]
def settle(claims, errors, kept):
    winners = {}
    for place in np.argsort(errors, axis=None, kind="stable")[:kept]:
        source = np.unravel_index(place, errors.shape)
        winners.setdefault(tuple(claims[source].tolist()), tuple(map(int, source)))
    return winners


# %%
level = start()
fresh = Retrieval(level, random_stream(0, RETRIEVAL_NNF, 1, 1))
improve(fresh, 0)
np.testing.assert_array_equal(fresh.claims, claims)
fresh.settle("hyperbola", no_limit)
winners = settle(claims, claim_errors, kept)
fixed = {tuple(place) for place in np.argwhere(fresh.taken == FIXED).tolist()}
assert set(winners) == fixed
for (y, x), (source_y, source_x) in winners.items():
    assert tuple(level.nnf[y, x]) == (source_y + 2, source_x + 2)
print(f"{kept} claims within the budget, {len(winners)} settled")
