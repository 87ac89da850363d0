"""The energy that the run reports after its last search."""

from eval.number import Number

NUMBERS = {
    "delta": Number("δ", "{:.0f}"),
    "penalization": Number("λρ", "{:.0f}"),
    "phi": Number("φ", "{:.0f}"),
}

DEFINITION = """\
- **δ**, **λρ**, **φ**: means over all target patches when the last PatchMatch iteration of the
  finest level ends (squared 8-bit steps; thesis 2.1, 2.2)."""


def measure(scene, outcome):
    """δ, and for methods with an occurrence map also λρ and their sum φ."""
    if outcome.history.empty:
        return {}
    last = outcome.history.iloc[-1]
    numbers = {"delta": float(last["delta"])}
    if "penalization" in last:
        numbers["penalization"] = float(last["penalization"])
        numbers["phi"] = numbers["delta"] + numbers["penalization"]
    return numbers
