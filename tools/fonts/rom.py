"""Make the fonts of the text screen, `bgi/fonts/data/rom8x8.bin` and its like.

    python -m tools.fonts.rom vgafonts.h [folder]

The file is that of the free VGA BIOS which Bochs uses, vgabios/vgafonts.h: three tables of bytes in
C. Its fonts are in the public domain: see bgi/fonts/data/ROM.txt.
"""

import re
import sys
from pathlib import Path

from bgi.fonts import DATA
from bgi.fonts.rom import HEIGHTS


def table(text: str, height: int) -> bytes:
    """The rows of the 256 glyphs that are so high."""
    found = re.search(rf"vgafont{height}\[256\*{height}\]=\s*{{(.*?)}}", text, re.DOTALL)
    rows = bytes(int(number, 16) for number in re.findall(r"0x\w\w", found[1] if found else ""))
    if len(rows) != 256 * height:
        raise ValueError(f"no table of 256 glyphs, {height} rows high")
    return rows


def main(source: str, folder: str = DATA) -> None:
    """Write the three files."""
    text = Path(source).read_text("ascii")
    for height in HEIGHTS:
        (Path(folder) / f"rom8x{height}.bin").write_bytes(table(text, height))


if __name__ == "__main__":
    main(*sys.argv[1:])
