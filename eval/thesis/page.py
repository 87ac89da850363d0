"""The report: every table and figure, as Markdown, as one self-contained page, and as CSV."""

import base64
import hashlib
import json
import re
import shutil
from pathlib import Path
from tempfile import TemporaryDirectory

import pandas as pd
from tqdm import tqdm

from eval.circumstances import circumstances
from eval.report import html_page, table
from eval.runs import LIBRARY_DIGEST, stored
from eval.thesis import pictures, published, tables
from eval.thesis.claims import claims
from eval.thesis.quality import DEFINITIONS, MEASURES

INPUTS = "inputs.json"
"""What a report was made of: where nothing of it changed, it stands."""

_PARTIAL = ".partial_"


def write_page(plan, folder):
    """Write ``index.html``, ``report.md``, figures and a CSV of every table.

    Parameters
    ----------
    plan : Plan
        Its runs stored.
    folder : Path

    Returns
    -------
    bool
        False if the report there is made of the same runs by the same code and was left alone.
    """
    inputs = _inputs(plan)
    if _is_up_to_date(folder, inputs):
        return False
    folder.mkdir(parents=True, exist_ok=True)
    for killed in folder.glob(f"{_PARTIAL}*"):
        shutil.rmtree(killed)
    with TemporaryDirectory(prefix=_PARTIAL, dir=folder) as partial:
        files = _write_files(plan, Path(partial))
        record = {"inputs": inputs, "files": sorted(files)}
        text = json.dumps(record, indent=1) + "\n"
        (Path(partial) / INPUTS).write_text(text, encoding="utf-8")
        for file in (*_files_of(folder), INPUTS):
            (folder / file).unlink(missing_ok=True)
        for file in (*files, INPUTS):  # the record last: without it the report is made again
            (Path(partial) / file).replace(folder / file)
    return True


def _write_files(plan, folder):
    """Write all but the record; returns the files' names."""
    writer = _Writer(folder)
    sections = [f"# Chapters 4 and 5 of the thesis, preset {plan.name}", _preface(plan)]
    similarities = {target: tables.similarity_table(plan, target) for target in plan.scenes}
    sections += _claims(claims(plan, similarities), writer)
    for target in tqdm(plan.scenes, unit="target", disable=None):
        sections += _target(plan, target, similarities[target], writer)
    sections += _overall(plan, writer)
    sections += ["## What the numbers are", DEFINITIONS, tables.SIMILARITY_DEFINITIONS]
    text = "\n\n".join(sections) + "\n"
    (folder / "report.md").write_text(text, encoding="utf-8")
    page = html_page(sections[0].strip("# "), text)
    embedded = re.sub(r'src="([^"]+\.webp)"', lambda match: _embedded(folder, match[1]), page)
    (folder / "index.html").write_text(embedded, encoding="utf-8")
    return writer.files


class _Writer:
    """Files of a report, and the Markdown that shows them."""

    def __init__(self, folder):
        self.folder, self.files = folder, ["report.md", "index.html"]

    def figure(self, name, caption, draw, *arguments):
        """Draw a figure to a file."""
        file = f"{name}.webp"
        draw(*arguments, self.folder / file)
        self.files.append(file)
        return f"![{caption}]({file})"

    def table(self, name, numbers, shown):
        """Write a table's numbers as CSV and show its text."""
        return f"{table(shown)}\n\n{self.csv(name, numbers)}"

    def csv(self, name, numbers):
        """Write a table's numbers as CSV and link them."""
        file = f"{name}.csv"
        numbers.to_csv(self.folder / file, index=False)
        self.files.append(file)
        return f"[{file}]({file})"


def _preface(plan):
    scene = plan.scenes[plan.background]
    made = sorted({stored(job).made for job in plan.jobs})
    seeds = ", ".join(
        f"{target} {' '.join(map(str, seeds))}" for target, seeds in plan.seeds.items()
    )
    return (
        f"Our scenes at {scene.size}, the thesis' configuration (4.1): patch width 5, 6 levels "
        "(fewer where the image is too small), 6 votes, 6 PatchMatch iterations, μ = 2; λ = 10000 "
        f"where none is said. Seeds: {seeds}; times are of the first. Published times are of a "
        "GeForce GTX 660, StyLit's of four threads of a CPU, at 1200x912: compare ratios, not "
        "seconds. Our times are of the synthesis, kernels compiled before, on:\n\n"
        + "\n".join(f"- {line}" for line in made)
        + f"\n\nReport: {circumstances()}"
    )


