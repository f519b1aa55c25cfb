"""`python -m bgi PROGRAM.C`"""

import pytest

from bgi.__main__ import main


@pytest.fixture
def source(tmp_path):
    """Writes a program."""

    def write(text, name="T.C"):
        path = tmp_path / name
        path.write_text(text)
        return str(path)

    return write


def test_a_check_shows_each_line_with_a_caret(source, capsys):
    path = source("void main()\n{\n\tcircel(1, 2, 3);\n}\n")
    assert main(["--check", path]) == 1
    assert capsys.readouterr().err.splitlines() == [
        "T.C:3:2: there is no circel: did you mean circle?",
        "            circel(1, 2, 3);",
        "            ^",
    ]
    assert main(["--check", source("void main() { }")]) == 0


def test_a_fault_is_one_message(source, capsys):
    path = source("void main(int argc, char *argv[])\n{\n  int a = 10 / (argc - 2);\n}\n")
    assert main([path, "word"]) == 3
    assert capsys.readouterr().err.splitlines()[0].endswith("division by zero")
    assert main([path]) == 0


def test_macros_headers_and_a_trace_are_asked_for(source, tmp_path):
    (tmp_path / "more").mkdir()
    (tmp_path / "more" / "MINE.H").write_text("int twice(int x) { return 2 * x; }")
    text = '#include "mine.h"\n#include <stdio.h>\nvoid main() { printf("%d", twice(N)); }'
    trace = tmp_path / "trace"
    options = ["-I", str(tmp_path / "more"), "-D", "N=21", "--script", "A", "--trace", str(trace)]
    assert main([*options, source(text, "t.cpp")]) == 0
    assert trace.read_text() == 'print "42"\nend exit\n'


def test_a_program_says_how_it_ended(source):
    assert main([source("int main() { return 7; }")]) == 7
    assert main([source("#include <stdlib.h>\nvoid main() { exit(4); }")]) == 4
