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
# # 6. From Python to CUDA
#
# ![A golem without λ, one pixel after another, with Ω frozen, and by propose and
# commit](pictures/6_from_python_to_cuda.webp)
#
# On a GPU every target patch gets a thread of its own. The mathematics of a patch stays the same,
# and so does the code: this notebook runs the same formulae in a loop of the CPU and in CUDA
# kernels (thesis 3.2 to 3.4), and compares bytes.
#
# One thing does not survive the step from a loop to thousands of threads: the occurrence map
# $\Omega$, which all of them read and change. You will see it change by atomics while the kernels
# run, as in the thesis, so that two runs need not agree; then stand still while they run, and the
# picture washes out; and then the schedule of the library, *propose and commit*, which cures both.
#
# Where there is no GPU, kernels run in Numba's simulator: Python code, a Python thread for each
# thread of a block. It has to be chosen before Numba is imported, and it is slow, so the images
# are tiny.

# %% tags=["hide-input"]
# ruff: noqa: E402
import os
import subprocess
import sys

ASK = "from gpu_cuda.host import doctor; raise SystemExit(doctor.missing())"
if subprocess.run([sys.executable, "-c", ASK], capture_output=True).returncode:
    os.environ["NUMBA_ENABLE_CUDASIM"] = "1"

import inspect
from importlib.resources import files
from unittest.mock import patch

import matplotlib.pyplot as plt
import numba
import numpy as np
from skimage.filters import gaussian

import gpu_cuda
from gpu_cuda.host import device, doctor
from gpu_cuda.variants import live
from stylit_ref import Params, passes, read_uint8, stylize
from stylit_ref.randomness import philox
from stylit_ref.randomness.commit_classes import CLASS_STRIDE, commit_order
from stylit_ref.randomness.random_stream import (
    COMMIT_ORDER,
    RANDOM_NNF,
    RANDOM_SEARCH,
    random_stream,
)
from stylit_ref.stylization import schedules
from stylit_ref.stylization.backends import Backend
from stylit_ref.stylization.problem import make_synthesis

DATA = files("data_gen") / "bundled"
GUIDES = "FULL", "LDE", "LSE", "LDDE", "LD12E"


def reduced(name, halvings):
    """A bundled image, halved as often as asked."""
    image = read_uint8(DATA / name)
    for _ in range(halvings):
        image = passes.downsample(image)
    return image


print("kernels run on", doctor.device_name())

# %% [markdown]
# ## One formula, two loops
#
# The library keeps what belongs to one pixel or one patch apart from the loop over all of them.
# Here is a *formula*, which maps a random word to an integer, and a *pass* of the CPU that calls
# it for every target pixel: the random assignments that a run begins with (RandomNNF of thesis
# 2.3).

# %%
cpu_module = sys.modules["stylit_ref.passes.random_nnf"]
print(inspect.getsource(philox.uniform_below.py_func))
print(inspect.getsource(cpu_module.random_nnf))

# %% [markdown]
# And the kernel (thesis 3.4). It has no loop: `cuda.grid(2)` says which pixel is this thread's.
# What was the loop's range is a test now, since threads come in whole blocks and some of them
# stand outside the image. The last lines are the same, and so are the functions they call: Numba
# compiles a formula for the CPU or for the GPU, as its caller needs it.

# %%
print(inspect.getsource(inspect.getmodule(gpu_cuda.random_nnf)))

# %%
HEIGHT, WIDTH = 12, 16
style = reduced("source/styles/oil.png", 3)
source_guides = [reduced(f"source/{guide}.png", 3) for guide in GUIDES]
window = np.s_[3 : 3 + HEIGHT, 6 : 6 + WIDTH]
target_guides = [np.ascontiguousarray(reduced(f"golem/{guide}.png", 3)[window]) for guide in GUIDES]

on_cpu = np.zeros((HEIGHT, WIDTH, 2), np.int32)
on_device = gpu_cuda.upload(on_cpu)
stream = random_stream(0, RANDOM_NNF, 1)
passes.random_nnf(on_cpu, 5, *style.shape[:2], stream)
gpu_cuda.random_nnf(on_device, 5, *style.shape[:2], stream)
np.testing.assert_array_equal(gpu_cuda.download(on_device), on_cpu)

