"""Our own C programs go through the library, header by header; their traces were checked by gcc."""

from pathlib import Path

import pytest

from bgi.__main__ import main

PROGRAMS = sorted(Path(__file__).with_name("library").glob("*.C*"))


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.stem)
def test_a_program_leaves_the_right_trace(program, tmp_path):
    trace = tmp_path / "trace"
    assert main(["--script", "A", "--trace", str(trace), str(program)]) == 0
    assert trace.read_text().splitlines() == program.with_suffix(".trace").read_text().splitlines()