def _claims(found, writer):
    errata = published.errata()
    return [
        "## What the thesis says, and what we found",
        *(
            f"- **{row.claim}** ({row.section}): **{row.verdict}**. {row.evidence}. "
            f"*Held if {row.rule}.*"
            for row in found.itertuples()
        ),
        writer.csv("claims", found),
        "### Errata",
        "Rows of the published tables whose ratio does not follow from their times, rounding "
        "allowed for:",
        writer.table("errata", errata, tables.formatted_times(errata)),
    ]


def _target(plan, target, similarity, writer):
    lambda_times, epsilon_times = (
        make(plan, target) for make in (tables.lambda_times, tables.epsilon_times)
    )
    quality = tables.quality_table(plan, target)
    known = target in published.TARGETS
    numbers = [
        f" ({published.figure(printed, target)})" if known else ""
        for printed in (published.LAMBDA, published.EPSILON)
    ]
    return [
        f"## {target}",
        f"### λ{numbers[0]}",
        writer.figure(f"lambda_{target}", f"λ on {target}", pictures.lambda_figure, plan, target),
        writer.table(f"lambda_times_{target}", lambda_times, tables.formatted_times(lambda_times)),
        f"### ε{numbers[1]}",
        writer.figure(f"epsilon_{target}", f"ε on {target}", pictures.epsilon_figure, plan, target),
        writer.table(
            f"epsilon_times_{target}", epsilon_times, tables.formatted_times(epsilon_times)
        ),
        writer.table(
            f"similarity_{target}", similarity, tables.formatted(similarity, tables.SIMILARITIES)
        ),
        f"### Quality on {target}",
        writer.table(f"quality_{target}", quality, tables.formatted(quality, MEASURES)),
    ]


def _overall(plan, writer):
    shared = tables.shared_memory(plan)
    sections = [
        "## All targets",
        "### Time and quality",
        writer.figure("trends", "time and quality against λ and ε", pictures.trends_figure, plan),
        "### Energy",
        writer.figure("energy", "mean φ by iteration", pictures.energy_figure, plan),
        "### Shared memory (5.1.3)",
        writer.table("shared_memory", shared, tables.formatted_times(shared)),
    ]
    if not any(plan.gpu_records(target) for target in plan.scenes):
        ptx = pd.read_csv(CHECKOUT / "reports" / "ptx" / "ptx.csv")
        ptx = ptx[ptx["kernel"].str.match(r"(propagation|random_search)(, shared)?$")]
        sections += [
            "No GPU was at hand, so there are no times of ours. What is known without one: in "
            "Numba's simulator both kernels give the same bytes, and the assembler says of them:",
            writer.table("shared_memory_ptx", ptx, ptx),
        ]
    return [
        *sections,
        f"## Background: {plan.background}",
        "### Other methods (1.1)",
        writer.figure("background", "methods compared", pictures.background_figure, plan),
        "(d) is Hertzmann et al. 2001 with the first guide alone, as in the thesis; (g) is StyLit "
        "with every patch of the style used alike, in the manner of Jamriška et al. 2015.",
        "### Coarse to fine (2.3)",
        writer.figure("pyramid", "B' as it leaves each level", pictures.pyramid_figure, plan),
    ]


CHECKOUT = Path(__file__).parents[2]


def _inputs(plan):
    """Identifies everything a report is made of."""
    code = hashlib.sha256()
    here = Path(__file__)
    numbers = [*here.parent.glob("published/*.csv"), *(CHECKOUT / "reports" / "ptx").glob("*.csv")]
    for file in sorted([*here.parents[1].rglob("*.py"), *numbers]):
        code.update(file.read_bytes())
    records = [plan.gpu_records(target) for target in plan.scenes]
    identity = [plan.name, [job.key for job in plan.jobs], records, LIBRARY_DIGEST]
    code.update(json.dumps(identity).encode())
    return code.hexdigest()


def _record(folder):
    """What a report says it was made of; nothing where there is none."""
    try:
        record = json.loads((folder / INPUTS).read_text(encoding="utf-8"))
        return {"inputs": record["inputs"], "files": list(map(str, record["files"]))}
    except (OSError, ValueError, KeyError, TypeError):
        return {"inputs": None, "files": []}


def _files_of(folder):
    return [file for file in _record(folder)["files"] if Path(file).name == file]


def _is_up_to_date(folder, inputs):
    files = _files_of(folder)
    return _record(folder)["inputs"] == inputs and all((folder / file).exists() for file in files)


def _embedded(folder, file):
    data = base64.b64encode((folder / file).read_bytes()).decode()
    return f'src="data:image/webp;base64,{data}"'
