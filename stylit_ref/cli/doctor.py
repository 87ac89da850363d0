"""``stylit-ref doctor``: what there is for a GPU."""


def add_parser(commands):
    """Add the command."""
    parser = commands.add_parser(
        "doctor",
        help="say what there is for a GPU",
        description="Say what of a GPU's software is installed, and what is missing.",
        allow_abbrev=False,
    )
    parser.set_defaults(command=run, parser=parser)


def run(_):
    """Print the report; a missing part is what it is about, not an error."""
    try:
        from gpu_cuda.host.doctor import report
    except ImportError as error:  # of numba-cuda, where a part of it is not installed
        print(f"GPU           none: the kernels cannot be loaded: {error}")
    else:
        print(*report(), sep="\n")
