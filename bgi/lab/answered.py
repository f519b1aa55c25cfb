"""Exercises whose functions answer: points, matrices, clipped figures.

What an answer looks like is found by comparing it with slips: formulas that are wrong in the usual
ways. If one of them gives all the wrong answers, it is the mistake that was made.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from bgi.errors import brief
from bgi.graphics import Graphics
from bgi.lab import supervision
from bgi.lab.comparison import side_by_side
from bgi.lab.drawn import reference
from bgi.lab.supervision import Outcome
from bgi.lab.verdict import Verdict
from bgi.memory.image import Image

Arguments = tuple[Any, ...]
Answer = tuple[float, ...] | None
"""What a function has answered, as numbers in a row; None is nothing."""
Read = Callable[[Any], Answer]
"""Understands an answer; ValueError says what it must be."""

CLOSE = 1e-6


def same(one: Answer, other: Answer, arguments: Arguments = ()) -> bool:
    """Whether two answers are equal within rounding."""
    if one is None or other is None:
        return one is other
    return len(one) == len(other) and all(
        math.isclose(a, b, rel_tol=CLOSE, abs_tol=CLOSE) for a, b in zip(one, other, strict=True)
    )


@dataclass(frozen=True)
class Slip:
    """A formula that is wrong in a usual way, and the hint for it."""

    formula: Callable[..., Any]
    hint: str


@dataclass(frozen=True)
class Miss:
    """A case with a wrong answer, or with none."""

    arguments: Arguments
    outcome: Outcome
    answer: Answer = None
    unreadable: str = ""
    """Why the answer makes no sense."""


@dataclass(frozen=True)
class AnswerExercise:
    """A kind of function that answers, and everything that is needed to check one."""

    name: str
    parameters: tuple[str, ...]
    cases: Callable[[], Iterable[Arguments]]
    """The easy ones first."""
    right: Callable[..., Any]
    """The right formula."""
    read: Read
    slips: Sequence[Slip]
    troubles: Mapping[str, str] = field(default_factory=dict)
    """Hints for errors, by their names; `endless` and `deep` are such names, too."""
    same: Callable[[Answer, Answer, Arguments], bool] = same
    sketch: Callable[[Graphics, Arguments, Answer], None] | None = None
    """Draws a case and an answer to it; only the case if that is None."""
    parts: tuple[str, ...] = ("x", "y")
    """What the numbers of an answer are called."""
    otherwise: str = ""
    """The hint where nothing else fits."""

    def check(self, function: Callable[..., Any]) -> Verdict:
        """Try a function."""
        cases = list(self.cases())
        if problem := supervision.misfit(function, self.parameters):
            return Verdict(self.name, False, len(cases), 0, problem)
        misses, passed, hopeless = [], 0, 0
        for arguments in cases:
            miss = self._try(function, arguments)
            if miss is None:
                passed += 1
                continue
            misses.append(miss)
            trouble = miss.outcome.trouble
            hopeless += trouble is not None and trouble.kind in supervision.HOPELESS
            if hopeless >= supervision.ENOUGH:
                break
        if not misses:
            return Verdict(self.name, True, len(cases), passed)
        first = misses[0]
        called = f"{supervision.name_of(function)}({', '.join(map(written, first.arguments))})"
        reason = f"{called} {self._reason(first)}"
        hint, picture = self._hint(misses), self._picture(first)
        return Verdict(self.name, False, len(cases), passed, reason, hint, picture)

    def _try(self, function: Callable[..., Any], arguments: Arguments) -> Miss | None:
        outcome = supervision.call(function, supervision.copied(arguments))
        if outcome.trouble is not None:
            return Miss(arguments, outcome)
        try:
            answer = self.read(outcome.value)
        except ValueError as error:
            return Miss(arguments, outcome, unreadable=str(error))
        expected = self.read(self.right(*arguments))
        return None if self.same(answer, expected, arguments) else Miss(arguments, outcome, answer)

    def _reason(self, miss: Miss) -> str:
        trouble = miss.outcome.trouble
        if trouble is not None:
            return f"gives no answer: {trouble.words}{supervision.quoted(miss.outcome)}"
        found, wanted = (written(v) for v in (miss.outcome.value, self.right(*miss.arguments)))
        return f"is {found}; expected: {wanted}{supervision.quoted(miss.outcome)}"

    def _hint(self, misses: list[Miss]) -> str:
        first = misses[0]
        if first.outcome.trouble is not None:
            kind, error = first.outcome.trouble.kind, first.outcome.trouble.error
            names = (kind, type(error).__name__)
            known = {"BGIError": COMPUTES} | dict(self.troubles)
            found = [known[name] for name in names if name in known]
            return found[0] if found else supervision.usual(first.outcome.trouble)
        if first.outcome.value is None and first.outcome.printed.strip():
            return "it prints the answer: return it"
        if first.unreadable:
            must = f"the answer must be {first.unreadable}"
            return must if first.outcome.value is not None else f"{must}: is there a return?"
        return self._slipped(misses) or self.otherwise

    def _slipped(self, misses: list[Miss]) -> str:
        """The hint for answers that can be read, and are wrong."""
        if _rows_are_one(misses[0].outcome.value):
            return "[[0] * 3] * 3 is one row, three times the same: write each row by itself"
        answered = [miss for miss in misses if not (miss.outcome.trouble or miss.unreadable)]
        if len({miss.answer for miss in answered}) == 1 < len(answered) and answered[0].answer:
            return "the answer is always the same: use the arguments, no variables from outside"
        tests = [(slip.hint, self._gives(slip)) for slip in self.slips]
        near = [(ROUNDED, self._is_rounded), (NEARLY, self._is_near)]
        for hint, fits in [*tests, *near]:
            fitting = {fits(miss) for miss in answered}
            if True in fitting and False not in fitting:
                return hint
        first = answered[:2]  # the others may have another slip
        alone = (hint for hint, fits in tests if all(map(fits, first)))
        return self._wrong_parts(answered) or next(alone, "")

    def _wrong_parts(self, misses: list[Miss]) -> str:
        """Which numbers of the answers are wrong, if others never are."""
        wrong: set[str] = set()
        for miss in misses:
            right = self.read(self.right(*miss.arguments))
            if miss.answer is None or right is None or not self.parts:
                return ""
            pairs = zip(self.parts, miss.answer, right, strict=True)
            wrong |= {part for part, a, b in pairs if not same((a,), (b,))}
        if not 0 < len(wrong) <= min(2, len(self.parts) // 2) or len(misses) < 2:
            return ""
        named = " and ".join(part for part in self.parts if part in wrong)
        return f"only {named} {'is' if len(wrong) == 1 else 'are'} wrong: all else is right"

    def _gives(self, slip: Slip) -> Callable[[Miss], bool | None]:
        """Whether a slip gives the same wrong answer; None where it has none to give."""

        def fits(miss: Miss) -> bool | None:
            try:
                wrong = self.read(slip.formula(*miss.arguments))
            except (ArithmeticError, IndexError, ValueError):
                return None
            return self.same(miss.answer, wrong, miss.arguments)

        return fits

    def _is_rounded(self, miss: Miss) -> bool:
        right = self.read(self.right(*miss.arguments))
        if miss.answer is None or right is None or len(miss.answer) != len(right):
            return False
        pairs = zip(miss.answer, right, strict=True)
        return all(a == int(a) and abs(a - b) < 1 for a, b in pairs)

    def _is_near(self, miss: Miss) -> bool:
        right = self.read(self.right(*miss.arguments))
        if miss.answer is None or right is None or len(miss.answer) != len(right):
            return False
        pairs = zip(miss.answer, right, strict=True)
        return all(math.isclose(a, b, rel_tol=0.01, abs_tol=0.01) for a, b in pairs)

    def _picture(self, miss: Miss) -> Image | None:
        if self.sketch is None or miss.outcome.trouble or miss.unreadable:
            return None
        answers = None, miss.answer, self.read(self.right(*miss.arguments))
        pictures = []
        for answer in answers:
            screen = reference()
            screen.cleardevice()
            screen.graphdefaults()
            self.sketch(screen, miss.arguments, answer)
            pictures.append(screen.page.array.copy())
        ground, got, expected = pictures
        return side_by_side(got, expected, ground) if (got != expected).any() else None


def _rows_are_one(value: Any) -> bool:
    """Whether it is a list that holds one and the same list."""
    return isinstance(value, list) and len(value) > 1 and value[0] is value[1]


COMPUTES = "the function computes, and draws nothing: it returns its answer"
NEARLY = "it is nearly right: is something rounded on the way, or a constant? math.pi is exact"
ROUNDED = "the answer is rounded: give it as it is computed; pixels come later"


def written(value: Any) -> str:
    """A value as it is told: numbers with a few digits."""
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    if isinstance(value, list | tuple) and len(value) <= 20:
        inside = ", ".join(map(written, value))
        return f"[{inside}]" if isinstance(value, list) else f"({inside})"
    if isinstance(value, float):
        return f"{round(value, 9) + 0.0:.6g}"
    return brief(value)


# Readers


def numbers(value: Any, count: int, what: str) -> tuple[float, ...]:
    """So many numbers in a row; ValueError says `what` is wanted."""
    try:
        found = tuple(float(one) for one in value if not isinstance(one, str | bytes))
    except (TypeError, ValueError, OverflowError):
        found = ()
    if len(found) != count or not all(map(math.isfinite, found)):
        raise ValueError(what)
    return found


def point(value: Any) -> Answer:
    """x and y."""
    return numbers(value, 2, "two numbers, (x, y)")


def matrix(value: Any) -> Answer:
    """Three rows of three numbers."""
    what = "three rows of three numbers, [[...], [...], [...]]"
    try:
        rows = list(value)
    except TypeError:
        raise ValueError(what) from None
    if len(rows) != 3:
        raise ValueError(what)
    return tuple(number for row in rows for number in numbers(row, 3, what))
