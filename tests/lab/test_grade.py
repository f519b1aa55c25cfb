"""Grading a folder: marks for honest programs, and no harm by thirty that are not."""

import csv
import sys
from pathlib import Path

import pytest

from bgi.lab import grading, tasks
from bgi.lab.__main__ import main
from bgi.lab.grading import Graded, Limits, TaskMark, grade
from bgi.lab.markspage import write_csv
from tests.processes import gone

RIGHT = """
from bgi import *

def my_line(x1, y1, x2, y2, color):
    steps = max(abs(x2 - x1), abs(y2 - y1))
    for i in range(steps + 1):
        part = i / steps if steps else 0
        putpixel(round(x1 + part * (x2 - x1)), round(y1 + part * (y2 - y1)), color)
"""
BODY = "\ndef my_line(x1, y1, x2, y2, color):\n    "
LINE = tasks.Task("line", "my_line")


def marked(tmp_path: Path, source: str | bytes, **limits: int) -> TaskMark:
    """The mark for one program."""
    folder = tmp_path / "class"
    folder.mkdir(exist_ok=True)
    code = source.encode() if isinstance(source, str) else source
    (folder / "program.py").write_bytes(code)
    (one,) = grade(folder, [LINE], Limits(**{"seconds": 60, "megabytes": 512} | limits))
    (mark,) = one.marks
    return mark


# What it does while it is loaded, and it is right nevertheless: its function is.
HARMLESS = {
    "waits for a key": "from bgi import *\ninitgraph()\ngetch()\ngetch()\nclosegraph()",
    "loops for ever": RIGHT + "while True:\n    pass",
    "loops in one line": RIGHT + "while True: pass",
    "animates until a key": "from bgi import *\ninitgraph()\nwhile not kbhit():\n    delay(20)",
    "exits": RIGHT + "import sys\nsys.exit(1)",
    "reads input": RIGHT + "name = input('Your name? ')",
    "prints a gigabyte": "import os\nfor _ in range(1000):\n    os.write(1, bytes(10**6))",
    "closes its output": "import os, sys\nsys.stdout.close()\nos.closerange(0, 20)",
    "handles signals": "import signal\nfor s in (2, 15):\n    signal.signal(s, lambda *a: None)",
    "starts threads": (
        "import threading, time\ndef run():\n    while True: time.sleep(0.01)\n"
        "for _ in range(20):\n    threading.Thread(target=run).start()"
    ),
    "forks": RIGHT + "import os\nwhile True:\n    os.fork()",
    "starts programs": RIGHT + "import subprocess, sys\nsubprocess.run([sys.executable])",
    "starts a shell": RIGHT + "import os\nos.system('echo > ' + PLACE)",
    "kills its parent": RIGHT + "import os\nos.kill(os.getppid(), 9)",
    "kills its group": RIGHT + "import os\nos.killpg(0, 9)",
    "deletes files": RIGHT + "import os\nos.remove(PLACE)",
    "deletes folders": RIGHT + "import os, shutil\nshutil.rmtree(os.path.dirname(PLACE))",
    "renames files": RIGHT + "import os\nos.rename(PLACE, 'mine')",
    "writes over files": RIGHT + "open(PLACE, 'w').write('gone')",
    "opens a connection": RIGHT + "import socket\nsocket.create_connection(('127.0.0.1', 9))",
    "uses several processes": RIGHT + "import multiprocessing\nmultiprocessing.Pool(50)",
    "calls the system": RIGHT + "import ctypes\nctypes.CDLL(None).abort()",
    "sets a trace": "import sys\nsys.settrace(lambda *a: None)",
    "asks for much memory": RIGHT + "data = bytearray(10 * 2**30)",
    "recurs": RIGHT + "def f():\n    f()\nf()",
    "opens a huge window": "from bgi import *\nfor _ in range(4):\n    initwindow(4096, 4096)",
    "fills the disk": RIGHT + "open('much', 'wb').write(bytes(100 * 2**20))",
    "writes where it may": "open('mine.txt', 'w').write('hello')",
}

