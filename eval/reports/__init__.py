"""Reports, one a file: each is a subcommand of ``python -m eval`` by its being here.

The first line of its text is its help. ``add_options(parser)`` declares what it may be told,
``main(options)`` makes the report and returns the exit code.
"""