columns, rows = device.BLOCK
across, down = -(-WIDTH // columns), -(-HEIGHT // rows)
fig, axes = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
for ax, image, title in (
    (axes[0], target_guides[0], f"{down * across} blocks of {columns}x{rows} threads"),
    (axes[1], on_cpu[:, :, 0], "row of each pixel's random assignment"),
):
    shown = ax.imshow(image)
    ax.set_title(title)
for column in range(across):
    for row in range(down):
        corner = column * columns - 0.5, row * rows - 0.5
        axes[0].add_patch(plt.Rectangle(corner, columns, rows, fill=False, edgecolor="black"))
axes[0].set(xlim=(-1, across * columns), ylim=(down * rows, -1))
fig.colorbar(shown, ax=axes[1])
threads = down * rows * across * columns
print(f"{threads} threads for {WIDTH * HEIGHT} pixels; the bytes of CPU and device are the same")

# %% [markdown]
# Every pixel draws its numbers from a counter that holds its own place (Philox,
# `stylit_ref/randomness/random_stream.py`), so no thread has to wait for a number before it or care
# who drew first. Kernels that read shared data and write only their own pixel are as easy as
# that.

# %% [markdown]
# ## Races, live
#
# $\Omega$ is not a pixel's own. A thread that moves its assignment from $Q$ to $Q'$ subtracts 1
# from $\Omega$ under $Q$ and adds 1 under $Q'$, while others do the same at the same places.
# Reading a number, adding 1 and writing it back is three steps: of two threads that do it at
# once, one may overwrite what the other has written. So the thesis uses *atomic* additions
# (UpdatePatchOmega, 3.2), which the device carries out one after another.
#
# We start twice from the same assignments with the same random numbers, and run the kernels of
# thesis 3.3 with $\Omega$ live: one propagation, then random search, at $\lambda = 50000$, where
# much depends on $\Omega$. (Python's threads take turns every five milliseconds; a GPU's are not
# that polite, so the simulator's shall take turns much more often.)


# %%
def start(where):
    """A level with random assignments, voted: the same on the CPU and on the device."""
    params = Params(uniformity=50000, levels=1)
    images = style, source_guides, target_guides
    level = make_synthesis(*images, params, backend=Backend(where)).begin_level(1)
    level.vote()
    level.update_moments()
    return level


def live_run():
    """NNF and Ω after Kernel_Propagation and Kernel_RandomSearch, Ω changing as they run."""
    level = start(gpu_cuda)
    live.propagate(level, live.omega_kernels, level.omega, 1)
    stream = random_stream(0, RANDOM_SEARCH, 1, 1, 1)
    live.search_at_random(level, live.omega_kernels, level.omega, stream)
    return gpu_cuda.download(level.nnf), gpu_cuda.download(level.omega)


patient = sys.getswitchinterval()
sys.setswitchinterval(1e-5)
runs = [live_run() for _ in range(2)]
sys.setswitchinterval(patient)

# %%
(nnf_1, omega_1), (nnf_2, omega_2) = runs
differ = (nnf_1 != nnf_2).any(axis=2)
print(f"{differ.sum()} of {differ.size} pixels have another assignment in the second run")
for nnf, omega in runs:
    counted, sums = np.zeros_like(omega), np.zeros_like(omega)
    passes.occurrence_map(nnf, counted, sums, 5)
    np.testing.assert_array_equal(omega, counted)
    print(f"Ω is what a recount gives; ΣΩ = {omega.sum()} = 25 x {HEIGHT * WIDTH}")

fig, axes = plt.subplots(1, 3, figsize=(11, 3.2), layout="constrained")
axes[0].imshow(differ, cmap="gray")
axes[0].set_title("target: assignments that differ")
axes[1].imshow(omega_1, cmap="viridis")
axes[1].set_title("source: Ω of the first run")
change = axes[2].imshow(omega_2 - omega_1, cmap="RdBu", vmin=-6, vmax=6)
axes[2].set_title("source: Ω of the second less the first")
fig.colorbar(change, ax=axes[2])
for ax in axes:
    ax.axis("off")

# %% [markdown]
# Atomics do what they promise: no addition is lost, $\Omega$ is exactly the recount of the
# assignments, in each run. What they do not fix is *when* an addition happens. Between the moment
# a thread reads $\rho$ and the moment it moves, others have moved. Which ones, nobody knows, and
# so the decisions differ wherever the left picture is white. Both runs are legitimate results of
# the thesis' algorithm; but you cannot test a port against them byte by byte, nor repeat a
# picture you liked.

# %% [markdown]
# ## Ω frozen: no race, and a rush
#
# The obvious way out: let all threads read $\Omega$ as it was when the kernel began, and count
# anew when it is done. Then every thread's decision is its own, and the result is the same each
# time.
#
# To see what is wrong with it, let all pixels want the same thing. Every one has a random
# assignment and a *proposal*: one patch, the same for all, at half the $\delta$. With a frozen
# $\Omega$ each compares
#
# $$\varphi = \lambda\rho(Q) + \delta(P, Q)$$
#
# with the map as it was, and does not know that the others go there too.

# %%
level = start(passes)
level.proposed_nnf[:] = style.shape[0] // 2, style.shape[1] // 2
level.proposed_delta[:] = level.delta // 2

weight = level.occurrence_weight
wide = level.omega_sums.astype(np.int64)  # its product with the weight needs 64 bits
new_phi = level.proposed_delta + weight * wide[tuple(level.proposed_nnf.T)].T
rush = new_phi < level.delta + weight * wide[tuple(level.nnf.T)].T
print(f"Ω frozen: {rush.sum()} of {rush.size} pixels move to the one patch at once")

before = level.nnf.copy()
stream = random_stream(0, COMMIT_ORDER, 1, 1, 1)
passes.commit(*level.commitment(stream))
moved = (level.nnf != before).any(axis=2)
print(f"committed in {CLASS_STRIDE**2} classes: {level.take_moves()} move")

# %% [markdown]
# The second number is the library's *commit*. It takes the proposals up in sixteen classes of
# pixels, those with the same $(y \bmod 4, x \bmod 4)$, one class after another in a shuffled
# order. Within a class every pixel compares once more with $\Omega$ as it stands now; when the
# class is done, $\Omega$ follows. Once the patch is crowded, the others stay away:

# %%
order = np.empty((CLASS_STRIDE**2, 2), np.int32)
commit_order(stream, order)
turn = np.empty((CLASS_STRIDE, CLASS_STRIDE), int)
turn[tuple(order.T)] = np.arange(1, CLASS_STRIDE**2 + 1)
turns_of_pixels = np.tile(turn, (HEIGHT // CLASS_STRIDE, WIDTH // CLASS_STRIDE))

fig, axes = plt.subplots(1, 4, figsize=(13, 3), layout="constrained", width_ratios=(1, 1, 1, 1.3))
axes[0].imshow(rush, cmap="gray", vmin=0, vmax=1)
axes[0].set_title("moved, Ω frozen")
axes[1].imshow(moved, cmap="gray", vmin=0, vmax=1)
axes[1].set_title("moved, committed")
axes[2].imshow(turns_of_pixels, cmap="viridis")
axes[2].set_title("turn of each pixel's class")
for ax in axes[:3]:
    ax.axis("off")
numbers = range(1, CLASS_STRIDE**2 + 1)
for data, label in ((rush, "Ω frozen"), (moved, "committed")):
    axes[3].step(
        numbers, [data[turns_of_pixels == n].sum() for n in numbers], where="mid", label=label
    )
axes[3].set(xlabel="turn of the class", ylabel="pixels that move", xticks=numbers[::3])
axes[3].legend()
plt.show()

# %% [markdown]
# Neighbours of one class are four pixels apart, so those that decide together are few and spread
# over the image. They still rush, but only a sixteenth of them at a time, and the next class sees
# what they have done.

# %% [markdown]
# ## The picture with Ω frozen
#
# Now whole runs of the CPU's passes at $150 \times 114$. The schedule `frozen` below calls the
# library's propagation and random search and takes every proposal; $\Omega$ is counted anew after
# each pass. For the time of a run it stands in for the default schedule.

# %%
scene = (
    reduced("source/styles/oil.png", 1),
    [reduced(f"source/{guide}.png", 1) for guide in GUIDES],
    [reduced(f"golem/{guide}.png", 1) for guide in GUIDES],
)


def frozen(level, seed, level_number, vote, iteration):
    """One PatchMatch iteration whose proposals are all taken, whatever the others do."""
    stream = random_stream(seed, RANDOM_SEARCH, level_number, vote, iteration)
    kernels = [(passes.propagation, distance) for distance in schedules.PROPAGATION_DISTANCES]
    for propose, parameter in [*kernels, (passes.random_search, stream)]:
        propose(*level.proposal, parameter)
        level.nnf, level.proposed_nnf = level.proposed_nnf, level.nnf
        level.delta, level.proposed_delta = level.proposed_delta, level.delta
        level.init_occurrence_map()


SMALL = {"levels": 5, "votes": 4, "patchmatch_iterations": 3}


def run(schedule, uniformity):
    """A whole run in one of the library's schedules, or with Ω frozen."""
    if schedule == "frozen":
        with patch.dict(schedules.SCHEDULES, propose_commit=frozen):
            return run("propose_commit", uniformity)
    return stylize(*scene, Params(uniformity=uniformity, schedule=schedule, **SMALL))


results = {
    key: run(*key)
    for key in (
        ("frozen", 0),
        ("propose_commit", 0),
        ("scanline", 15000),
        ("frozen", 15000),
        ("propose_commit", 15000),
    )
}
np.testing.assert_array_equal(
    results["frozen", 0].image, results["propose_commit", 0].image, "without λ nothing can freeze"
)


# %% tags=["picture"]
def detail(image):
    """Fine detail of each pixel: its squared difference from a Gaussian blur, σ = 1."""
    blurred = gaussian(image.astype(float), 1, channel_axis=2, preserve_range=True)
    return ((image - blurred) ** 2).mean(axis=2)


def sharpness(image, style, nnf):
    """Fine detail of an image over that of the style where it was taken from."""
    return detail(image).sum() / detail(style)[nnf[:, :, 0], nnf[:, :, 1]].sum()


shown = {
    "λ = 0: Ω does not count": results["frozen", 0],
    "one after another, Ω live": results["scanline", 15000],
    "Ω frozen": results["frozen", 15000],
    "propose and commit": results["propose_commit", 15000],
}
fig, axes = plt.subplots(2, 2, figsize=(9, 7), layout="constrained")
for ax, (name, result) in zip(axes.flat, shown.items(), strict=True):
    last = result.history[-1]
    ax.imshow(result.image)
    ax.set_title(f"{name}: δ {last.delta:.0f}, λρ {last.penalization:.0f}")
    ax.axis("off")

fig, ax = plt.subplots(figsize=(7, 3), layout="constrained")
for name, result in list(shown.items())[1:]:
    crisp = sharpness(result.image, scene[0], result.nnf)
    coherent = (np.diff(result.nnf, axis=1) == (0, 1)).all(axis=2).mean()
    print(f"{name}: {crisp:.0%} of the fine detail that its patches have in the style;")
    print(f"    {coherent:.0%} of the pixels continue the assignment of their left neighbour")
    finest = [
        step.delta + step.penalization for step in result.history if step.level == step.levels
    ]
    ax.plot(range(1, len(finest) + 1), finest, "o-", label=name)
ax.set(xlabel="PatchMatch iteration at the finest level (a vote every three)", ylabel="φ")
ax.set_title("λ = 15000")
ax.legend()
plt.show()

# %% [markdown]
# All but the first are at $\lambda = 15000$. Look at the brush strokes of the wall: with $\Omega$
# frozen they are gone. As in the experiment above, pixels rush to unused patches together. Fewer
# of them continue what their neighbours have, and voting averages what does not fit; the numbers
# say how much. The curve says the same: its $\varphi$ stays far above the others, while each
# decision by itself was an improvement. One after another with $\Omega$ live (`scanline`, thesis
# 2.4) does not have that trouble, but it is a loop that no two threads can share.

# %% [markdown]
# ## Propose and commit
#
# So the default schedule does half of each. Kernels *propose* with $\Omega$ frozen: no race, and
# all threads at once. Then proposals *commit*, class after class: no rush. Numbers are integers,
# so the order of additions within a class does not matter; the result is the same with any number
# of threads, and on both backends.

# %%
levels = [start(passes), start(gpu_cuda)]
moves = [
    schedules.propose_commit(level, seed=0, level_number=1, vote=1, iteration=1) for level in levels
]
cpu, cuda = levels
for name in ("nnf", "delta", "omega_sums"):
    np.testing.assert_array_equal(getattr(cuda, name).copy_to_host(), getattr(cpu, name), name)
print(f"one iteration on the CPU and on {doctor.device_name()}: the same bytes,")
print("{} moves on one, {} on the other".format(*moves))

for threads in range(1, numba.config.NUMBA_NUM_THREADS + 1):
    again = stylize(*scene, Params(uniformity=15000, **SMALL), threads=threads)
    np.testing.assert_array_equal(again.nnf, results["propose_commit", 15000].nnf)
    np.testing.assert_array_equal(again.image, results["propose_commit", 15000].image)
    print(f"a whole run with {threads} of {numba.config.NUMBA_NUM_THREADS} threads: the same bytes")

# %% [markdown]
# Only the search has to know about this. `stylize(..., backend="cuda")` runs the same loop over
# levels and votes (`stylit_ref/stylization/synthesis.py`) with the module of passes exchanged, and
# `backend="cuda:live"` takes the thesis' own kernels on a GPU.
#
# ## Exercises
#
# Write a function of the same name in place of each solution, and unfold the solution only after
# yours passes the test below it.
#
# ### Recount
#
# Write `recount(nnf, source_shape, w)`: $\Omega$ of an NNF, pixel by pixel of every assigned
# patch. The test compares it with what the atomics left behind.


# %% tags=["hide-input"]
def recount(nnf, source_shape, w):
    omega = np.zeros(source_shape, int)
    for y, x in nnf.reshape(-1, 2):
        omega[y - w // 2 : y + w // 2 + 1, x - w // 2 : x + w // 2 + 1] += 1
    return omega


# %%
for nnf, omega in runs:
    np.testing.assert_array_equal(recount(nnf, omega.shape, 5), omega)

# %% [markdown]
# ### One write for 25
#
# $W(Q)$ is $\Omega$ summed over the patch around $Q$. One more assignment of the patch around
# $(y, x)$ changes $\Omega$ at 25 places; how much does it change $W$ at $(y + d_y, x + d_x)$?
# Write `change_of_w(dy, dx, w)`.


# %% tags=["hide-input"]
def change_of_w(dy, dx, w):
    return max(w - abs(dy), 0) * max(w - abs(dx), 0)


# %%
one = np.full((1, 1, 2), 10, np.int32)
omega, sums = np.zeros((2, 21, 21), np.int32)
for w in (3, 5, 7):
    passes.occurrence_map(one, omega, sums, w)
    mine = [[change_of_w(dy, dx, w) for dx in range(-10, 11)] for dy in range(-10, 11)]
    np.testing.assert_array_equal(mine, sums)

# %% [markdown]
# ### A commit of your own
#
# Write `commit_class(nnf, delta, proposed_nnf, proposed_delta, sums, weight, first_y, first_x)`:
# all pixels `[first_y::4, first_x::4]` decide at once, with $W$ (`sums`) as it stands; it changes
# `nnf` and `delta` (64-bit integers all) and leaves `sums` alone. The test runs it for the
# sixteen classes in the library's order, counting $W$ anew after each, and compares with the
# commit of the CPU and of the device.


# %% tags=["hide-input"]
def commit_class(nnf, delta, proposed_nnf, proposed_delta, sums, weight, first_y, first_x):
    here = np.s_[first_y::4, first_x::4]
    old, new = nnf[here], proposed_nnf[here]
    old_phi = delta[here] + weight * sums[old[:, :, 0], old[:, :, 1]]
    new_phi = proposed_delta[here] + weight * sums[new[:, :, 0], new[:, :, 1]]
    moves = new_phi < old_phi
    nnf[here][moves] = new[moves]
    delta[here][moves] = proposed_delta[here][moves]


# %%
level = start(passes)
passes.random_search(*level.proposal, random_stream(0, RANDOM_SEARCH, 1, 1, 1))
fields = level.nnf, level.delta, level.proposed_nnf, level.proposed_delta, level.omega_sums
mine = [array.astype(np.int64) for array in fields]
committed = []
for where in (passes, gpu_cuda):
    arrays = [where.upload(array.copy()) for array in fields]
    where.commit(*arrays, level.occurrence_weight, 5, stream, where.zeros(1, np.int64))
    committed.append([where.download(arrays[n]) for n in (0, 1, 4)])
for first_y, first_x in order:
    commit_class(*mine, level.occurrence_weight, first_y, first_x)
    passes.occurrence_map(mine[0], level.omega, mine[4], 5)
assert (mine[0] != level.nnf).any()
for nnf, delta, sums in committed:
    np.testing.assert_array_equal(mine[0], nnf)
    np.testing.assert_array_equal(mine[1], delta)
    np.testing.assert_array_equal(mine[4], sums)
