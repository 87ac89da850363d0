"""Test vectors that pin every stage of the algorithm, and a checker for ports of it.

``SPEC.md`` describes the algorithm that they pin.
"""
