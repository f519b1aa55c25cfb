"""Puts the site together: Python and our packages, the page's own files, the pages."""

import gzip
import hashlib
import json
import shutil
import zipfile
from pathlib import Path

import demos  # noqa: F401  (with it, its helpers are found)
from gallery.catalogue import C_NAMES, NAMES, load
from tools.pyodide import parts
from tools.site import pages

ROOT = Path(__file__).parents[2]
PAGE = Path(__file__).with_name("page")
SCREEN = ROOT / "bgi" / "monitor" / "web" / "page"
"""The web monitor's page, whose screen, keys and sounds are this one's, too."""
SHARED = [
    *("board", "fit", "icon", "keyboard", "keys", "lens", "mouse", "pointer", "png", "screen"),
    "sound",
]
PACKAGE = "pybgi.zip"
MOST = 12_000_000
"""Bytes of a first visit."""

_KINDS = ".py", ".CHR", ".bin", ".txt"


def build(folder: Path, numpy: Path) -> int:
    """Build the site in a folder, in place of what is there; returns the bytes of a first visit."""
    if folder.exists():
        shutil.rmtree(folder)
    python = folder / "python"
    python.mkdir(parents=True)
    _copy_python(python, numpy)
    write_pages(folder)
    loaded = _first_visit(folder)
    assert loaded <= MOST, f"a first visit loads {loaded:,} bytes"
    parts_bytes = sum(file.stat().st_size for file in python.iterdir())
    _write_contents(folder, [numpy.name, PACKAGE], parts_bytes)
    _write_service_worker(folder)
    return loaded


def write_pages(folder: Path) -> None:
    """Write all that is not Python."""
    shutil.copytree(ROOT / "docs" / "pictures", folder / "pictures")
    for file in [*PAGE.iterdir(), *SCREEN.iterdir()]:
        own = file.parent == PAGE
        if file.suffix in (".js", ".css", ".svg") and (own or file.stem in SHARED):
            shutil.copy(file, folder)
    pages.write_docs(folder)
    pages.write_gallery(folder, [load(name) for name in (*NAMES, *C_NAMES)])


def _copy_python(python: Path, numpy: Path) -> None:
    for name in parts.CORE_FILES:
        data = (parts.core() / name).read_bytes()
        if name.endswith(".wasm"):  # not every host packs what it sends: page/parts.js unpacks it
            (python / f"{name}.packed").write_bytes(gzip.compress(data, 9, mtime=0))
        else:
            (python / name).write_bytes(data)
    shutil.copy(numpy, python)
    with zipfile.ZipFile(python / PACKAGE, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as package:
        package.write(PAGE / "runner.py", "runner.py")
        for name in ("bgi", "surfaces", "demos"):
            for file in sorted((ROOT / name).rglob("*")):
                if file.is_file() and "__pycache__" not in file.parts and file.suffix in _KINDS:
                    package.write(file, file.relative_to(ROOT))


def _first_visit(folder: Path) -> int:
    """The bytes of the first page with everything that it may load."""
    loaded = [*(folder / "python").iterdir(), *folder.glob("*.*")]
    loaded += [folder / "pictures" / f"{name}.png" for name in (*NAMES, *C_NAMES)]
    return sum(file.stat().st_size for file in loaded)


def _write_contents(folder: Path, wheels: list[str], size: int) -> None:
    site = {"parts": wheels, "bytes": size}
    text = f"// By tools/site/build.py.\nexport const SITE = {json.dumps(site)};\n"
    (folder / "contents.js").write_text(text, encoding="utf-8")


def _write_service_worker(folder: Path) -> None:
    """Tell it what to keep, and under which name: another one for other files."""
    every = sorted(file for file in folder.rglob("*") if file.is_file())
    version = hashlib.sha256(b"".join(hashlib.sha256(f.read_bytes()).digest() for f in every))
    kinds = ".html", ".js", ".css", ".svg"
    kept = [file.relative_to(folder).as_posix() for file in every if file.suffix in kinds]
    text = (PAGE / "sw.js").read_text("utf-8")
    text = text.replace("@VERSION@", f"pybgi-{version.hexdigest()[:16]}")
    text = text.replace('["@FILES@"]', json.dumps(["./", *kept]))
    (folder / "sw.js").write_text(text, encoding="utf-8")
