"""Which random number belongs to which draw."""
