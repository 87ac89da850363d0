"""The numbers of one run, as a row of a table."""

from eval.image_energy import image_energy
from eval.runs import run
from eval.sharpness import richness, sharpness
from eval.usage import coverage, distinct_patches, peak_usage


def measure(scene, params, seed, progress=None):
    """Run and measure.

    Parameters
    ----------
    scene : Scene
    params : Params
    seed : int
    progress : callable, optional

    Returns
    -------
    dict of str to float
    """
    result = run(scene, params, seed, progress)
    energy = image_energy(scene, result.image, params.patch_width)
    return {
        "seconds": result.seconds,
        "delta": result.delta,
        "penalization": result.penalization,
        "phi": result.delta + result.penalization,
        "image_energy": energy.mean,
        "distinct_in_image": energy.distinct,
        "distinct": distinct_patches(result.nnf),
        "coverage": coverage(result.omega),
        "peak": peak_usage(result.omega, result.nnf[:, :, 0].size, params.patch_width),
        "sharpness": sharpness(result.image, scene.style, result.nnf),
        "richness": richness(result.image, scene.style),
    }


COLUMNS = {
    "delta": ("δ", "{:.0f}"),
    "penalization": ("λρ", "{:.0f}"),
    "phi": ("φ", "{:.0f}"),
    "image_energy": ("image energy", "{:.0f}"),
    "distinct": ("distinct assigned", "{:.1%}"),
    "distinct_in_image": ("distinct in image", "{:.1%}"),
    "coverage": ("coverage", "{:.1%}"),
    "peak": ("peak Ω/ω_best", "{:.1f}"),
    "sharpness": ("sharpness", "{:.3f}"),
    "richness": ("richness", "{:.3f}"),
    "seconds": ("time [s]", "{:.1f}"),
}

DEFINITIONS = """\
- **δ**, **λρ**, **φ**: means over all target patches when the last PatchMatch iteration of the
  finest level ends (squared 8-bit steps; thesis 2.1, 2.2).
- **image energy**: mean δ of the best match of every interior patch of the finished image,
  found by a converged λ = 0 search; **distinct in image**: different source centres in that
  field over interior pixels.
- **distinct assigned**: different source centres in the run's own NNF over target pixels;
  **coverage**: share of the source under some assigned patch; **peak**: largest Ω over ω_best.
- **sharpness**: energy above a Gaussian blur (σ = 1 px) of the output over that of the style at
  the assigned pixels: below 1, voting blurs. **richness**: the same energy of the output over
  that of the whole style: below sharpness, smooth parts of the style are preferred."""


def formatted(frame):
    """Name and format the measured columns of a data frame for a report."""
    formatted = frame.copy()
    for name, (title, form) in COLUMNS.items():
        if name in formatted:
            formatted[name] = formatted[name].map(form.format)
            formatted = formatted.rename(columns={name: title})
    return formatted
