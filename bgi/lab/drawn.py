"""Exercises whose functions draw: the cases, the comparison, and the search for a hint."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, cast

import numpy as np

from bgi import current
from bgi.constants import VGA, VGAHI
from bgi.errors import brief
from bgi.graphics import Graphics
from bgi.kernel.modes import GraphicsMode, find
from bgi.lab import supervision
from bgi.lab.comparison import Pixels, side_by_side
from bgi.lab.supervision import Outcome, PixelsOnly, Trouble
from bgi.lab.verdict import Verdict

Place = tuple[int, int]


@dataclass(frozen=True)
class Trial:
    """One call to try, and what it should draw."""

    arguments: tuple[Any, ...]
    expected: Callable[[Pixels], Pixels]
    """Of all pictures that are right the one most like what was drawn."""
    before: Callable[[Graphics], None] | None = None
    """Draws what is on the screen before."""
    deepest: int = supervision.DEEPEST
    """Calls inside each other that are not too many."""
    about: str = ""
    """What is special about it, for the hint."""


@dataclass(frozen=True)
class Fault:
    """A trial that went wrong."""

    trial: Trial
    outcome: Outcome
    ground: Pixels
    got: Pixels
    expected: Pixels

    @property
    def arguments(self) -> tuple[Any, ...]:
        """What the function was called with."""
        return self.trial.arguments

    @cached_property
    def drawn(self) -> set[Place]:
        """The pixels that it changed."""
        return places(self.got != self.ground)

    @cached_property
    def wanted(self) -> set[Place]:
        """The pixels that it should have changed."""
        return places(self.expected != self.ground)

    @cached_property
    def missing(self) -> set[Place]:
        """Pixels that it left."""
        return self.wanted - self.drawn

    @cached_property
    def extra(self) -> set[Place]:
        """Pixels that it should have left."""
        return self.drawn - self.wanted

    @cached_property
    def recolored(self) -> set[Place]:
        """Pixels in another colour than expected."""
        return places(self.got != self.expected) & self.drawn & self.wanted


@dataclass(frozen=True)
class Evidence:
    """All that is known when a hint is looked for."""

    faults: list[Fault]
    right: list[Trial]

    @property
    def mostly(self) -> bool:
        """Whether more is wrong than right."""
        return len(self.faults) > len(self.right)

    def always(self, test: Callable[[Fault], bool]) -> bool:
        """Whether something holds for every fault."""
        return all(map(test, self.faults))


OPEN = "the screen is open when the function is called: initgraph() and closegraph() stand outside"

Sign = tuple[Callable[[Evidence], Any], str]
"""What a mistake looks like, and the hint for it."""


@dataclass(frozen=True)
class DrawingExercise:
    """A kind of function that draws, and everything that is needed to check one."""

    name: str
    parameters: tuple[str, ...]
    trials: Callable[[], Iterable[Trial]]
    """The easy ones first: the first that goes wrong is shown."""
    signs: Sequence[Sign]
    """The first one that fits gives the hint."""
    troubles: Callable[[Fault], str]
    """The hint for a call that has given no answer; empty if there is none."""
    allowed: tuple[str, ...] = ()
    """What else than putpixel it may draw by."""
    instead: str = ""
    """What is told to whom calls something else."""
    otherwise: str = ""
    """The hint where no sign fits."""

    def check(self, function: Callable[..., Any]) -> Verdict:
        """Try a function."""
        trials = list(self.trials())
        if problem := supervision.misfit(function, self.parameters):
            return Verdict(self.name, False, len(trials), 0, problem)
        evidence = self._tried(function, trials)
        if not evidence.faults:
            return Verdict(self.name, True, len(trials), len(trials))
        first = evidence.faults[0]
        name = supervision.name_of(function)
        shown = (first.got != first.expected).any()
        return Verdict(
            self.name,
            False,
            len(trials),
            len(evidence.right),
            f"{name}({', '.join(map(_written, first.arguments))}): {self._reason(first)}",
            self._hint(evidence),
            side_by_side(first.got, first.expected, first.ground) if shown else None,
        )

    def _tried(self, function: Callable[..., Any], trials: list[Trial]) -> Evidence:
        """Try one after the other; those that are not tried any more are not right either."""
        evidence, hopeless = Evidence([], []), 0
        with current.aside(_mode(), lambda one: PixelsOnly(one, self.allowed)) as screen:
            for trial in trials:
                fault = _try(function, trial, screen)
                if fault is None:
                    evidence.right.append(trial)
                    continue
                evidence.faults.append(fault)
                trouble = fault.outcome.trouble
                hopeless += trouble is not None and trouble.kind in supervision.HOPELESS
                if hopeless >= supervision.ENOUGH:
                    break
        return evidence

    def _reason(self, fault: Fault) -> str:
        trouble = fault.outcome.trouble
        words = trouble.words if trouble else _counted(fault)
        return words + supervision.quoted(fault.outcome)

    def _hint(self, evidence: Evidence) -> str:
        first = evidence.faults[0]
        trouble = first.outcome.trouble
        if trouble is not None:
            if trouble.kind == "forbidden":
                return OPEN if trouble.error is None else self.instead
            return self.troubles(first) or supervision.usual(trouble)
        plain = [fault for fault in evidence.faults if not fault.outcome.trouble]
        others = [fault.trial for fault in evidence.faults[1:]] + evidence.right
        alone = Evidence([first], others)  # two mistakes in one program: then the one that is shown
        for known in (Evidence(plain, evidence.right), alone):
            for seems, hint in self.signs:
                if seems(known):
                    return hint
        return self.otherwise


def _try(function: Callable[..., Any], trial: Trial, screen: Graphics) -> Fault | None:
    """Call a function on an empty screen; None if all is right."""
    screen.setactivepage(0)
    screen.cleardevice()
    screen.graphdefaults()
    if trial.before is not None:
        trial.before(screen)
        screen.graphdefaults()
    ground = screen.page.array.copy()
    guard = current.screen
    cast(PixelsOnly, guard).calls = 0
    outcome = supervision.call(function, supervision.copied(trial.arguments))
    if current.screen is not guard:
        words = "it opens or closes the screen"
        outcome = Outcome(trouble=Trouble("forbidden", words))
        return Fault(trial, outcome, ground, ground, ground)
    got = screen.page.array.copy()
    expected = trial.expected(got)
    if outcome.trouble is None and outcome.depth > trial.deepest:
        outcome = Outcome(trouble=Trouble("deep", f"it goes {outcome.depth:,} calls deep"))
    if outcome.trouble is None and np.array_equal(got, expected):
        return None
    return Fault(trial, outcome, ground, got, expected)


def _counted(fault: Fault) -> str:
    """How many pixels are wrong, and in which way."""
    if not fault.drawn:
        return "nothing is drawn"
    counts = (
        (fault.missing, "missing"),
        (fault.extra, "too many"),
        (fault.recolored, "in another colour"),
    )
    return ", ".join(
        f"{len(wrong)} {'pixel' if len(wrong) == 1 else 'pixels'} {what}"
        for wrong, what in counts
        if wrong
    )


def _written(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 200 else brief(value)


def places(mask: Any) -> set[Place]:
    """The places x, y where a mask is true."""
    down, across = np.nonzero(mask)
    return set(zip(across.tolist(), down.tolist(), strict=True))


# What bgi itself draws


@functools.cache
def reference() -> Graphics:
    """A screen to draw on what is expected."""
    return Graphics(_mode())


def _mode() -> GraphicsMode:
    mode = find(VGA, VGAHI)
    assert mode is not None
    return mode


def by_bgi(
    draw: Callable[[Graphics], object], before: Callable[[Graphics], None] | None = None
) -> Callable[[Pixels], Pixels]:
    """As `Trial.expected`: exactly what a call of bgi draws."""

    def expected(got: Pixels) -> Pixels:
        screen = reference()
        screen.cleardevice()
        if before is not None:
            before(screen)
        screen.graphdefaults()
        draw(screen)
        return screen.page.array.copy()

    return expected
