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
# # 9. Real time: fewer patches, fewer bytes
#
# ![A golem in oil after 1, 3, 5 and 6 levels, from coarse to fine](pictures/9_real_time.webp)
#
# The other notebooks search a match for every pixel and take seconds. Heidrich (2017) asks what
# can be left out so that a picture follows the hand. This notebook leaves out patches, then
# bytes, then work on fine levels, and at last starts where the frame before it ended. It covers
# sections 3.4, 4.2 and 5.2 of that thesis, and redraws its Figures 14, 15 and 17 from our scenes.

# %% tags=["hide-input"]
from pathlib import Path
from time import process_time

import matplotlib.pyplot as plt
import numpy as np

import data_gen
from stylit_ref import (
    REALTIME_PRESETS,
    RealtimeParams,
    RealtimeSession,
    StagePacking,
    pack,
    read_uint8,
)
from stylit_ref.realtime.formulae.grid import covered_from_left, covered_from_right, is_of_half

scenes, packing = Path(data_gen.__file__).with_name("bundled"), StagePacking()


def buffers_of(scene):
    return {name: read_uint8(scenes / scene / f"{name}.png") for name in packing.names}


def show(place, image, title, **how):
    place.imshow(image, **how)
    place.set_title(title, fontsize=9)
    place.axis("off")


source, target = buffers_of("source"), buffers_of("golem")
oil = read_uint8(scenes / "source/styles/oil.png")

# %% [markdown]
# ## Figure 14: what guides it
#
# Seven buffers of the renderer: all light, direct diffuse, diffuse interreflections, direct
# specular, foreground and background, the Fresnel term, and light and shadow.

# %%
fig, axes = plt.subplots(2, 7, figsize=(13, 3.2), layout="constrained")
for row, buffers in zip(axes, (source, target), strict=True):
    for place, (name, buffer) in zip(row, buffers.items(), strict=True):
        show(place, buffer.squeeze(), name, cmap="gray", vmin=0, vmax=255)
plt.show()

# %% [markdown]
# ## Fewer bytes
#
# These are 21 bytes of a pixel. On a stage with a red object and white ground most of them say
# the same twice: green is blue, and a highlight is grey. Ten are left (4.2.2), and the two
# masks become three *labels*: paint must not go from one to another.

# %%
features, labels = pack(packing, source)
target_features, target_labels = pack(packing, target)
blue = [np.abs(source[n][..., 1].astype(int) - source[n][..., 2]).mean() for n in ("FULL", "LDE")]
print(
    f"{features.shape[2]} bytes a pixel; green and blue differ by {max(blue):.2f} steps on average"
)
assert features.shape[2] == 10
assert max(blue) < 1

# %% [markdown]
# ## A sparse grid, and the blend of four patches
#
# With patches of $w = 5$ pixels, $r = (w + 1) / 2 = 3$ from one to the next, there is a ninth as
# many matches. Of the patches that cover a pixel at most four are left to average, in place of
# 25. So the blend blurs less, but the number of patches has a period of $r$.

# %%
left, right = covered_from_left(3, 2), covered_from_right(3, 2)
along = np.array([a + b for a, b in zip(left, right, strict=True)])
covering = np.tile(np.outer(along, along), (4, 4))
halves = np.array([[is_of_half(a, b, 0) for b in range(8)] for a in range(8)])
assert sorted(np.unique(covering)) == [1, 2, 4]

fig, axes = plt.subplots(1, 2, figsize=(6, 3), layout="constrained")
show(axes[0], covering, "patches that cover a pixel: 1, 2 or 4")
show(axes[1], halves, "entries of one half iteration", cmap="gray")
plt.show()

# %% [markdown]
# On the right is a *half iteration*. An entry reads the matches of its four neighbours, which are
# all of the other half and stay as they are meanwhile. So entries can be searched in any order,
# by any number of threads, in place, and the bytes are the same.
#
# ## Figure 17: whom to listen to
#
# $E = (1 - \mu)\, |A(p) - B(q)|^2 + \mu\, |A'(p) - B'(q)|^2$. On coarse levels guides alone
# decide. The thesis ends with the style alone on the finest two. `best` keeps the guides there,
# with a weight; `quick` leaves them out at the finest alone.

