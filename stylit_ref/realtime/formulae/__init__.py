"""The equations of the thesis, of one pixel, entry or candidate each."""
