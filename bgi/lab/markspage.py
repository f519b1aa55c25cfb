"""Marks as a table for a spreadsheet, and as a page with pictures."""

from __future__ import annotations

import csv
import html
from pathlib import Path

from bgi.lab.grading import Graded, TaskMark

STYLE = """
body { font: 16px/1.4 sans-serif; margin: 2em; max-width: 70em }
table { border-collapse: collapse } td, th { border: 1px solid #aaa; padding: .3em .6em }
.right { background: #dfd } .wrong { background: #fdd }
h2 { border-top: 1px solid #aaa; padding-top: .6em } img { max-width: 100% }
p { margin: .3em 0; overflow-wrap: anywhere }
"""


def write_csv(file: Path, graded: list[Graded]) -> None:
    """A row for each program: its marks, their sum, and the reasons.

    UTF-8 with a mark at its beginning, by which spreadsheets know it.
    """
    names = [mark.task.title for mark in graded[0].marks] if graded else []
    with open(file, "w", encoding="utf-8-sig", newline="") as opened:
        writer = csv.writer(opened)
        writer.writerow(["program", *names, "points", "of", "reasons"])
        for one in graded:
            reasons = "\n".join(_reason(mark) for mark in one.marks if not mark.right)
            points = [f"{mark.points:g}" for mark in one.marks]
            sums = [f"{one.points:g}", f"{one.of:g}"]
            writer.writerow([_plain(one.name), *points, *sums, _plain(reasons)])


def _plain(text: str) -> str:
    """A text that no spreadsheet takes for a formula."""
    return f"'{text}" if text.startswith(("=", "+", "-", "@", "\t", "\r")) else text


def _reason(mark: TaskMark) -> str:
    hint = f"; hint: {mark.hint}" if mark.hint else ""
    return f"{mark.task.title}: {mark.reason}{_cases(mark)}{hint}"


def _cases(mark: TaskMark) -> str:
    return f" ({mark.passed} of {mark.tried} cases right)" if mark.tried > 1 else ""


def page(graded: list[Graded]) -> str:
    """A page of HTML that needs no other file: a table, then each program with its pictures."""
    names = [f"{mark.task.title} ({mark.task.points:g})" for mark in graded[0].marks]
    head = "".join(f"<th>{html.escape(name)}</th>" for name in ["program", *names, "points"])
    rows = "".join(_row(number, one) for number, one in enumerate(graded)) + _counts(graded)
    programs = "".join(_program(number, one) for number, one in enumerate(graded))
    return (
        f"<!doctype html><meta charset='utf-8'><title>Marks</title><style>{STYLE}</style>"
        f"<h1>Marks</h1><table><tr>{head}</tr>{rows}</table>{programs}\n"
    )


def _row(number: int, one: Graded) -> str:
    cells = "".join(
        f"<td class='{'right' if mark.right else 'wrong'}'>{mark.points:g}</td>"
        for mark in one.marks
    )
    name = f"<td><a href='#p{number}'>{html.escape(one.name)}</a></td>"
    return f"<tr>{name}{cells}<td>{one.points:g} of {one.of:g}</td></tr>"


def _counts(graded: list[Graded]) -> str:
    """How many have each function right: what the class has not understood yet."""
    columns = zip(*(one.marks for one in graded), strict=True)
    cells = "".join(f"<td>{sum(mark.right for mark in marks)}</td>" for marks in columns)
    return f"<tr><td>right, of {len(graded)}</td>{cells}<td></td></tr>"


def _program(number: int, one: Graded) -> str:
    marks = "".join(map(_mark, one.marks))
    title = f"{html.escape(one.name)}: {one.points:g} of {one.of:g}"
    return f"<h2 id='p{number}'>{title}</h2>{marks}"


def _mark(mark: TaskMark) -> str:
    name = html.escape(f"{mark.task.title} ({mark.task.function})")
    if mark.right:
        return f"<p class='right'>{name}: right, {mark.tried} cases</p>"
    text = f"<p class='wrong'>{name}: {html.escape(mark.reason)}{_cases(mark)}</p>"
    if mark.hint:
        text += f"<p>hint: {html.escape(mark.hint)}</p>"
    if mark.picture:
        source = f"data:image/png;base64,{html.escape(mark.picture, quote=True)}"
        text += f"<p><img alt='yours, expected, difference' src='{source}'></p>"
    return text
