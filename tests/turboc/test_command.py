"""`python -m bgi PROGRAM.C`"""

import errno
import os
import warnings

import pytest

from bgi.__main__ import main

ABSENT = os.strerror(errno.ENOENT)


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


def test_the_line_of_an_included_file_is_shown(source, tmp_path, capsys):
    (tmp_path / "more").mkdir()
    (tmp_path / "more" / "MINE.H").write_text("\nint x = y;\n")
    assert main(["-I", str(tmp_path / "more"), source('#include "mine.h"\nvoid main() { }')]) == 1
    assert capsys.readouterr().err.splitlines() == [
        "mine.h:2:9: there is no y",
        "    int x = y;",
        "            ^",
    ]


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


def test_a_warning_shows_the_line_of_c(source, capsys):
    name = source("void main()\n{\n    int gd = 640, gm = 480;\n    initgraph(&gd, &gm, 0);\n}\n")
    with warnings.catch_warnings():
        warnings.simplefilter("always")
        assert main([name]) == 0
    first, line, _ = capsys.readouterr().err.splitlines()
    assert first.partition(".C:")[2].startswith("4:5: warning: driver 640 does not exist; ")
    assert line == "        initgraph(&gd, &gm, 0);"


def test_several_files_are_one_program(source, capsys):
    source("#define LIMIT 7\ntypedef struct { int x; } point;\nint twice(int);\n", "BOTH.H")
    first = source(
        '#include "both.h"\n#include <stdlib.h>\nint shared = 5; point p;\n'
        "void main() { exit(twice(shared) + LIMIT + p.x); }"
    )
    second = source(
        '#include "both.h"\n#undef LIMIT\n#define LIMIT 100\nextern int shared; extern point p;\n'
        "int twice(int n) { p.x = LIMIT; return n + shared; }",
        "U.C",
    )
    assert main([first, second]) == 10 + 7 + 100
    assert main([first, second[:-3] + "V.C"]) == 2
    assert capsys.readouterr().err == f"bgi: {second[:-3]}V.C cannot be read: {ABSENT}\n"


def test_what_is_no_program_is_one_line(source, tmp_path, capsys):
    (tmp_path / "DIR.C").mkdir()
    assert main([str(tmp_path / "DIR.C")]) == 2
    assert capsys.readouterr().err.startswith(f"bgi: {tmp_path / 'DIR.C'} cannot be read: ")
    assert main([source("")]) == 1
    assert capsys.readouterr().err == "T.C: there is no main() in this program\n"


def test_a_file_of_dos_runs(source, tmp_path):
    (tmp_path / "D.C").write_bytes(b"int main()\r\n{\r\n return '\x81';\r\n}\r\n\x1afoo(\x00")
    assert main([str(tmp_path / "D.C")]) == 0x81


def test_ctrl_c_ends_it_without_a_word(source, monkeypatch, capsys):
    monkeypatch.setattr("bgi.turboc.running.Runnable.run", interrupted)
    assert main([source("void main() { }")]) == 130
    assert capsys.readouterr().err == ""


def interrupted(*given):
    """What Ctrl-C does."""
    raise KeyboardInterrupt


def test_nobody_there_is_told(source, capsys):
    assert main([source("#include <conio.h>\nvoid main() { getch(); }")]) == 0
    assert capsys.readouterr().err.startswith("bgi: nobody can press a key here")
