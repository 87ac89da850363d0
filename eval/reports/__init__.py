"""Reports, one file each: every file in this folder is a subcommand of ``python -m eval``.

The first line of its docstring is its help. ``add_options(parser)`` declares its options;
``main(options)`` makes the report and returns the exit code.
"""
