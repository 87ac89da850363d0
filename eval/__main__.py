"""Stylize scenes, measure the results, and write a report with tables and pictures."""

import argparse
import ast
import logging
import sys
import warnings
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from pkgutil import iter_modules

from tqdm import tqdm

import eval.documents
import eval.reports
from stylit_ref import InputError
from stylit_ref.machine.interruption import heed_interruptions
from stylit_ref.machine.threads import sleep_while_waiting


def reports():
    """Module names of all reports, by the name of their subcommand; none is imported."""
    found = {module.name: f"eval.reports.{module.name}" for module in _in(eval.reports)}
    return found | {
        module.name: f"eval.documents.{module.name}.report" for module in _in(eval.documents)
    }


def _in(package):
    return iter_modules(package.__path__)


def main(arguments=None):
    """Write a report, or those on all publications if none is named; returns the exit code."""
    arguments = (sys.argv[1:] if arguments is None else arguments) or ["documents"]
    parser = argparse.ArgumentParser(prog="python -m eval", description=__doc__)
    commands = parser.add_subparsers(dest="report", required=True, metavar="REPORT")
    for name, module in sorted(reports().items()):
        text = _text_of(module)
        command = commands.add_parser(name, help=text.partition("\n")[0], description=text)
        if name in arguments[:1]:  # only the chosen report is imported
            try:
                chosen = import_module(module)
            except ModuleNotFoundError as error:
                print(
                    f"eval: reports need packages that are not installed ({error}): install them "
                    "with pip install -e '.[eval]'",
                    file=sys.stderr,
                )
                return 2
            chosen.add_options(command)
    options = parser.parse_args(arguments)
    logging.basicConfig(format="note: %(message)s")
    warnings.showwarning = lambda message, *_: print(f"note: {message}", file=sys.stderr)
    try:
        return chosen.main(options)
    except (InputError, OSError) as error:
        print(f"eval: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("eval: interrupted; finished runs are kept and not computed again", file=sys.stderr)
        return 130


def _text_of(module):
    source = Path(find_spec(module).origin).read_text(encoding="utf-8")
    return ast.get_docstring(ast.parse(source))


if __name__ == "__main__":
    heed_interruptions()
    sleep_while_waiting()
    tqdm.monitor_interval = 0  # beside its thread no process is forked for runs or kernels
    sys.exit(main())
