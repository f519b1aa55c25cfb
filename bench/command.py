"""The command line of `python -m bench`: which groups, kept where, compared with what."""

import argparse
import statistics
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from bench import monitor, readme, report, site, web
from bench.groups import (
    arrays,
    console,
    curves,
    fills,
    images,
    lines,
    plots,
    programs,
    settings,
    startup,
    text,
    turboc,
)
from bench.libraries import libraries
from bench.plotters import plotters
from bench.saved import Run
from bench.timing import Row, measure, unit

ROUNDS = 11


class Group(NamedTuple):
    """Rows that are asked for by one name."""

    rows: Callable[[], list[Row]]
    most_rounds: int = ROUNDS


GROUPS = {
    "lines": Group(lines.rows),
    "curves": Group(curves.rows),
    "fills": Group(fills.rows),
    "text": Group(text.rows),
    "console": Group(console.rows),
    "images": Group(images.rows),
    "settings": Group(settings.rows),
    "arrays": Group(arrays.rows),
    "programs": Group(programs.rows),
    "turboc": Group(turboc.rows),
    "startup": Group(startup.rows, most_rounds=5),
    "surfaces": Group(plots.rows, most_rounds=3),
    "growth": Group(plots.growth_rows, most_rounds=1),
    "memory": Group(plots.memory_rows, most_rounds=0),
}
PLOTS = {"surfaces"}
REPORTS = {"monitor": monitor.report, "web": web.report, "site": site.report}
"""What has a table of its own."""


def main(words: Sequence[str] | None = None) -> None:
    """Do what the command line says."""
    options = parser().parse_args(words)
    if options.readme:
        readme.write(options.readme)
        return
    named = options.groups or list(GROUPS)
    known = {**GROUPS, **REPORTS}
    if unknown := set(named) - known.keys():
        sys.exit(f"bench: no {', '.join(unknown)}; there are {', '.join(known)}")
    for name, print_report in REPORTS.items():
        if name in named:
            print_report()
    wanted = [name for name in named if name in GROUPS]
    if not wanted:
        return
    run = measured(wanted, options.rounds)
    print(report.table(run))
    if options.save:
        run.save(options.save)
    if options.against:
        print(f"\n{report.comparison(options.against, run)}")


def parser() -> argparse.ArgumentParser:
    """What may be typed."""
    made = argparse.ArgumentParser("python -m bench", description="Measure us beside our peers.")
    made.add_argument(
        "groups",
        nargs="*",
        metavar="group",
        help=f"{', '.join(GROUPS)}, all of them unless named; or {' or '.join(REPORTS)}",
    )
    made.add_argument("--rounds", type=int, default=ROUNDS, help="how often, at most")
    made.add_argument("--save", type=_new_file, metavar="FILE", help="keep the run")
    made.add_argument("--against", type=_kept_run, metavar="FILE", help="compare with a kept run")
    made.add_argument(
        "--readme", type=_kept_run, metavar="FILE", help="write README's table from one"
    )
    return made


def _new_file(word: str) -> Path:
    """A file that can be written: known before anything is measured."""
    path = Path(word)
    if path.is_dir() or not path.parent.is_dir():
        raise argparse.ArgumentTypeError(f"{word} is a folder, or in a folder that is not there")
    return path


def _kept_run(word: str) -> Run:
    """A run that `--save` kept."""
    try:
        return Run.load(Path(word))
    except (OSError, ValueError, TypeError, KeyError) as error:
        raise argparse.ArgumentTypeError(f"{word} is no run that --save kept: {error}") from None


def measured(names: Sequence[str], rounds: int) -> Run:
    """Measure groups. What it is at is told on the standard error."""
    results = []
    for name in names:
        group = GROUPS[name]
        for row in group.rows():
            print(f"\r{row.group}: {row.name:40}", end="", file=sys.stderr, flush=True)
            results.append(measure(row, min(rounds, group.most_rounds)))
    print("\r" + " " * 60 + "\r", end="", file=sys.stderr, flush=True)
    peers = dict(libraries()) | (plotters() if PLOTS & set(names) else {})
    missing = [name for name, peer in peers.items() if peer is None]
    return Run(rounds, missing, statistics.median(unit(0) for _ in range(99)), results)
