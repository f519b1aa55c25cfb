"""Grades a folder of programs: each in processes of its own, which have limits and no window."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import bgi
from bgi.lab.tasks import Task

KEYS = "Enter Space Esc " * 20
"""What is pressed for a program that waits for keys while it is loaded."""
KEPT = [
    *("PATH", "LD_LIBRARY_PATH", "LANG", "LC_ALL", "PYTHONHOME", "VIRTUAL_ENV"),
    *("SYSTEMROOT", "SYSTEMDRIVE", "WINDIR", "WINEPREFIX", "WINEDEBUG"),
]
"""What a process gets to know of the environment."""
LARGEST = 1 << 20
"""Bytes of a program, and of what lies beside it."""
LONGEST_ANSWERS = 8 << 20
"""Bytes of answers that are read."""


@dataclass(frozen=True)
class Limits:
    """What a process may take."""

    seconds: int = 30
    megabytes: int = 1024


@dataclass(frozen=True)
class TaskMark:
    """What was found for one task."""

    task: Task
    right: bool
    reason: str = ""
    hint: str = ""
    passed: int = 0
    tried: int = 0
    picture: str = ""
    """A PNG in base64, or nothing."""

    @property
    def points(self) -> float:
        """All points or none."""
        return self.task.points if self.right else 0


@dataclass(frozen=True)
class Graded:
    """A program with its marks."""

    name: str
    marks: list[TaskMark] = field(default_factory=list)

    @property
    def points(self) -> float:
        """The sum."""
        return sum(mark.points for mark in self.marks)

    @property
    def of(self) -> float:
        """What could be had."""
        return sum(mark.task.points for mark in self.marks)


def programs(folder: Path) -> list[Path]:
    """What is graded: the programs in a folder, and in the folders in it."""
    found = [*folder.glob("*.py"), *folder.glob("*/*.py")]
    return sorted(file for file in found if file.is_file() and not file.name.startswith((".", "_")))


def grade(folder: Path, tasks: list[Task], limits: Limits = Limits()) -> Iterator[Graded]:
    """Grade all programs of a folder, one after the other."""
    for program in programs(folder):
        name = program.relative_to(folder).as_posix()
        yield Graded(name, _marks(program, folder, tasks, limits))


def _marks(program: Path, folder: Path, tasks: list[Task], limits: Limits) -> list[TaskMark]:
    if program.stat().st_size > LARGEST:
        return [
            TaskMark(task, False, f"the file has more than {LARGEST:,} bytes") for task in tasks
        ]
    marks: dict[str, TaskMark] = {}
    waiting = list(tasks)
    while waiting:
        lines, end = _run(program, program.parent != folder, waiting, limits)
        found = _read(lines, waiting, end)
        marks |= found
        waiting = [task for task in waiting if task.title not in found]
    return [marks[task.title] for task in tasks]


def _read(lines: list[dict[str, Any]], tasks: list[Task], end: str) -> dict[str, TaskMark]:
    """The marks that answers give; at least one, so that there is an end to it."""
    found: dict[str, TaskMark] = {}
    loaded = any("loaded" in line for line in lines)
    done = [line for line in lines if "right" in line or "absent" in line]
    for task, line in zip(tasks, done, strict=False):
        if "absent" in line:
            why = f", as far as the program runs: {line['absent']}" if line["absent"] else ""
            mark = TaskMark(task, False, f"there is no function {task.function}{why}")
        else:
            fields = ("right", "reason", "hint", "passed", "tried", "picture")
            mark = TaskMark(task, **{name: line[name] for name in fields})
        found[task.title] = mark
    if loaded and len(done) < len(tasks):
        culprit = tasks[len(done)]
        found[culprit.title] = TaskMark(culprit, False, end)
    elif not loaded:
        reason = f"the program cannot be loaded: {end}"
        found = {task.title: TaskMark(task, False, reason) for task in tasks}
    return found


def _run(
    program: Path, with_folder: bool, tasks: list[Task], limits: Limits
) -> tuple[list[dict[str, Any]], str]:
    """Run a copy of a program; returns its answers, and how its process ended."""
    with TemporaryDirectory(prefix="grade-", ignore_cleanup_errors=True) as scratch:
        home = Path(scratch) / "work"
        home.mkdir()
        copy = home / program.name
        for file in program.parent.iterdir() if with_folder else [program]:
            if file.is_file() and file.stat().st_size <= LARGEST:
                shutil.copyfile(file, home / file.name)
        answers = Path(scratch) / "answers"
        job = Path(scratch) / "job.json"
        told = {
            **{"program": str(copy), "answers": str(answers)},
            **{"tasks": [asdict(task) for task in tasks], **asdict(limits)},
        }
        job.write_text(json.dumps(told), "utf-8")
        end = _process(job, home, limits)
        return _lines(answers), end


def _process(job: Path, home: Path, limits: Limits) -> str:
    """Run the process of a submission, and say how it has ended; nothing of it stays."""
    process = subprocess.Popen(
        [sys.executable, "-B", "-m", "bgi.lab.submission", str(job)],
        cwd=home,
        env=_environment(home),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    try:
        status = process.wait(limits.seconds)
    except subprocess.TimeoutExpired:
        return f"it was not ready after {limits.seconds} seconds"
    finally:
        _kill(process)
    if status < 0:
        return f"its process was ended by signal {-status}"
    return f"it ended its process, with status {status}"


def _kill(process: subprocess.Popen[bytes]) -> None:
    """End a process, and with it what it has started."""
    if sys.platform != "win32":
        with contextlib.suppress(ProcessLookupError, PermissionError):  # nobody is left
            os.killpg(process.pid, signal.SIGKILL)
    process.kill()
    process.wait()


def _environment(home: Path) -> dict[str, str]:
    """As little as Python needs: no window, no keys of the teacher's, no home."""
    environment = {name: os.environ[name] for name in KEPT if name in os.environ}
    ours = str(Path(bgi.__file__).parents[1])
    paths = [ours, *filter(None, [os.environ.get("PYTHONPATH", "")])]
    return environment | {
        "PYTHONPATH": os.pathsep.join(paths),
        "PYTHONUTF8": "1",
        "BGI_MONITOR": "none",
        "BGI_KEYS": KEYS,
        "SDL_VIDEODRIVER": "dummy",
        "SDL_AUDIODRIVER": "dummy",
        "OPENBLAS_NUM_THREADS": "1",
        **dict.fromkeys(("HOME", "USERPROFILE", "TMP", "TEMP", "TMPDIR"), str(home)),
    }


def _lines(answers: Path) -> list[dict[str, Any]]:
    """The answers as far as they can be read."""
    if not answers.exists():
        return []
    with open(answers, "rb") as file:
        text = file.read(LONGEST_ANSWERS)
    found = []
    for line in text.splitlines():
        try:
            data = json.loads(line)
        except ValueError:  # cut off
            break
        if isinstance(data, dict):
            found.append(data)
    return found
