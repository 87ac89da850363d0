"""Reports on publications, one folder each: the plan of runs, tables, claims and pictures.

The ``report.py`` of a folder is a subcommand of ``python -m eval``, like those of
:mod:`eval.reports`.
"""
