"""The pictures that the notebooks begin with: ``python docs/notebook_pictures.py``.

Run it after ``make docs``. Each is drawn by the notebook's own cell with the tag ``picture``.
"""

from base64 import b64decode
from io import BytesIO
from pathlib import Path

import nbformat
from PIL import Image

ROOT = Path(__file__).parents[1]
WIDTH = 800

for file in sorted((ROOT / "build/jupyter_execute/notebooks").glob("*.ipynb")):
    cells = nbformat.read(file, as_version=4).cells
    [cell] = [cell for cell in cells if "picture" in cell.metadata.get("tags", ())]
    drawn = [
        output.data["image/png"] for output in cell.outputs if "image/png" in output.get("data", ())
    ]
    picture = Image.open(BytesIO(b64decode(drawn[0]))).convert("RGB")
    height = round(picture.height * WIDTH / picture.width)
    picture.resize((WIDTH, height), Image.Resampling.LANCZOS).save(
        ROOT / "notebooks" / "pictures" / f"{file.stem}.webp", quality=80, method=6
    )
