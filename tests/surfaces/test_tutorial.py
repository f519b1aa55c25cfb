"""The tutorial: every block of code runs, one after the other, and every picture is there.

`python -m tests.surfaces.test_tutorial` draws the pictures anew, each by the code above it.
"""

import os
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import bgi

DOCS = Path(__file__).parents[2] / "docs"
TEXT = (DOCS / "surfaces.md").read_text(encoding="utf-8")


def run() -> Iterator[str]:
    """Run block after block; where a picture stands, its name, with the page it shows active."""
    script: dict[str, object] = {}
    found = re.finditer(r"^```python\n(.*?)^```|\]\((pictures/.*?)\)", TEXT, re.M | re.S)
    for code, picture in (match.groups() for match in found):
        if code:
            exec(compile(code, "docs/surfaces.md", "exec"), script)
        else:
            bgi.setactivepage(bgi.getvisualpage())
            yield picture


def test_every_block_runs_and_has_drawn(capsys: pytest.CaptureFixture[str]) -> None:
    for picture in run():
        pixels = bgi.getpixel(*([*range(0, 640, 3)] * 160, sorted([*range(0, 480, 3)] * 214)))
        assert pixels.astype(bool).mean() > 0.02, picture
    assert "characters of SVG" in capsys.readouterr().out
    with pytest.raises(bgi.BGIError, match="initgraph"):
        bgi.getmaxx()


@pytest.mark.parametrize("picture", re.findall(r"\]\((pictures/.*?)\)", TEXT))
def test_every_picture_is_there(picture: str) -> None:
    assert (DOCS / picture).read_bytes().startswith(b"\x89PNG")


if __name__ == "__main__":
    os.environ["BGI_MONITOR"] = "none"
    for picture in run():
        bgi.writeimagefile(DOCS / picture)
