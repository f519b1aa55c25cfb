"""What mypy says of a user's calls, right ones and wrong ones."""

from pathlib import Path

import pytest


def misjudged(calls: Path) -> set[int]:
    """The lines of a file where mypy disagrees with the mark `# wrong` at their end, or its lack.

    It judges as it does a user's file, without the settings of this project.
    """
    pytest.importorskip("mypy", reason="needs mypy")
    from mypy import api

    how = ["--config-file=", "--strict", "--follow-imports=silent", "--no-error-summary"]
    report, errors, _ = api.run([*how, str(calls)])
    assert not errors
    refused = {int(line.split(":")[1]) for line in report.splitlines() if ": error:" in line}
    lines = calls.read_text("utf-8").splitlines()
    wrong = {number for number, line in enumerate(lines, 1) if line.endswith("# wrong")}
    assert wrong
    return refused ^ wrong
