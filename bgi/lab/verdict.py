"""Class Verdict: what a check has found, in words and in a picture."""

from __future__ import annotations

from dataclasses import dataclass

from bgi.memory.image import Image


@dataclass(frozen=True)
class Verdict:
    """What a check has found: true if the function is right, so that `assert` and `if` take it."""

    exercise: str
    """What was checked: `line`, `circle`."""
    right: bool
    tried: int
    """Cases that were tried."""
    passed: int = 0
    """Of these, those that were right."""
    reason: str = ""
    """What is wrong, with the first case: empty where nothing is."""
    hint: str = ""
    """Where the mistake may be."""
    picture: Image | None = None
    """Theirs, expected, and the difference, where there is something to see."""

    def __bool__(self) -> bool:
        return self.right

    def __str__(self) -> str:
        if self.right:
            cases = f", all {self.tried} cases" if self.tried > 1 else ""
            return f"{self.exercise}: right{cases}"
        words = [f"{self.exercise}: wrong in {self.tried - self.passed} of {self.tried} cases"]
        if self.tried == 1:
            words = [f"{self.exercise}: wrong"]
        words.append(f"  {self.reason}")
        if self.hint:
            words.append(f"  hint: {self.hint}")
        return "\n".join(words)

    def __repr__(self) -> str:
        return f"<Verdict: {self.exercise} {'right' if self.right else 'wrong'}>"
