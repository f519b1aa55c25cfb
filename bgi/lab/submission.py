"""One submission in a process of its own: `grading` starts this, and reads what it has written.

    python -m bgi.lab.submission JOB

JOB is a file of JSON: the program, the tasks, the limits, and the file for the answers. That gets a
line of JSON when the program is loaded, and one for the verdict on each task: so it is known what
was under way if the process ends all of a sudden.
"""

from __future__ import annotations

import base64
import io
import json
import os
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

from bgi.lab import check, supervision
from bgi.lab.confinement import confine
from bgi.lab.tasks import CHECKS, Task
from bgi.lab.verdict import Verdict

LONGEST = 1000
"""Characters of a reason."""
LARGEST_PICTURE = 300_000
"""Bytes."""


def main(job_file: str) -> None:
    """Load a program, and check its functions."""
    job = json.loads(Path(job_file).read_text("utf-8"))
    sys.argv = [job["program"]]
    check.show = False
    answers = Path(job["answers"])
    program = Path(job["program"])
    tasks = [Task(**task) for task in job["tasks"]]
    os.chdir(program.parent)
    sys.path.insert(0, str(program.parent))
    confine(program.parent, answers, job["megabytes"], job["seconds"])
    module, note = _load(program)
    sys.stdout = io.StringIO()  # nobody reads what is printed, and the program may have closed it
    _tell(answers, {"loaded": note})
    for task in tasks:
        function = vars(module).get(task.function)
        if function is None:
            _tell(answers, {"exercise": task.exercise, "absent": note})
            continue
        _tell(answers, _judged(task, function))


def _load(program: Path) -> tuple[ModuleType, str]:
    """The program as a module, as far as it runs, and why it has not run to its end.

    It is not called __main__: what stands below `if __name__ == "__main__"` is not run.
    """
    module = ModuleType("submission")
    module.__file__ = str(program)
    sys.modules["submission"] = module

    def run() -> None:
        code = compile(program.read_bytes(), program.name, "exec", dont_inherit=True)
        exec(code, module.__dict__)

    try:
        outcome = supervision.call(run, ())
    except KeyboardInterrupt:
        return module, "it interrupts itself"
    return module, outcome.trouble.words[:LONGEST] if outcome.trouble else ""


def _judged(task: Task, function: Any) -> dict[str, Any]:
    """The verdict on one function, as plain data."""
    if not callable(function):
        reason = f"{task.function} is no function"
        return _plain(Verdict(task.exercise, False, 1, 0, reason))
    try:
        verdict = CHECKS[task.exercise](function, **task.options)
    except BaseException as error:  # Ctrl-C, which it raises itself, and whatever else
        verdict = Verdict(task.exercise, False, 1, 0, f"it raises {type(error).__name__}")
    return _plain(verdict)


def _plain(verdict: Verdict) -> dict[str, Any]:
    picture = verdict.picture._repr_png_() if verdict.picture else b""
    return {
        "exercise": verdict.exercise,
        "right": bool(verdict.right),
        "passed": verdict.passed,
        "tried": verdict.tried,
        "reason": verdict.reason[:LONGEST],
        "hint": verdict.hint[:LONGEST],
        "picture": base64.b64encode(picture).decode() if len(picture) < LARGEST_PICTURE else "",
    }


def _tell(answers: Path, line: dict[str, Any]) -> None:
    with open(answers, "a", encoding="utf-8") as file:
        file.write(json.dumps(line) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
    os._exit(0)  # whatever threads, handlers and open files it has left behind
