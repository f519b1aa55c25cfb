"""A skip that nobody expects is a failure."""

import ast
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests import skips
from tests.browser import CANNOT

ROOT = Path(__file__).parents[1]

TESTS = """
import pytest

@pytest.fixture
def tool():
    pytest.skip("nobody knows why")

def test_with_a_tool(tool): ...

def test_that_gives_up():
    pytest.skip("needs shapely")

@pytest.mark.skipif(True, reason="uses wings")
def test_for_birds(): ...

@pytest.mark.xfail(strict=True)
def test_of_a_fault():
    assert False

def test_that_runs(): ...
"""


def test_an_unexpected_skip_fails_the_run(tmp_path: Path) -> None:
    (tmp_path / "pytest.ini").touch()
    (tmp_path / "test_some.py").write_text(TESTS, "utf-8")
    ran = subprocess.run(
        [sys.executable, "-m", "pytest", "-p", "tests.skips"],
        env=os.environ | {"CI": "true", "PYTHONPATH": str(Path(__file__).parents[1])},
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert ran.returncode == 1
    for line in (
        "skipped for a reason that tests/skips.py does not know: nobody knows why",
        "skipped here, where the reason does not hold: needs shapely",
        "skipped for a reason that tests/skips.py does not know: uses wings",
        "1 failed, 1 passed, 1 xfailed, 2 errors",
    ):
        assert line in ran.stdout


def test_a_reason_counts_only_where_it_holds(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(skips, "REASONS", {"needs wings": True, "needs legs": False})
    assert skips.unexpected("needs wings") == ""
    assert "does not hold: needs legs" in skips.unexpected("needs legs")
    assert "does not know: needs fins" in skips.unexpected("needs fins")


def _reasons(source: str) -> Iterator[str]:
    """The reasons that a test file writes down; "": one that pytest makes up."""
    for node in ast.walk(ast.parse(source)):
        name = ast.unparse(node.func).rpartition(".")[2] if isinstance(node, ast.Call) else ""
        if isinstance(node, ast.Call) and name in ("skip", "skipif", "importorskip"):
            given = [word.value for word in node.keywords if word.arg == "reason"]
            reason = given[0] if given else node.args[0] if name == "skip" else ast.Constant("")
            if isinstance(reason, ast.Constant):
                yield str(reason.value)


def test_every_reason_that_a_test_gives_is_known() -> None:
    # Where it is not, the test fails on a system that we do not run here.
    for file in sorted((ROOT / "tests").rglob("*.py")):
        if file != Path(__file__):
            for reason in _reasons(file.read_text("utf-8")):
                assert reason in skips.REASONS, f"{file.relative_to(ROOT)}: {reason!r}"


def test_what_a_browser_cannot_do_is_a_test_of_ours():
    for files in CANNOT.values():
        for file, names in files.items():
            text = (ROOT / file).read_text("utf-8")
            for name in names:
                assert f"def {name.partition('[')[0].rpartition('::')[2]}(" in text
