"""Moments of every patch: none here.

On the CPU they give a lower bound of δ that rejects most candidates. The kernels evaluate δ itself,
as those of the thesis do, and make the same decisions.
"""


def moments_storage(height, width, lanes):
    """As :func:`stylit_ref.passes.moments_storage`: nothing."""


def patch_moments(
    texture, moments, patch_width, first, style_channel, style_channels, style_only=False
):
    """As :func:`stylit_ref.passes.patch_moments`: nothing to do."""
