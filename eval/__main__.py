"""``python -m eval``: reports on a scene."""

import argparse
import sys
import warnings
from pathlib import Path

from eval.bench import bench
from eval.epsilon_report import epsilon_report
from eval.lambda_report import lambda_report
from eval.report import REPORTS
from eval.scenes import BUNDLED, DEFAULT, load_scene
from eval.scenes_report import scenes_report
from eval.schedules_report import UNIFORMITIES, schedules_report
from eval.spilling_report import spilling_report
from eval.stylit_report import stylit_report
from stylit_ref import InputError

REPORTS_ON_A_SCENE = {
    "lambda": lambda_report,
    "epsilon": epsilon_report,
    "stylit": stylit_report,
}


def main(arguments=None):
    """Write one of the reports; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m eval", description=__doc__)
    parser.add_argument(
        "report", choices=(*REPORTS_ON_A_SCENE, "schedules", "bench", "scenes", "spilling")
    )
    parser.add_argument(
        "--scene", default=DEFAULT,
        help=f"TARGET/STYLE, for spilling several with commas between, or a folder of yours "
        f"(default {DEFAULT})",
    )  # fmt: skip
    parser.add_argument("--data", default=BUNDLED, help="folder of a data set (default: bundled)")
    parser.add_argument("--step", type=int, default=1, help="keep every STEPth pixel (default 1)")
    parser.add_argument("--seeds", type=int, nargs="+", default=[0], help="default: 0")
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
        folder = options.output
        if options.report == "scenes":
            folder = folder or REPORTS / f"scenes_{Path(options.data).resolve().name}"
            scenes_report(options.data, folder, options.seeds[0])
        elif options.report == "spilling":
            folder = folder or REPORTS / f"spilling_{Path(options.data).resolve().name}"
            names = options.scene.split(",")
            spilling_report(names, options.data, folder, options.step, options.seeds[0])
        else:
            scene = load_scene(options.scene, options.data, options.step)
            folder = folder or REPORTS / f"{options.report}_{scene.name}_{scene.size}"
        if options.report in REPORTS_ON_A_SCENE:
            report = REPORTS_ON_A_SCENE[options.report]
            report(scene, folder, options.seeds[0], not options.numbers)
        elif options.report == "schedules":
            schedules_report(
                scene, folder, options.seeds, options.uniformities, not options.numbers
            )
        elif options.report == "bench":
            bench(scene, folder, options.ebsynth)
    except InputError as error:
        print(f"eval: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("eval: interrupted; finished runs are kept and not computed again", file=sys.stderr)
        return 130
    print((folder / "report.md").read_text(encoding="utf-8"))
    print(f"Written: {folder / 'report.html'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
