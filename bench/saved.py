"""Runs in files: `--save` keeps one, `--against` compares with it, the README is made of it.

A run from another commit is compared in units, so that it may have been a slower day.
"""

import json
import platform
from dataclasses import asdict, dataclass, field
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from bench.timing import Result

PACKAGES = ("numpy", "pygame", "pygame-ce", "sdl_bgi", "matplotlib")


@dataclass
class Run:
    """All that one run measured, and with what."""

    rounds: int
    missing: list[str]
    """Peers that are not installed."""
    unit: float
    """Seconds."""
    results: list[Result]
    versions: dict[str, str] = field(default_factory=lambda: versions())

    def save(self, path: Path) -> None:
        """Write it as JSON."""
        made = asdict(self) | {"results": [result._asdict() for result in self.results]}
        path.write_text(json.dumps(made, indent=1) + "\n", encoding="utf-8")

    @classmethod
    def load(cls, path: Path) -> "Run":
        """Read it again."""
        read = json.loads(path.read_text(encoding="utf-8"))
        return cls(**read | {"results": [Result(**result) for result in read["results"]]})


def versions() -> dict[str, str]:
    """Of Python and of what is installed."""
    found = {"Python": platform.python_version()}
    for package in PACKAGES:
        try:
            found[package] = version(package)
        except PackageNotFoundError:
            continue
    return found
