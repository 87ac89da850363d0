"""Spilling: target patches that were taken from another object (thesis 5.2.4)."""

from eval.number import Number

NUMBERS = {"spilled": Number("spilled", "{:.2%}")}

DEFINITION = """\
- **spilled**: target patches whose source patch is centred on another object."""


def measure(scene, outcome):
    """The share of spilled patches, if the scene has object ids."""
    if scene.ids is None or outcome.nnf is None:
        return {}
    return {"spilled": float(spilling(outcome.nnf, scene.ids).mean())}


def spilling(nnf, ids):
    """Target patches whose source patch is centred on another object than they are.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
    ids : tuple of (H_A, W_A, n) and (H_B, W_B, n) uint8
        Of source and target, a colour for each object.

    Returns
    -------
    (H_B, W_B) bool
    """
    source_ids, target_ids = ids
    return (source_ids[nnf[:, :, 0], nnf[:, :, 1]] != target_ids).any(axis=2)
