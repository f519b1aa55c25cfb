"""C's files lie in the program's folder: read only, unless the user allows more."""

import os

import pytest

from bgi.__main__ import main
from bgi.turboc.runtime.folders import DiskFolder, MemoryFolder

PROGRAM = """#include <stdio.h>
int main() { FILE *f = fopen(NAME, MODE); int c;
    if (f == NULL) return 1;
    if (*MODE != 'r') fputs("written", f);
    c = fgetc(f);
    fclose(f); return c == 'h' ? 2 : 3; }
"""


@pytest.fixture
def run(tmp_path):
    """Runs a program that opens a file; its exit status."""

    def run(name, mode, *options):
        path = tmp_path / "in" / "P.C"
        path.parent.mkdir(exist_ok=True)
        path.write_text(PROGRAM)
        (tmp_path / "in" / "Here.txt").write_text("here")
        (tmp_path / "outside.txt").write_text("hidden")
        names = f'NAME="{name}"', f'MODE="{mode}"'
        return main([*options, "-D", names[0], "-D", names[1], str(path)])

    return run


def test_a_file_beside_the_program_is_read_in_any_case_and_by_any_path(run):
    assert [run(name, "r") for name in ("HERE.TXT", "c:\\\\tc\\\\here.txt", "./here.txt")] == [
        2
    ] * 3
    assert run("there.txt", "r") == 1


@pytest.mark.parametrize("name", ["../outside.txt", "..\\\\outside.txt", "outside.txt", "link.txt"])
def test_nothing_outside_of_the_folder_is_read(run, tmp_path, name):
    run("Here.txt", "r")
    try:
        os.symlink(tmp_path / "outside.txt", tmp_path / "in" / "link.txt")
    except OSError:
        pytest.skip("this system makes no links")
    assert run(name, "r") == 1


def test_writing_is_refused_with_one_line_and_allowed_by_files(run, tmp_path, capfd):
    assert run("new.txt", "w") == 1
    assert "--files lets it write" in capfd.readouterr().err
    assert not (tmp_path / "in" / "new.txt").exists()
    assert run("new.txt", "w", "--files") == 3
    assert (tmp_path / "in" / "new.txt").read_text() == "written"
    assert run("../up.txt", "w", "--files") == 3  # the last name counts
    assert not (tmp_path / "up.txt").exists() and (tmp_path / "in" / "up.txt").exists()
    assert run("con", "w", "--files") == 1


def test_a_scripted_program_meets_an_empty_folder_in_memory(run, tmp_path):
    assert run("Here.txt", "r", "--script", "A") == 1
    assert run("new.txt", "w", "--script", "A") == 3
    assert not (tmp_path / "in" / "new.txt").exists()


def test_a_folder_in_memory_keeps_what_is_closed():
    folder = MemoryFolder()
    assert folder.open("a.txt", True, False, False) is None
    with folder.open("A.TXT", False, True, True) as file:
        file.write(b"text")
    assert folder.has("c:\\a.txt")
    assert folder.open("a.txt", True, False, False).read() == b"text"


def test_the_names_of_a_pattern_and_what_is_done_to_them(tmp_path):
    for name in ("B.DAT", "a.dat", "c.txt"):
        (tmp_path / name).write_text(name)
    (tmp_path / "sub").mkdir()
    folder = DiskFolder(tmp_path, True)
    assert [one[0] for one in folder.names("*.dat")] == ["a.dat", "B.DAT"]
    assert [one[0] for one in folder.names("*.*")] == ["a.dat", "B.DAT", "c.txt", "sub"]
    assert folder.rename("A.DAT", "d.dat") and not folder.rename("none", "e.dat")
    assert folder.remove("b.dat") and not folder.remove("sub") and not folder.remove("b.dat")
    assert folder.make("deep") and folder.drop("deep") and not folder.drop("deep")
    assert folder.enter("SUB") and folder.names("*") == [] and folder.enter("..")
    assert not folder.enter("..") and not folder.enter("c.txt")
    assert sorted(os.listdir(tmp_path)) == ["c.txt", "d.dat", "sub"]


def test_a_folder_that_is_only_read_is_not_changed(tmp_path, capsys):
    (tmp_path / "a.txt").write_text("a")
    folder = DiskFolder(tmp_path, False)
    assert not folder.remove("a.txt") and not folder.rename("a.txt", "b.txt")
    assert not folder.make("sub") and folder.path("a.txt", writing=True) is None
    assert capsys.readouterr().err.count("--files") == 1


TEXT = """#include <stdio.h>
int main() { FILE *f = fopen("T.TXT", "MODE"); int c, n = 0;
    while ((c = fgetc(f)) != EOF) n++;
    return n; }
"""


@pytest.mark.parametrize(("mode", "count"), [("r", 4), ("rt", 4), ("rb", 10)])
def test_a_text_of_dos_ends_its_lines_and_itself_as_there(tmp_path, mode, count):
    (tmp_path / "T.TXT").write_bytes(b"a\r\nb\n\x1ax\ryz")
    path = tmp_path / "P.C"
    path.write_text(TEXT.replace("MODE", mode))
    assert main([str(path)]) == count
