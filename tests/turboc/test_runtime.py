"""The library of a C program, its script and its trace, without the compiler."""

import signal
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace

import pytest

from bgi import conio
from bgi.turboc.runtime.library import FUNCTIONS, names
from bgi.turboc.runtime.memory import Pointer
from bgi.turboc.runtime.scripted import script
from bgi.turboc.runtime.session import Session
from tests.skips import BROWSER

C = SimpleNamespace
"""The library."""


def traced(tmp_path: Path, main: Callable[[C], object], variant: str = "A") -> list[str]:
    """The lines of the trace that a program leaves; it gets the library."""
    file = tmp_path / "trace"
    program = Session(file, variant)
    library = SimpleNamespace(**names(program))
    program.run(lambda: main(library))
    return file.read_text(encoding="ascii").splitlines()


def open_graphics(c: C) -> None:
    c.initgraph(Pointer([0]), Pointer([7]), b"C:\\TC\\BGI")


def test_every_function_that_is_declared_is_there(tmp_path: Path) -> None:
    assert set(FUNCTIONS) <= set(names(Session(None, "A")))


def test_a_call_is_a_line_and_a_query_has_its_answer(tmp_path: Path) -> None:
    def main(c: C) -> None:
        open_graphics(c)
        c.circle(100, 200, c.getmaxx())
        c.outtextxy(1, -2, b'say "\\"\n\x80')
        c.setlinestyle(0, 0xFFFF, 3)
        c.closegraph()

    assert traced(tmp_path, main) == [
        'initgraph 0 0 "C:\\\\TC\\\\BGI" -> 9 2',
        "getmaxx -> 639",
        "circle 100 200 639",
        'outtextxy 1 -2 "say \\"\\\\\\"\\n\\x80"',
        "setlinestyle 0 -1 3",
        "closegraph",
        "end exit",
    ]


def test_output_runs_together_until_something_else_happens(tmp_path: Path) -> None:
    def main(c: C) -> None:
        c.printf(b"%d-", 12)
        c.puts(b"x")
        c.gotoxy(3, 4)
        c.putchar(65)

    assert traced(tmp_path, main) == ['print "12-x\\n"', "gotoxy 3 4", 'print "A"', "end exit"]


def test_output_is_cut_after_256_bytes(tmp_path: Path) -> None:
    lines = traced(tmp_path, lambda c: c.printf(b"%300s", b"x"))
    assert [len(line) for line in lines[:2]] == [256 + 8, 44 + 8]


@pytest.mark.parametrize(("variant", "numbers"), [("A", [100, 100]), ("B", [3, 100])])
def test_scanf_reads_the_typed_numbers_of_the_script(
    tmp_path: Path, variant: str, numbers: list[int]
) -> None:
    memory = [0, 0]

    def main(c: C) -> None:
        assert c.scanf(b"%d%d", Pointer(memory, 0), Pointer(memory, 1)) == 2

    assert traced(tmp_path, main, variant)[:2] == [f'read "{number}"' for number in numbers]
    assert memory == numbers


def test_streams_write_and_read(tmp_path: Path) -> None:
    number = Pointer([0])

    def main(c: C) -> None:
        c.cin.shift_right_int_reference(number)
        c.cout.shift_left_manipulator(c.setw(5)).shift_left_int(number.memory[0])
        c.cout.shift_left_manipulator(c.hex).shift_left_int(-1).shift_left_manipulator(
            c.endl.copy()
        )
        c.cout.shift_left_double(1 / 3)

    assert traced(tmp_path, main) == ['read "100"', 'print "  100ffff\\n0.333333"', "end exit"]


def test_drawing_without_graphics_ends_the_program_as_borland_did(tmp_path: Path) -> None:
    assert traced(tmp_path, lambda c: c.line(1, 2, 3, 4)) == [
        "print \"BGI Error: Graphics not initialized (use 'initgraph')\\n\"",
        "end nograph",
    ]


def test_a_program_that_traces_without_end_is_ended(tmp_path: Path) -> None:
    def main(c: C) -> None:
        while True:
            c.kbhit()

    lines = traced(tmp_path, main)
    assert len(lines) == 20_001 and lines[-1] == "end lines"


