"""From images and motion to a coherent run that is checked and can begin."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.stylization.backends import CPU, Backend
from stylit_ref.stylization.checks import as_image, fit_levels, size_text
from stylit_ref.stylization.exemplar import Exemplar
from stylit_ref.stylization.params import Params, as_params
from stylit_ref.stylization.problem import make_exemplar, make_target
from stylit_ref.stylization.synthesis import Synthesis
from stylit_ref.stylization.target import Target
from stylit_ref.views.formulae.fold import ONE, fixed_weight
from stylit_ref.views.frames import Edges, check_edges, neighbours_of
from stylit_ref.views.packing import coherent_packing
from stylit_ref.views.params import PLAIN, Coherence
from stylit_ref.views.synthesis import CoherentSynthesis


def make_coherent_synthesis(
    style: NDArray[np.uint8],
    source_guides: Sequence[NDArray[np.uint8]],
    target_guides: Sequence[Sequence[NDArray[np.uint8]]],
    edges: Edges,
    params: Params | None = None,
    coherence: Coherence | None = None,
    *,
    seed: int = 0,
    backend: Backend = CPU,
) -> CoherentSynthesis:
    """Check images, motion and parameters, and lay them out for a coherent run.

    Parameters
    ----------
    style, source_guides, params, seed
        As for :func:`stylit_ref.stylize`.
    target_guides : sequence of sequences of (H_B, W_B) or (H_B, W_B, c) uint8
        The guides of every frame, all of one size.
    edges : mapping from (int, int) to Motion
        The motion from frame ``to`` into frame ``other``, by ``(to, other)``.
    coherence : Coherence, optional
    backend : Backend

    Returns
    -------
    CoherentSynthesis

    Raises
    ------
    InputError
        If images, motion or parameters do not fit together; the message names the sizes.
    """
    params, coherence = as_params(params), coherence or Coherence()
    exemplar = make_exemplar(style, source_guides, params, backend=backend)
    targets = [make_target(guides, exemplar) for guides in target_guides]
    if not targets:
        raise InputError("is empty; at least one frame is needed", parameter="target_guides")
    size = targets[0].size
    for frame, target in enumerate(targets):
        if target.size != size:
            raise InputError(
                f"is {size_text(target.size)} but frame 0 is {size_text(size)}; all frames must "
                "have the same size",
                parameter=f"target_guides[{frame}]",
            )
    params = fit_levels(params, exemplar.size, size)
    edges = check_edges(edges, len(targets), size)

    weight = fixed_weight(coherence.weight)
    with_spread = params.traits.chooses_targets and weight > 0 and bool(edges)
    exemplars = {ONE: exemplar} if not with_spread else {}
    runs = []
    for frame, (target, guides) in enumerate(zip(targets, target_guides, strict=True)):
        pulling = len(neighbours_of(edges, frame)) if coherence.form == PLAIN else 0
        style_weight = ONE + pulling * weight
        if style_weight not in exemplars:
            packing = coherent_packing(exemplar.packing, style_weight, with_spread=with_spread)
            texture = _packed(packing, source_guides, as_image(style, "style"))
            exemplars[style_weight] = Exemplar(backend.passes, packing, params.patch_width, texture)
        suited = exemplars[style_weight]
        if suited is not exemplar:
            texture = _packed(suited.packing, guides)
            target = Target(backend.passes, suited.packing, params.patch_width, texture)
        runs.append(Synthesis(suited, target, params, seed, backend.iterate))
    return CoherentSynthesis(runs, edges, coherence, with_spread=with_spread)


def _packed(packing, guides, style=None):
    """Guides and style in one texture, with zeros for the spread if the packing has it."""
    guides = [as_image(guide, "guide") for guide in guides]
    if len(packing.guide_sizes) > len(guides):
        guides.append(np.zeros((*guides[0].shape[:2], 1), np.uint8))
    return packing.pack(guides, style)