# %%
fig, place = plt.subplots(figsize=(6, 2.5), layout="constrained")
levels = range(6)
for name, line in zip(REALTIME_PRESETS, ("-", "--", "-.", ":"), strict=True):
    mu = [RealtimeParams.preset(name).mu_at(k) / 16 for k in levels]
    place.step(levels, mu, line, where="mid", label=name)
place.invert_xaxis()
place.set(xlabel="level, the coarsest first", ylabel="μ")
place.legend()
plt.show()

# %% [markdown]
# ## Figure 15: from coarse to fine
#
# A pyramid that ends at level $k$ gives the picture as it is after that level. Here we stop early
# by letting the finer levels do no iteration: they only pass matches on.


# %% tags=["picture"]
def session_of(params, style=oil, seed=1):
    session = RealtimeSession(params, seed=seed, threads=1)
    session.set_exemplar(features, style, labels)
    session.set_target(target_features, target_labels)
    return session


best = RealtimeParams()
steps = {}
for stop in (5, 3, 1, 0):
    iterations = [0 if k < stop else best.iterations_at(k) for k in range(6)]
    steps[stop] = session_of(RealtimeParams(iterations=iterations)).frame()

fig, axes = plt.subplots(1, 4, figsize=(13, 3), layout="constrained")
for place, (stop, picture) in zip(axes, steps.items(), strict=True):
    show(place, picture, f"down to level {stop}")
plt.show()

# %% [markdown]
# ## Scale space: a saving of memory reads
#
# The thesis goes on: in place of the 25 pixels of a patch it compares $D = 3$ means around its
# centre (4.2.3). On a graphics card, where reads of many threads compete, that halves the time.
# On a processor a row of a patch is one vector read, and the rows lie in the cache; it is the
# first, random read that costs. So patches cost about as much as means, and look better.


# %%
def cost(name):
    session = session_of(name)
    session.frame()
    times = []
    for _ in range(5):
        before = process_time()
        picture = session.frame(seed=2)
        times.append(process_time() - before)
        session.set_weights(None)  # so that no level is kept
    return 1000 * min(times), picture


fig, axes = plt.subplots(1, 4, figsize=(13, 3), layout="constrained")
for place, name in zip(axes, ("simple", "optimized", "quick", "best"), strict=True):
    milliseconds, picture = cost(name)
    show(place, picture, f"{name}: {milliseconds:.0f} ms of one core")
plt.show()

# %% [markdown]
# ## Warm starts and flicker
#
# A frame that is searched anew, even of the same target, finds other matches of the same quality.
# A *warm* frame begins with those of the last one. It renews what has grown old from a
# coarse level, and searches the finest one.

# %%
session = session_of("best")
first = session.frame()
warm = session.frame(warm=True)
other = session.frame(seed=9)


def change(one, two):
    return np.abs(one.astype(int) - two).mean()


print(f"mean change: warm {change(first, warm):.2f}, another seed {change(first, other):.2f}")
assert change(first, warm) < change(first, other) / 2

# %% [markdown]
# ## Exercises
#
# **1.** How many patches cover a pixel where they are `width` wide and `spacing` apart, along one
# side? Write `covered(width, spacing)`, a list for the pixels of one cell, without the library's
# function.


# %% tags=["hide-input"]
def covered(width, spacing):
    radius = width // 2
    places = [k * spacing for k in range(-width, width + 1)]
    return [sum(abs(place - pixel) <= radius for place in places) for pixel in range(spacing)]


# %%
assert covered(5, 3) == along.tolist()
assert covered(5, 5) == [1] * 5
assert covered(7, 4) == [1, 2, 2, 2]

# %% [markdown]
# **2.** Somebody paints. Show the stroke at once by the matches there are, and whole by a cold
# frame with the *same* seed. Write `after_stroke(session, style)` that returns both pictures.


# %% tags=["hide-input"]
def after_stroke(session, style):
    session.set_style(style)
    return session.replay(), session.frame()


# %%
painted = oil.copy()
painted[100:104, 60:120] = 255, 240, 120
session = session_of("quick")
before = session.frame()
at_once, whole = after_stroke(session, painted)
new = session_of("quick", painted).frame()
assert np.array_equal(whole, new)
assert change(before, at_once) < change(before, session.frame(seed=9))

fig, axes = plt.subplots(1, 3, figsize=(11, 3), layout="constrained")
show(axes[0], painted, "a stroke in the style")
show(axes[1], at_once, "replayed")
show(axes[2], whole, "cold, same seed")
plt.show()
