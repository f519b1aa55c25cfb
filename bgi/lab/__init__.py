"""Exercises that check themselves, and the grading of a class: `from bgi.lab import check`."""

from bgi.lab import check as check
from bgi.lab.verdict import Verdict as Verdict

__all__ = ["Verdict", "check"]
