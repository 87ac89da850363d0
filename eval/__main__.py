"""``python -m eval``: the thesis' tables, and reports on a scene."""

import argparse
import sys
import warnings
from pathlib import Path

from eval.bench import bench
from eval.epsilon_report import epsilon_report
from eval.report import REPORTS
from eval.scenes import BUNDLED, DEFAULT, load_scene
from eval.scenes_report import scenes_report
from eval.schedules_report import UNIFORMITIES, schedules_report
from eval.spilling_report import spilling_report
from eval.stylit_report import stylit_report
from eval.thesis.evaluation import evaluate
from eval.thesis.plan import PRESETS, own_scene, preset
from stylit_ref import InputError
from stylit_ref.machine.interruption import heed_interruptions
from stylit_ref.machine.threads import sleep_while_waiting
from stylit_ref.stylization.backends import BACKENDS

REPORTS_ON_A_SCENE = {
    "epsilon": epsilon_report,
    "stylit": stylit_report,
}


def main(arguments=None):
    """Write one of the reports; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m eval", description=__doc__)
    parser.add_argument(
        "report",
        choices=("thesis", *REPORTS_ON_A_SCENE, "schedules", "bench", "scenes", "spilling"),
    )
    parser.add_argument(
        "--scene",
        help=f"a folder of yours; or TARGET/STYLE (default {DEFAULT}), for spilling several with "
        "commas between",
    )
    parser.add_argument(
        "--preset", choices=PRESETS, default="quick",
        help="of the thesis: bundled scenes, or all of 'make data' at 1200x912 (default quick)",
    )  # fmt: skip
    parser.add_argument(
        "--targets", help="of the thesis' preset, commas between (default: all seven)"
    )
    parser.add_argument(
        "--style", type=Path, help="painting in the place of the folder's source_style"
    )
    parser.add_argument(
        "--backend", choices=BACKENDS, default="cpu", help="for the thesis (default cpu)"
    )
    parser.add_argument("--scheduler", help="for the thesis: address of a Dask cluster")
    parser.add_argument("--data", help="folder of a data set (default: bundled)")
    parser.add_argument("--step", type=int, default=1, help="keep every STEPth pixel (default 1)")
    parser.add_argument(
        "--seeds", type=int, nargs="+", help="default: 0; for the thesis also 1 and 2 of one target"
    )
    parser.add_argument(
        "--uniformities", type=float, nargs="+", default=UNIFORMITIES, metavar="λ",
        help="for the schedules (default: those of the thesis)",
    )  # fmt: skip
    parser.add_argument(
        "--numbers", action="store_true", help="no images, for scenes that are not yours to share"
    )
    parser.add_argument("--ebsynth", help="binary to measure beside, for the bench")
    parser.add_argument("--output", type=Path, help="folder (default: reports/REPORT_SCENE_SIZE)")
    options = parser.parse_args(arguments)
    warnings.showwarning = lambda message, *_: print(f"note: {message}", file=sys.stderr)
    try:
        if options.report == "thesis":
            return _thesis(options)
        folder, data, seeds = options.output, options.data or BUNDLED, options.seeds or [0]
        if options.report == "scenes":
            folder = folder or REPORTS / f"scenes_{Path(data).resolve().name}"
            scenes_report(data, folder, seeds[0])
        elif options.report == "spilling":
            folder = folder or REPORTS / f"spilling_{Path(data).resolve().name}"
            names = (options.scene or DEFAULT).split(",")
            spilling_report(names, data, folder, options.step, seeds[0])
        else:
            scene = load_scene(options.scene or DEFAULT, data, options.step)
            folder = folder or REPORTS / f"{options.report}_{scene.name}_{scene.size}"
        if options.report in REPORTS_ON_A_SCENE:
            report = REPORTS_ON_A_SCENE[options.report]
            report(scene, folder, seeds[0], not options.numbers)
        elif options.report == "schedules":
            schedules_report(scene, folder, seeds, options.uniformities, not options.numbers)
        elif options.report == "bench":
            bench(scene, folder, options.ebsynth)
    except (InputError, OSError) as error:
        print(f"eval: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("eval: interrupted; finished runs are kept and not computed again", file=sys.stderr)
        return 130
    print((folder / "report.md").read_text(encoding="utf-8"))
    print(f"Written: {folder / 'report.html'}")
    return 0


def _thesis(options):
    """The report on the thesis; returns the exit code."""
    where = {"backend": options.backend, "scheduler": options.scheduler}
    if options.scene:
        plan = own_scene(options.scene, options.style, options.seeds, **where)
    else:
        targets = options.targets.split(",") if options.targets else None
        plan = preset(options.preset, options.data, targets, options.step, options.seeds, **where)
    folder = evaluate(plan, options.output)
    if folder is None:
        return 1
    print(f"Written: {folder / 'index.html'}")
    return 0


if __name__ == "__main__":
    heed_interruptions()
    sleep_while_waiting()
    sys.exit(main())
