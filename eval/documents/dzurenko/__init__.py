"""The thesis of Dzurenko (2017), chapters 4 and 5, on our scenes."""
