"""The interface of ports: the library calls foreign modules of passes by these names.

A change here breaks every such module. Parameter names count too: callers may use them as
keywords. Annotations are free to change.
"""

from signatures import signature

from stylit_ref import passes
from stylit_ref.metric.textures import Textures

PASSES = """\
box_sum(values, patch_width)
claim_errors(textures, patch_width, claims, errors)
commit(nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight, patch_width, stream, moves)
count_assignments(nnf, source_size)
download(array)
downsample(image)
energy(nnf, delta, omega_sums)
guide_map(texture, sums, weights, patch_width, epsilon, white)
invert_nnf(nnf, delta, patch_width, inverse, inverse_delta)
lose_claims(claims, taken, states)
means(texture, sums, patch_width, first)
moments_storage(height, width, lanes)
occurrence_map(nnf, omega, omega_sums, patch_width)
patch_moments(texture, moments, patch_width, first, style_channel, style_channels, style_only=False)
propagate_claims(textures, taken, patch_width, claims, errors, states, new_claims, new_errors, new_states, distance)
propagation(textures, omega_sums, occurrence_weight, patch_width, nnf, delta, new_nnf, new_delta, distance)
random_nnf(nnf, patch_width, source_height, source_width, stream)
random_search(textures, omega_sums, occurrence_weight, patch_width, nnf, delta, new_nnf, new_delta, stream, side=None)
repeat_edge(image, radius)
replay_vote(style, means, nnf, patch_width, scale, outliers=0)
scanline(source, target, weights, omega, occurrence_weight, patch_width, nnf, stream, reverse)
search_claims(textures, taken, patch_width, claims, errors, states, new_claims, new_errors, new_states, stream)
settle_claims(claims, errors, last_error, last_claims, limits, taken, patch_width, nnf, delta)
similarity(textures, patch_width, nnf, delta)
upload(array)
upsample_nnf(coarse_nnf, nnf, patch_width, source_height, source_width)
vote(source, target, nnf, patch_width, style_channel, style_channels, outliers=0)
wait()
zeros(shape, dtype)
"""  # noqa: E501

TEXTURES = (
    "(source, target, source_moments, target_moments, weights, pair_weights, moment_weights, "
    "guide_map=None, source_sums=None, target_sums=None, style_pair_weights=None)"
)


def test_passes_are_called_by_these_names():
    lines = [f"{name}{signature(getattr(passes, name))}\n" for name in sorted(passes.__all__)]
    assert "".join(lines) == PASSES


def test_textures_have_these_fields_in_this_order():
    assert signature(Textures) == TEXTURES
