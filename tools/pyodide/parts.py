"""Pyodide, which is Python for the browser, and numpy for it: fetched once, checked, and kept.

They come by the ordinary clients, npm and pip, and lie outside of the repository, in the user's
cache. Nobody else than Pyodide's own host publishes numpy for it on its own; the wheel is taken out
of a package of PyPI's index that ships it, unchanged and checked by its checksum. Nothing else of
that package is used or passed on. A site that is published may be given the wheel of Pyodide's own
release instead: `python -m tools.site --numpy WHEEL`.
"""

import hashlib
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

VERSION = "314.0.7"
CORE_FILES = (
    "pyodide.mjs",
    "pyodide.asm.mjs",
    "pyodide.asm.wasm",
    "python_stdlib.zip",
    "pyodide-lock.json",
)
_CORE_SHA256 = "66b7949e5a0cba2250b586d7e368bf12fb482800748d182c4618254b685ffaa0"

_SHIPPED_IN = "open-webui==0.12.4"
_SHIPPED_AT = "open_webui/frontend/pyodide/"
NUMPY = "numpy-2.4.3-cp314-cp314-pyemscripten_2026_0_wasm32.whl"
PILLOW = "pillow-12.2.0-cp314-cp314-pyemscripten_2026_0_wasm32.whl"  # for tests
_SHA256 = {
    NUMPY: "0cad9c1b91f0082e4f959bc0e0bf5835a2efbba6ab3b1e9d1fe6e7e564cca98e",
    PILLOW: "a50d83a8a76d646768e99e93ed5bf365d0b83563fd8b597e77562e75c8f575a9",
}

TEST_WHEELS = (
    "pytest==9.2.0",
    "pluggy==1.7.0",
    "iniconfig==2.3.1",
    "packaging==26.4",
    "pygments==2.21.0",
    "hypothesis==6.155.7",
    "sortedcontainers==2.4.0",
    "attrs==26.1.0",
    "markdown-it-py==4.3.0",
    "mdurl==0.1.2",
)
"""What the tests need, all of it pure Python."""


class Missing(Exception):
    """A part cannot be had; says why."""


def cache() -> Path:
    """Where the parts are kept."""
    home = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(home) / "pybgi" / f"pyodide-{VERSION}"


def cached() -> bool:
    """Whether a site can be built without fetching anything."""
    return (cache() / "core").is_dir() and (cache() / NUMPY).is_file()


def core() -> Path:
    """The folder with Pyodide's own files, `CORE_FILES`."""
    folder = cache() / "core"
    if not folder.is_dir():
        with tempfile.TemporaryDirectory() as scratch:
            _run("npm", "pack", "--silent", f"pyodide@{VERSION}", "--pack-destination", scratch)
            archive = next(Path(scratch).glob("*.tgz"))
            _check(archive.read_bytes(), _CORE_SHA256, archive.name)
            with tarfile.open(archive) as opened:
                opened.extractall(scratch, filter="data")
            cache().mkdir(parents=True, exist_ok=True)
            shutil.move(Path(scratch) / "package", folder)
    return folder


def wheel(name: str) -> Path:
    """A wheel for Pyodide, NUMPY or PILLOW."""
    file = cache() / name
    if not file.is_file():
        with tempfile.TemporaryDirectory() as scratch:
            _download(Path(scratch), _SHIPPED_IN)
            with zipfile.ZipFile(next(Path(scratch).glob("*.whl"))) as package:
                for member, checksum in _SHA256.items():
                    data = package.read(_SHIPPED_AT + member)
                    _check(data, checksum, member)
                    cache().mkdir(parents=True, exist_ok=True)
                    (cache() / member).write_bytes(data)
    return file


def test_wheels() -> list[Path]:
    """The wheels of what the tests need."""
    folder = cache() / "tests"
    if len([*folder.glob("*.whl")]) != len(TEST_WHEELS):
        with tempfile.TemporaryDirectory() as scratch:
            _download(Path(scratch), *TEST_WHEELS)
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(scratch, folder)
    return sorted(folder.glob("*.whl"))


def _download(folder: Path, *packages: str) -> None:
    pip = sys.executable, "-m", "pip", "download", "-q", "--no-deps", "--only-binary", ":all:"
    # The package that ships numpy is for an older Python than the wheel in it.
    any_machine = "--platform", "any", "--python-version", "3.14", "--ignore-requires-python"
    _run(*pip, *any_machine, "-d", str(folder), *packages)


def _run(*command: str) -> None:
    program = shutil.which(command[0])
    if program is None:
        raise Missing(f"{command[0]} is not installed")
    done = subprocess.run([program, *command[1:]], capture_output=True, text=True)
    if done.returncode:
        raise Missing(f"{' '.join(command)}: {done.stderr.strip()[-300:]}")


def _check(data: bytes, checksum: str, name: str) -> None:
    if hashlib.sha256(data).hexdigest() != checksum:
        raise Missing(f"{name} is not the file that it was")