# What is wrong, and what the teacher is told.
TOLD = {
    "ends its process": ("import os\nos._exit(3)", "cannot be loaded: it ended its process"),
    "ends it later": (BODY + "import os; os._exit(0)", "it ended its process, with status 0"),
    "sleeps": ("import time\ntime.sleep(1000)", "it was not ready after"),
    "is no Python": ("def my_line(:", "SyntaxError"),
    "is no text": (b"\xff\xfe\x00\x00 caf\xe9", "there is no function my_line"),
    "is Latin-1": (b"name = 'caf\xe9'\n" + RIGHT.encode(), "SyntaxError"),
    "has zeros": (b"x = 1\0", "there is no function my_line"),
    "is empty": ("", "there is no function my_line"),
    "has a number": ("my_line = 5", "my_line is no function"),
    "interrupts": (BODY + "raise KeyboardInterrupt", "it raises KeyboardInterrupt"),
    "computes for ever": (BODY + "return 9**9**9**9", "it was not ready after"),
    "takes memory": (BODY + "return [0] * 10**10", "MemoryError"),
}


@pytest.fixture
def treasure(tmp_path):
    """A file that nobody may touch."""
    folder = tmp_path / "home"
    folder.mkdir()
    file = folder / "treasure.txt"
    file.write_text("gold", "utf-8")
    return file


def unlimited(name):
    """Whether memory is not limited there: no such program is tried then."""
    return name in ("asks for much memory", "takes memory") and not sys.platform.startswith("linux")


@pytest.mark.parametrize("name", [name for name in HARMLESS if not unlimited(name)])
def test_a_program_does_no_harm_and_its_function_is_graded(tmp_path, treasure, name):
    source = HARMLESS[name].replace("PLACE", repr(str(treasure)))
    source = source if RIGHT in source else RIGHT + source
    mark = marked(tmp_path, source)
    assert mark.right, mark.reason
    assert treasure.read_text("utf-8") == "gold"
    assert [file.name for file in treasure.parent.iterdir()] == ["treasure.txt"]
    assert [file.name for file in (tmp_path / "class").iterdir()] == ["program.py"]


SHORT = {"sleeps", "computes for ever"}


@pytest.mark.parametrize("name", [name for name in TOLD if not unlimited(name)])
def test_what_is_wrong_is_told(tmp_path, name):
    source, told = TOLD[name]
    mark = marked(tmp_path, source, seconds=8 if name in SHORT else 60)
    assert not mark.right and told in mark.reason


def test_nothing_stays_behind(tmp_path, monkeypatch):
    """Its process is gone when the mark is there."""
    seen = []
    process = grading._process

    def watched(job: Path, home: Path, limits: Limits) -> str:
        end = process(job, home, limits)
        seen.append(int((home / "pid").read_text("ascii")))
        return end

    monkeypatch.setattr(grading, "_process", watched)
    code = "import os, time\nopen('pid', 'w').write(str(os.getpid()))\ntime.sleep(1000)"
    marked(tmp_path, code, seconds=8)
    assert len(seen) == 1 and gone(seen[0])


def test_one_that_ends_its_process_keeps_its_other_marks(tmp_path):
    both = [LINE, tasks.Task("circle", "my_circle"), tasks.Task("rotation", "my_rotation")]
    source = RIGHT + "import os\ndef my_circle(x, y, radius, color):\n    os._exit(5)\n"
    (tmp_path / "a.py").write_text(source, "utf-8")
    (one,) = grade(tmp_path, both)
    assert [mark.right for mark in one.marks] == [True, False, False]
    assert "it ended its process, with status 5" in one.marks[1].reason
    assert "there is no function my_rotation" in one.marks[2].reason