@pytest.mark.skipif(BROWSER, reason="there are no threads")
def test_a_scripted_program_that_only_computes_is_ended(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("bgi.turboc.runtime.session.SECONDS", 0.05)
    monkeypatch.setattr("bgi.turboc.runtime.timelimit.LOOK_SECONDS", 0.1)
    before = signal.getsignal(signal.SIGTERM)
    assert traced(tmp_path, forever) == ["end cpu"]
    assert traced(tmp_path, lambda c: c.atexit(lambda: forever(c))) == ["end cpu"]
    assert signal.getsignal(signal.SIGTERM) is before


def forever(c: C) -> None:
    """Compute, and swallow an exception once, as a destructor in Python does."""
    with suppress(BaseException):
        while True:
            pass
    while True:
        pass


def test_a_fault_is_told_and_traced(tmp_path: Path) -> None:
    with pytest.raises(ZeroDivisionError):
        traced(tmp_path, lambda c: 1 // 0)
    assert (tmp_path / "trace").read_text(encoding="ascii") == "end divide\n"
    with pytest.raises(ValueError):
        traced(tmp_path, lambda c: int(float("nan")))
    assert (tmp_path / "trace").read_text(encoding="ascii") == "end crash\n"


def test_exit_runs_the_functions_of_atexit_backwards(tmp_path: Path) -> None:
    def main(c: C) -> None:
        c.atexit(lambda: c.puts(b"1"))
        c.atexit(lambda: c.puts(b"2"))
        c.exit(3)

    assert traced(tmp_path, main) == ['print "2\\n1\\n"', "end exit"]


def test_the_scripted_keyboard() -> None:
    pc = script("A")
    assert [pc.kbhit() for _ in range(61)] == [0] * 60 + [1]
    assert pc.bioskey(1) == 0x1C0D
    assert [pc.getch() for _ in range(5)] == [13, ord("1"), ord(" "), 0, 77]
    assert pc.kbhit() == 0


def test_the_scripted_clock_and_mouse() -> None:
    pc = script("A")
    assert (pc.now(), pc.milliseconds()) == (708_609_600, 55)
    looks = [pc.mouse() for _ in range(16)]
    assert looks[0] == (0, 100, 100) and looks[4] == (1, 100, 100) and looks[8] == (0, 200, 150)


def test_int86_asks_the_mouse(tmp_path: Path) -> None:
    def main(c: C) -> None:
        registers = Pointer([c.struct_REGS()])
        registers.memory[0].h.al = 3
        c.int86(0x33, registers, registers)
        assert (registers.memory[0].x.cx, registers.memory[0].h.dl) == (100, 100)

    assert traced(tmp_path, main)[0] == "int86 51 3 0 0 0 -> 3 0 100 100"


def test_strings(tmp_path: Path) -> None:
    c = SimpleNamespace(**names(Session(None, "A")))
    memory = bytearray(20)
    to = Pointer(memory)
    c.strcat(c.strcpy(to, b"one,two"), b";3")
    assert memory.partition(b"\0")[0] == b"one,two;3"
    assert (c.strchr(to, ord(",")).at, c.strchr(to, ord("x")), c.strlen(to)) == (3, None, 9)
    words = [c.strtok(to, b",;"), c.strtok(None, b",;"), c.strtok(None, b",;")]
    assert [word.at for word in words] == [0, 4, 8] and c.strtok(None, b",;") is None
    with pytest.raises(IndexError):
        c.strcpy(to, b"x" * 20)


def test_conio_writes_in_the_text_colour_and_stdio_does_not(tmp_path: Path) -> None:
    def main(c: C) -> None:
        c.clrscr()
        c.textcolor(12)
        c.putch(ord("a"))
        c.cputs(b"b")
        c.cprintf(b"%c", ord("c"))
        c.ungetch(ord("d"))
        c.getche()
        c.printf(b"e")

    traced(tmp_path, main)
    cells = conio.gettext(1, 1, 5, 1)
    assert [color & 15 for color in cells[1::2]] == [12, 12, 12, 12, 7]
