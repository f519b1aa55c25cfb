"""Make a zip of the course for machines without network and without rights to install anything.

    python -m tools.offline course.zip
    python -m tools.offline course.zip --platform win_amd64 --python 3.12

It is unpacked anywhere. The programs lie beside the packages that they import, so any Python of
that version runs them, from IDLE, Thonny or a prompt. pip fetches the packages, once, here.
"""

import argparse
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from tools import pictures, sheet

FOLDER = "course"
"""What the zip unpacks to."""

EXPECTED = pictures.COURSE / "expected"
"""The pictures that exercises should draw."""

UNUSED = {"bin", "include", "tests", "examples", "docs"}
"""Folders of the packages that no program needs."""

READ_ME = """\
The course in computer graphics
===============================

These programs need Python {version} and nothing else: what they import lies beside them. Open one
of them in IDLE or Thonny and press F5, or type

    python 01_screen.py

Programs of your own belong into this folder, too. All calls on one page: sheet.html
"""


def install(packages: Path, platform: str | None, version: str) -> None:
    """Have pip lay the package, and what it needs, into a folder."""
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "-q"]
    wheels = packages.with_name("wheels")
    subprocess.run([*pip, "wheel", "--no-deps", "-w", wheels, pictures.ROOT], check=True)
    there = ["--python-version", version, "--only-binary=:all:"]
    there += ["--platform", platform] if platform else []
    own = next(wheels.glob("*.whl"))
    subprocess.run([*pip, "install", "--target", packages, *there, own], check=True)


def collect(packages: Path, version: str) -> dict[str, Path | str]:
    """What the zip holds, by the names there: files, and the text that is made here."""
    found: dict[str, Path | str] = {"README.txt": READ_ME.format(version=version)}
    for file in packages.rglob("*"):
        name = file.relative_to(packages)
        if file.is_file() and not UNUSED & {*name.parts[:2]} and file.suffix != ".pyc":
            found[name.as_posix()] = file
    found |= {f"expected/{file.name}": file for file in EXPECTED.iterdir()}
    return found | {file.name: file for file in [*pictures.COURSE.glob("*.py"), sheet.FILE]}


def pack(contents: dict[str, Path | str], file: Path) -> None:
    """Write the zip."""
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in contents.items():
            if isinstance(content, str):
                archive.writestr(f"{FOLDER}/{name}", content)
            else:
                archive.write(content, f"{FOLDER}/{name}")


def main() -> None:
    """Read the command line."""
    parser = argparse.ArgumentParser(
        prog="python -m tools.offline",
        description="Make a zip of the course for machines without network.",
    )
    parser.add_argument("file", type=Path, help="the zip that is written")
    parser.add_argument("--platform", help="as wheels call it: win_amd64 (by default: this one)")
    parser.add_argument("--python", default="{}.{}".format(*sys.version_info), metavar="VERSION")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        packages = Path(folder, "packages")
        try:
            install(packages, given.platform, given.python)
        except subprocess.CalledProcessError as error:
            sys.exit(f"offline: pip could not do it (status {error.returncode}); above it says why")
        pack(collect(packages, given.python), given.file)
    print(f"{given.file}: {given.file.stat().st_size >> 20} MB")


if __name__ == "__main__":
    main()
