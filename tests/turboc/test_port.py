"""`python -m bgi PROGRAM.C --port PROGRAM.py`: what is written, and that it does the same."""

import subprocess
import sys
from pathlib import Path

import pytest

from bgi.__main__ import main
from bgi.turboc.faults import CErrors
from bgi.turboc.port.porting import ported
from bgi.turboc.understanding import Understood

PORTS = Path(__file__).parent / "port"
DEMOS = Path(__file__).parents[2] / "demos" / "c"
SOURCES = sorted(PORTS.glob("*.C*"))
ALIKE = [*SOURCES, *sorted(DEMOS.glob("*.C*"))]


def names(paths):
    return pytest.mark.parametrize("source", paths, ids=[path.name for path in paths])


def python_of(path):
    return ported(Understood(str(path), {}))


@names(SOURCES)
def test_a_port_is_what_a_person_would_have_written(source):
    assert python_of(source) == source.with_suffix(".py").read_text(encoding="utf-8")


def traced(program, trace, script):
    command = ["--monitor", "none", "--script", script, "--trace", str(trace), str(program)]
    subprocess.run([sys.executable, "-m", "bgi", *command], stdout=subprocess.DEVNULL, check=True)
    return trace.read_text()


@names(ALIKE)
def test_a_port_does_what_the_original_does(source, tmp_path):
    port = tmp_path / "port.py"
    port.write_text(python_of(source), encoding="utf-8")
    assert traced(port, tmp_path / "p", "A") == traced(source, tmp_path / "c", "A")


@names(ALIKE)
def test_no_line_is_too_long(source):
    assert max(map(len, python_of(source).splitlines())) < 100


def test_the_option_stands_before_the_program_or_behind_it(tmp_path, capsys):
    source, port = str(PORTS / "STARS.C"), tmp_path / "stars.py"
    for words in (["--port", str(port), source], [source, "--port", str(port)]):
        assert main(words) == 0
        assert port.read_text(encoding="utf-8").startswith('"""STARS.C: stars that fly')
        port.unlink()
    assert capsys.readouterr().err == f"bgi: {port} was written\n" * 2


def test_the_shell_is_asked_for_nothing_that_is_known_here(tmp_path):
    source = tmp_path / "T.C"
    source.write_text(
        '#include <stdlib.h>\nvoid main()\n{\n  system("cls");\n  system("PAUSE");\n}\n'
    )
    lines = python_of(source).splitlines()
    begin = lines.index("def main():") + 1
    assert [line.strip() for line in lines[begin : begin + 3]] == [
        "clrscr()",
        'printf("Press any key to continue . . . ")',
        "getch()",
    ]


@pytest.mark.parametrize(
    ("call", "why"),
    [
        ("fread(&n, 2, 1, f)", "fread(): the bytes of a variable in a file"),
        ('fscanf(f, "%d", &n)', "fscanf(): read a line of the file, and split it"),
        ("putw(n, f)", "putw() in a file that is opened as text"),
    ],
)
def test_what_python_does_otherwise_with_files_is_told(tmp_path, call, why):
    source = tmp_path / "T.C"
    source.write_text(
        '#include <stdio.h>\nvoid main()\n{\n  int n = 1;\n  FILE *f = fopen("T.TXT", "r");\n'
        f"  {call};\n}}\n"
    )
    with pytest.raises(CErrors) as refused:
        python_of(source)
    assert str(refused.value.errors[0]).endswith(why)


def test_streams_of_files_are_told_by_their_name(tmp_path):
    source = tmp_path / "T.CPP"
    source.write_text(
        "#include <fstream.h>\nvoid main()\n{\n  int n;\n"
        '  ofstream f("T.DAT");\n  f.write((char *)&n, 2);\n  f << n;\n}\n'
    )
    with pytest.raises(CErrors) as refused:
        python_of(source)
    assert [str(one).partition("Python: ")[2] for one in refused.value.errors] == [
        "f.write() of an ofstream: only cout and cin are known"
    ]


def test_a_file_that_nobody_asks_for_is_empty(tmp_path):
    source, port = tmp_path / "T.C", tmp_path / "t.py"
    source.write_text(
        '#include <stdio.h>\nFILE *f;\nvoid main()\n{\n  f = fopen("A:\\\\T.DAT", "rb");\n'
        '  printf("%d", getw(f));\n  fclose(f);\n}\n'
    )
    port.write_text(python_of(source))
    assert 'print "-1"' in traced(port, tmp_path / "p", "A")


def test_what_cannot_be_carried_over_is_told_with_its_line(tmp_path, capsys):
    source, port = tmp_path / "T.C", tmp_path / "t.py"
    source.write_text('#include <stdlib.h>\nvoid main()\n{\n  system("dir");\n}\n')
    assert main([str(source), "--port", str(port)]) == 1
    assert capsys.readouterr().err.splitlines() == [
        "T.C:4:3: this cannot be carried over to Python: system(): it would start another program",
        '      system("dir");',
        "      ^",
    ]
    assert not port.exists()


def test_no_source_is_overwritten(tmp_path, capsys):
    source = str(PORTS / "STARS.C")
    assert main([source, "--port", str(tmp_path / "STARS.C")]) == 2
    assert capsys.readouterr().err == "bgi: --port writes Python: give it a name that ends in .py\n"
    assert main([source, "--port", str(tmp_path / "no" / "stars.py")]) == 2
    assert "cannot be written" in capsys.readouterr().err
