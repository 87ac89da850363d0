"""Reports on publications, a folder each: their plan of runs, tables, claims and pictures.

``report.py`` of a folder is a subcommand of ``python -m eval``, as those of :mod:`eval.reports`.
"""
