"""The numbers of a run that do not depend on other runs, computed once."""

import hashlib
import json
from pathlib import Path

from eval.image_analogies import ImageAnalogies
from eval.image_energy import image_energy
from eval.patch_distribution import patch_distance
from eval.sharpness import richness, sharpness
from eval.spilling import spilling
from eval.split_delta import split_delta
from eval.usage import coverage, peak_usage, usage_entropy
from stylit_ref import Params
from stylit_ref.files.output_file import write_text

STORE = Path("build/quality")

MEASURES = {
    "guides": ("δ, guides", "{:.0f}"),
    "style": ("δ, style", "{:.0f}"),
    "penalization": ("λρ", "{:.0f}"),
    "image_energy": ("image energy", "{:.0f}"),
    "coverage": ("coverage", "{:.1%}"),
    "entropy": ("entropy", "{:.4f}"),
    "peak": ("peak ω", "{:.1f}"),
    "sharpness": ("sharpness", "{:.3f}"),
    "richness": ("richness", "{:.3f}"),
    "patches": ("patch distance", "{:.2f}"),
    "spilled": ("spilled", "{:.2%}"),
}
"""Title and format of each number."""

DEFINITIONS = """\
- **δ, guides** and **δ, style**: mean over all target patches of the finished image, in squared
  8-bit steps (thesis 2.1); **λρ**: the mean when the last PatchMatch iteration ends.
- **image energy**: mean δ of the best match of every interior patch of the finished image, found by
  a converged λ = 0 search: the same question to every method.
- **coverage**: share of the style's pixels under some assigned patch; **entropy**: that of Ω over
  the style's pixels, as a share of the largest; **peak ω**: largest Ω over ω_best (1 is even).
- Wash-out has two sides. **sharpness**: energy above a Gaussian blur (σ = 1 pixel) of the output
  over that of the style at the pixels it was taken from; below 1, voting blurs. **richness**: the
  same energy of the output over that of the whole style; lower, smooth patches are preferred.
- **patch distance**: sliced Wasserstein distance between the 5x5 patches of the output and of the
  style, 10000 of each, 64 directions, in 8-bit steps: whether there are the same strokes, and as
  often.
- **spilled**: target patches whose source patch is centred on another object."""


def quality(job, run):
    """Measure a run.

    Parameters
    ----------
    job : Job
    run : Run

    Returns
    -------
    dict of str to float
        By :data:`MEASURES`, where they apply.
    """
    scene, image = job.scene, run.image
    guides, style = split_delta(scene, image, run.nnf)
    numbers = {
        "guides": guides,
        "style": style,
        "coverage": coverage(run.omega),
        "entropy": usage_entropy(run.omega),
        "peak": peak_usage(run.omega, run.nnf[:, :, 0].size, Params().patch_width),
        "sharpness": sharpness(image, scene.style, run.nnf),
        "richness": richness(image, scene.style),
        "patches": patch_distance(image, scene.style),
    }
    analogies = isinstance(job.params, ImageAnalogies)
    if not analogies and job.params.method != "stylit":
        numbers["penalization"] = run.penalization
    if scene.ids:
        numbers["spilled"] = float(spilling(run.nnf, scene.ids).mean())
    if analogies or job.params.method != "guide_map":
        numbers["image_energy"] = image_energy(scene, image).mean
    return numbers


def stored_quality(job):
    """The numbers of a run that were measured before, or None."""
    try:
        stored = json.loads(_file(job).read_text(encoding="utf-8"))
        return stored["numbers"] if stored["run"] == job.key else None
    except (OSError, ValueError, KeyError, TypeError):
        return None


def store_quality(job, numbers):
    """Keep the numbers of a run."""
    STORE.mkdir(parents=True, exist_ok=True)
    write_text(_file(job), json.dumps({"run": job.key, "numbers": numbers}))


def _digest():
    """Identifies the measures."""
    here = Path(__file__)
    names = "image_energy", "patch_distribution", "sharpness", "spilling", "split_delta", "usage"
    files = [here, *(here.parents[1] / f"{name}.py" for name in names)]
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()[:8]


_DIGEST = _digest()


def _file(job):
    objects = "" if job.scene.ids is None else "-objects"  # no part of the run, but of its measures
    return STORE / f"{job.key}-{_DIGEST}{objects}.json"
