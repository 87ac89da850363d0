"""The passes: loops over a patch or the whole of S that apply the formulae."""
