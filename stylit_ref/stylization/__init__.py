"""Stylization with an occurrence map, guide maps or an error budget (thesis 2 to 5)."""
