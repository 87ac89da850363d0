"""The picture of the viewer's page, after ``make viewer``: ``python -m docs.how_to.viewer``."""

import io
import shutil
from pathlib import Path

from PIL import Image
from playwright.sync_api import sync_playwright

PAGE = Path("build/viewer/house.html")
PICTURE = Path("docs/pictures/viewer.webp")

with sync_playwright() as driver:
    browser = driver.chromium.launch(
        executable_path=shutil.which("chromium"), args=["--headless", "--no-sandbox"]
    )
    page = browser.new_page(viewport={"width": 760, "height": 700})
    page.goto(f"{PAGE.absolute().as_uri()}?view=1.25,1")
    page.wait_for_function("document.getElementById('view')?.textContent")
    shot = page.screenshot()
    browser.close()
Image.open(io.BytesIO(shot)).convert("RGB").save(PICTURE, quality=70, method=6)
