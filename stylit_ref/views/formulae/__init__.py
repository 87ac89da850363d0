"""The equations of coherence: where a point appears in another frame, and the folded term (3.1)."""
