"""The zip of the course for a room without network."""

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

from tools import offline, pictures


def test_its_programs_run_where_it_is_unpacked(tmp_path: Path):
    packages = tmp_path / "packages"
    for name in ("bgi", "surfaces"):  # numpy and pygame are those of the tests
        shutil.copytree(pictures.ROOT / name, packages / name)
    offline.pack(offline.collect(packages, "3.13"), tmp_path / "course.zip")
    zipfile.ZipFile(tmp_path / "course.zip").extractall(tmp_path)

    folder = tmp_path / "course"
    program = folder / "own.py"
    program.write_text("from bgi import *\nimport bgi\ninitgraph()\nprint(bgi.__file__)\n")
    own = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    command = [sys.executable, str(program)]
    printed = subprocess.check_output(command, text=True, env=own | {"BGI_MONITOR": "none"})
    assert Path(printed.strip()).is_relative_to(folder)


def test_it_holds_the_lessons_and_not_their_solutions(tmp_path: Path):
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests" / "test_it.py").touch()
    held = offline.collect(tmp_path, "3.13")
    files = [*pictures.COURSE.glob("*.py"), *pictures.COURSE.glob("expected/*.png")]
    names = [file.relative_to(pictures.COURSE).as_posix() for file in files]
    assert "expected/01_frame.png" in names
    assert {*held} == {"README.txt", "sheet.html", *names}
    assert "Python 3.13" in str(held["README.txt"])