class TestCommand:
    @pytest.fixture
    def folder(self, tmp_path):
        folder = tmp_path / "class"
        (folder / "ben").mkdir(parents=True)
        (folder / "anna.py").write_text(RIGHT, "utf-8")
        wrong = BODY + "putpixel(x1, y1, '<b>')\nfrom bgi import putpixel"
        (folder / "ben" / "main.py").write_text(wrong, "utf-8")
        return folder

    def test_writes_marks_and_a_page(self, folder, tmp_path, capsys):
        marks, page = tmp_path / "marks.csv", tmp_path / "marks.html"
        assert main(["grade", str(folder), "-o", str(marks)]) == 0
        first, second, last = capsys.readouterr().out.splitlines()
        assert (first, second) == ("1/2 anna.py: 1 of 1", "2/2 ben/main.py: 0 of 1")
        assert last == f"{marks}: the marks; {page}: with reasons and pictures"
        with open(marks, encoding="utf-8-sig", newline="") as file:
            head, anna, ben = csv.reader(file)
        assert head == ["program", "line", "points", "of", "reasons"]
        assert anna == ["anna.py", "1", "1", "1", ""]
        assert ben[:4] == ["ben/main.py", "0", "0", "1"]
        assert ben[4].startswith("line: my_line(20, 30, 29, 30, 15): TypeError")
        text = page.read_text("utf-8")
        assert "&lt;b&gt;" in text and "<b>" not in text
        assert "data:image/png;base64," in text

    def test_takes_a_description(self, folder, tmp_path):
        description = '[line]\nfunction = "my_line"\npoints = 2.5\nexactly = true\n'
        (folder / tasks.DESCRIPTION).write_text(description, "utf-8")
        marks = tmp_path / "marks.csv"
        assert main(["grade", str(folder), "-o", str(marks)]) == 0
        assert "anna.py,0,0,2.5," in marks.read_text("utf-8-sig")

    def test_asks_for_one_function_in_two_ways(self, folder, tmp_path):
        description = (
            '[any]\ncheck = "line"\npoints = 2\n[exact]\ncheck = "line"\nexactly = true\n'
            '[other]\ncheck = "line"\nfunction = "other_line"\n'
        )
        (folder / tasks.DESCRIPTION).write_text(description, "utf-8")
        marks, page = tmp_path / "marks.csv", tmp_path / "marks.html"
        assert main(["grade", str(folder), "-o", str(marks)]) == 0
        with open(marks, encoding="utf-8-sig", newline="") as file:
            head, anna, _ = csv.reader(file)
        assert head == ["program", "any", "exact", "other", "points", "of", "reasons"]
        assert anna[:6] == ["anna.py", "2", "0", "0", "2", "4"]
        assert "exact: my_line(" in anna[6] and "other: there is no function other_line" in anna[6]
        assert "<th>any (2)</th>" in page.read_text("utf-8")

    def test_says_where_a_program_is_no_python(self, folder, tmp_path):
        (folder / "anna.py").write_text("def my_line(:", "utf-8")
        marks = tmp_path / "marks.csv"
        assert main(["grade", str(folder), "--check", "line=my_line", "-o", str(marks)]) == 0
        text = marks.read_text("utf-8-sig")
        assert "as far as the program runs: SyntaxError: invalid syntax (anna.py, line 1)" in text
        assert "submission" not in text

    @pytest.mark.parametrize(
        ("arguments", "told"),
        [
            (["--check", "lines=my_line"], "there is no check 'lines', only line, circle"),
            (["--check", "line"], "write it as in line=my_line"),
            (["--exercises", "none.toml"], "none.toml"),
        ],
    )
    def test_says_what_is_wrong(self, folder, capsys, arguments, told):
        assert main(["grade", str(folder), *arguments]) == 2
        assert told in capsys.readouterr().err

    @pytest.mark.parametrize(
        ("text", "told"),
        [
            ("", "it asks for nothing"),
            ("line = 1", "write a table"),
            ("[line]\npoints = -1", "points must be a number"),
            ("[line]\nfunction = 3", "function must be a name"),
            ("[line]\ndeep = true", "line takes exactly, a boolean"),
            ("[line", "exercises.toml"),
        ],
    )
    def test_says_what_is_wrong_in_a_description(self, folder, text, told):
        file = folder / tasks.DESCRIPTION
        file.write_text(text, "utf-8")
        with pytest.raises(ValueError, match=r"exercises\.toml") as raised:
            tasks.read(file)
        assert told in str(raised.value)

    def test_a_folder_without_programs_is_no_class(self, tmp_path, capsys):
        assert main(["grade", str(tmp_path)]) == 2
        assert "holds no programs" in capsys.readouterr().err


def test_a_spreadsheet_sees_no_formulas(tmp_path):
    file = tmp_path / "marks.csv"
    write_csv(file, [Graded("=1+1.py", [TaskMark(LINE, True)])])
    assert "'=1+1.py,1,1,1," in file.read_text("utf-8-sig")
