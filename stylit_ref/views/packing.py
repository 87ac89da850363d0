"""The weights of a coherent run, and a channel for what no source patch can change.

In StyLit's retrieval source patches choose among target patches. Then the spread S of
:mod:`stylit_ref.views.formulae.fold` counts too: it decides which target patch is chosen, its place
in the error budget, and the test against α. A guide of one channel brings it in without a kernel of
its own. It is √S on the target's side and 0 on the source's, and weighs as much as a channel of the
style, so that its squared difference is S. It lies behind the style, where a style in colour leaves
a channel of this weight free: in front of it, the pixels of four guides in colour would take twice
the memory.
"""

from dataclasses import replace

import numpy as np

from stylit_ref.machine.vector_ssd import LANES
from stylit_ref.metric.packing import Packing
from stylit_ref.views.formulae.fold import ONE as WEIGHT_ONE


def coherent_packing(packing: Packing, style_weight: int, *, with_spread: bool) -> Packing:
    """Weigh the style anew, and add the channel for the spread behind it.

    Parameters
    ----------
    packing : Packing
    style_weight : int
        A factor in units of 1/256: 256, or 256 (1 + Σ λ_c) of the plain form.
    with_spread : bool

    Returns
    -------
    Packing
        If ``with_spread``, its last guide is the spread.
    """
    first, behind = packing.style_channel, packing.style_channel + packing.style_channels
    of_channel = (int(packing.weights[first]) * style_weight + WEIGHT_ONE // 2) // WEIGHT_ONE
    weights = [*packing.weights[:first], *[of_channel] * (packing.style_channels + with_spread)]
    if with_spread:
        packing = replace(
            packing,
            guide_channels=(*packing.guide_channels, behind),
            guide_sizes=(*packing.guide_sizes, 1),
        )
    weights += [0] * (-len(weights) % LANES)
    return replace(packing, channels=len(weights), weights=np.array(weights, np.int64))
