"""Write a RUN (:mod:`stylit_ref.views.run_folder`) as frames finish."""

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from stylit_ref.errors import InputError
from stylit_ref.files.colour.profile import ColourProfile
from stylit_ref.files.disk.whole_file import write_text
from stylit_ref.files.field import Field
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.motion_exr import write_motion
from stylit_ref.files.nnf_file import write_nnf
from stylit_ref.files.npy_file import write_arrays
from stylit_ref.files.write_image import write_image
from stylit_ref.views.frame_result import FrameResult
from stylit_ref.views.mesh import Mesh
from stylit_ref.views.positions import Positions
from stylit_ref.views.problem import Problem
from stylit_ref.views.run_files import UNFINISHED_FILE, begin_run, files_of_run
from stylit_ref.views.run_folder import CONVENTION, RUN_FILE, SCHEMA, VERSION, Run, digest_of


class RunWriter:
    """Writes a RUN as frames finish. Without :meth:`finish` the folder is none.

    Parameters
    ----------
    folder : str or Path
        It is made if it does not exist; the files of a RUN in it are removed.
    problem : Problem
    encodings : sequence of GuideEncoding
        How the guides became 8 bits.
    grid : tuple of 2 int, optional
        Rows and columns, if the frames are a grid of views, row by row.
    cameras : sequence of mapping, optional
        For every frame what is known of its camera, as JSON can hold it.
    profile : ColourProfile, optional
        Of the style, for the pictures.
    mesh : Mesh, optional
        What the views show, for views between them.
    positions : callable, optional
        Or the positions of a frame's points, by its number.

    Raises
    ------
    InputError
        If the folder cannot be written, or holds something and is no RUN.
    """

    folder: Path

    def __init__(
        self,
        folder: str | Path,
        problem: Problem,
        *,
        encodings: Sequence[GuideEncoding] = (),
        grid: tuple[int, int] | None = None,
        cameras: Sequence[Mapping[str, Any]] | None = None,
        profile: ColourProfile | None = None,
        mesh: Mesh | None = None,
        positions: Callable[[int], Positions] | None = None,
    ) -> None:
        self.folder = Path(folder)
        self._problem, self._encodings, self._profile = problem, tuple(encodings), profile
        shot = problem.shot
        self._files = files_of_run(shot.names, shot.pairs, problem.style, problem.source_guides)
        begin_run(self.folder, self._files)
        self._digests: dict[str, str] = {}
        self._facts: dict[str, Any] = {
            "schema": SCHEMA,
            "version": VERSION,
            "convention": CONVENTION,
            "size": list(shot.size),
            "grid": None if grid is None else list(grid),
            "params": asdict(problem.params),
            "coherence": asdict(problem.coherence),
            "seed": int(problem.seed),
            "style": self._image(self._files.style, problem.style),
            "source_guides": [
                self._image(file, guide)
                for file, guide in zip(
                    self._files.source_guides, problem.source_guides, strict=True
                )
            ],
            "guide_encodings": [encoding.to_dict() for encoding in self._encodings],
            "frames": [
                {"name": name, "camera": None if cameras is None else dict(cameras[frame])}
                for frame, name in enumerate(shot.names)
            ],
            "motion": [
                {"to": to, "other": other, "file": self._files.motion[to, other]}
                for to, other in shot.pairs
            ],
        }
        if mesh is not None:
            self._facts["mesh"] = self._arrays(self._files.mesh, mesh)
        if positions is not None:
            for frame, (facts, file) in enumerate(
                zip(self._facts["frames"], self._files.positions, strict=True)
            ):
                facts["positions"] = self._arrays(file, positions(frame))

    def add(self, result: FrameResult) -> None:
        """Write the picture and the NNF of a frame, and the motion from it into others."""
        frame = self._facts["frames"][result.frame]
        frame["picture"] = self._files.pictures[result.frame]
        frame["nnf"] = self._files.nnfs[result.frame]
        write_image(self.folder / frame["picture"], result.image, profile=self._profile)
        params, style = self._problem.params, self._problem.style
        mask = self._problem.shot.mask(result.frame)
        if mask is not None:
            self._facts["has_masks"] = True
        field = Field(
            result.nnf, params.patch_width, params.vote_outliers, style.shape[:2], mask,
            self._encodings,
        )  # fmt: skip
        write_nnf(self.folder / frame["nnf"], field)
        self._note(frame["picture"], frame["nnf"])
        for pair, file in self._files.motion.items():
            if pair[0] == result.frame:
                write_motion(self.folder / file, *self._problem.shot.motion(*pair))
                self._note(file)

    def finish(self) -> "Run":
        """Write ``run.json``, when every frame has been added.

        Returns
        -------
        Run
        """
        missing = [frame["name"] for frame in self._facts["frames"] if "picture" not in frame]
        if missing:
            raise InputError(
                f"{self.folder}: the frames {', '.join(missing)} have not been added; a RUN has all"
            )
        facts = self._facts | {"digests": self._digests}
        write_text(self.folder / RUN_FILE, json.dumps(facts, indent=1) + "\n")
        (self.folder / UNFINISHED_FILE).unlink(missing_ok=True)
        return Run(self.folder)

    def _image(self, file, image):
        """Write an image, exactly; OpenImageIO would divide by alpha."""
        if not file.endswith(".png"):
            return self._arrays(file, [image])
        write_image(self.folder / file, image)
        self._note(file)
        return file

    def _arrays(self, file, arrays):
        write_arrays(self.folder / file, list(arrays))
        self._note(file)
        return file

    def _note(self, *files):
        for file in files:
            self._digests[file] = digest_of(self.folder / file)
