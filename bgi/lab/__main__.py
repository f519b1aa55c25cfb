"""Grade a class: `python -m bgi.lab grade FOLDER -o marks.csv`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from bgi.lab.grading import Limits, grade, programs
from bgi.lab.markspage import page, write_csv
from bgi.lab.tasks import CHECKS, DESCRIPTION, USUAL, Task, parse, read


def main(arguments: list[str] | None = None) -> int:
    """Run the command; returns the exit status."""
    options = _parser().parse_args(arguments)
    folder: Path = options.folder
    if not folder.is_dir():
        return _fail(f"{folder} is no folder")
    number = len(programs(folder))
    if not number:
        return _fail(f"{folder} holds no programs: files that end in .py")
    try:
        tasks = _tasks(options)
    except (OSError, ValueError) as error:
        return _fail(str(error))
    graded = []
    for one in grade(folder, tasks, Limits(options.seconds, options.megabytes)):
        graded.append(one)
        print(f"{len(graded)}/{number} {one.name}: {one.points:g} of {one.of:g}", flush=True)
    try:
        write_csv(options.output, graded)
        pictured = options.page or options.output.with_suffix(".html")
        pictured.write_text(page(graded), "utf-8")
    except OSError as error:
        return _fail(f"{error.filename} was not written: {error.strerror}")
    print(f"{options.output}: the marks; {pictured}: with reasons and pictures")
    return 0


def _tasks(options: argparse.Namespace) -> list[Task]:
    """What is asked for: by the command line, by a description, or by the functions' names."""
    if options.check:
        return [parse(word) for word in options.check]
    description: Path = options.exercises or options.folder / DESCRIPTION
    if options.exercises or description.exists():
        return read(description)
    texts = [file.read_text("utf-8", "replace") for file in programs(options.folder)]
    found = [task for task in USUAL if any(f"def {task.function}(" in text for text in texts)]
    if not found:
        raise ValueError(
            f"nothing says what to check: use --check line=my_line, or write {description}"
        )
    return found


def _fail(words: str) -> int:
    print(f"bgi.lab: {words}", file=sys.stderr)
    return 2


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m bgi.lab", description=__doc__.partition(":")[0]
    )
    commands = parser.add_subparsers(required=True, metavar="grade")
    one = commands.add_parser("grade", help="grade a folder of programs")
    one.add_argument("folder", type=Path, metavar="FOLDER", help="programs, one for each student")
    one.add_argument(
        "-o",
        "--output",
        type=Path,
        default=Path("marks.csv"),
        metavar="marks.csv",
        help="the marks",
    )
    one.add_argument("--page", type=Path, metavar="marks.html", help="the marks with pictures")
    one.add_argument(
        "--check",
        action="append",
        metavar="line=my_line",
        help=f"check this function; the checks are {', '.join(CHECKS)}",
    )
    one.add_argument(
        "--exercises",
        type=Path,
        metavar="FILE.toml",
        help=f"what to check, and for how many points; default: {DESCRIPTION} in the folder",
    )
    one.add_argument("--seconds", type=_count, default=30, metavar="30", help="for a program")
    one.add_argument(
        "--megabytes", type=_count, default=1024, metavar="1024", help="of memory for a program"
    )
    return parser


def _count(text: str) -> int:
    if not (text.isascii() and text.isdigit() and 0 < int(text) < 100_000):
        raise argparse.ArgumentTypeError("it is a whole number above 0")
    return int(text)


if __name__ == "__main__":
    sys.exit(main())
