"""What every check does: it disturbs no screen, survives any function, and says what it found."""

import contextlib
import sys

import pytest

import bgi
from bgi import current, putpixel
from bgi.lab import Verdict, check
from tests import program
from tests.lab.test_line import bresenham, dda


def drawing(what):
    """A function for check.line that does this."""

    def my_line(x1, y1, x2, y2, color):
        what()

    return my_line


class TestScreen:
    def test_one_that_is_open_is_left_as_it_is(self):
        bgi.initgraph(bgi.EGA, bgi.EGAHI)
        bgi.setviewport(10, 10, 300, 200, 1)
        bgi.circle(50, 50, 30)
        bgi.setpalette(99, 99)  # an error that nobody has asked for yet
        before = program.state()
        assert check.line(dda)
        assert not check.line(drawing(lambda: bgi.setviewport(0, 0, 5, 5, 1)))
        assert program.state() == before

    def test_none_is_needed_and_none_stays(self):
        assert check.line(dda)
        assert not current.is_open()

    def test_the_function_may_not_open_or_close_one(self):
        bgi.initgraph(bgi.VGA, bgi.VGAHI)
        for call in (bgi.closegraph, bgi.initgraph, lambda: bgi.initwindow(50, 50)):
            verdict = check.line(drawing(call))
            assert not verdict and "opens or closes the screen" in verdict.reason
            assert bgi.getmaxx() == 639

    def test_a_check_in_a_check_is_no_harm(self):
        def my_line(x1, y1, x2, y2, color):
            if (x1, y1) == (x2, y2) and x1 == 20:
                assert check.line(dda)
            dda(x1, y1, x2, y2, color)

        assert check.line(my_line)

    def test_strict_and_slow_are_not_for_it(self):
        bgi.initgraph(bgi.VGA, bgi.VGAHI)
        with bgi.strict(), bgi.slow(1):
            assert check.line(dda)


def endless():
    while True:
        pass


def endless_in_one_line():
    """Of which Python 3.11 shows a debugger no line; newer ones may."""
    while True: pass  # fmt: skip  # noqa: E701


def endless_whatever_comes():
    with contextlib.suppress(BaseException):  # a bare except, as beginners write it
        endless()


def too_deep():
    too_deep()


def deeper_than_python_likes():
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(10**8)
    try:
        too_deep()
    finally:
        sys.setrecursionlimit(limit)


class Strange(Exception):
    def __str__(self):
        raise self


def strange():
    raise Strange


SURVIVED = [
    (endless, "it does not end"),
    (endless_in_one_line, "it does not end: stopped after "),
    (endless_whatever_comes, "it does not end"),
    (lambda: sys.exit(3), "it ends the program"),
    (lambda: input("x?"), "it asks for input"),
    (bgi.getch, "nobody can press a key"),
    (too_deep, "calls deep"),
    (deeper_than_python_likes, "it was stopped 20,000 calls deep"),
    (strange, "an error that cannot be printed"),
    (lambda: [][1], "IndexError: list index out of range ("),
    (lambda: putpixel("1", 2, 3), "x must be a number"),
    (lambda: bgi.bar(0, 0, 9, 9), "it calls bar()"),
    (lambda: sys.stdout.close(), "nothing is drawn"),
    (lambda: print("where am I"), "it printed: 'where am I'"),
]


@pytest.mark.parametrize(("what", "told"), SURVIVED, ids=[told for _, told in SURVIVED])
def test_nothing_that_a_function_does_ends_the_check(what, told):
    verdict = check.line(drawing(what))
    assert not verdict
    assert told in verdict.reason
    assert sys.gettrace() is None


def test_what_it_prints_is_kept_to_itself(capsys):
    check.line(drawing(lambda: print("x" * 10**6)))
    assert len(capsys.readouterr().out) < 3000


def test_pixels_are_counted_for_each_call_alone():
    def my_line(x1, y1, x2, y2, color):
        for _ in range(500):
            putpixel(x1, y1, color)
        dda(x1, y1, x2, y2, color)

    assert check.line(my_line)


def test_ctrl_c_comes_through():
    def interrupted():
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        check.line(drawing(interrupted))


def test_the_place_of_an_error_is_told():
    def my_line(x1, y1, x2, y2, color):
        return x1 / 0

    reason = check.line(my_line).reason
    number = my_line.__code__.co_firstlineno + 1
    assert f"test_checks.py, line {number}: return x1 / 0)" in reason


class TestArguments:
    def test_a_function_with_others_is_told_which(self):
        verdict = check.line(lambda x1, y1, x2, y2: None)
        assert "it must take 5 arguments, x1, y1, x2, y2, color" in verdict.reason

    def test_what_is_no_function_is_refused(self):
        with pytest.raises(TypeError, match="without more brackets, not None"):
            check.line(None)

    def test_a_method_will_do(self):
        class Pen:
            def line(self, x1, y1, x2, y2, color):
                bresenham(x1, y1, x2, y2, color)

        assert check.line(Pen().line)


class TestVerdict:
    def test_says_what_was_found(self, capsys):
        verdict = check.line(dda)
        assert isinstance(verdict, Verdict)
        assert str(verdict) == f"line: right, all {verdict.tried} cases"
        assert capsys.readouterr().out == f"{verdict}\n"
        assert repr(verdict) == "<Verdict: line right>"
        assert verdict.picture is None

    def test_is_false_and_tells_the_first_case(self):
        verdict = check.line(drawing(lambda: None))
        assert not verdict
        first, reason, hint = str(verdict).splitlines()
        assert first == f"line: wrong in {verdict.tried} of {verdict.tried} cases"
        assert reason == "  my_line(20, 30, 29, 30, 15): nothing is drawn"
        assert hint == f"  hint: {verdict.hint}"

    def test_shows_yours_expected_and_difference(self):
        def my_line(x1, y1, x2, y2, color):
            putpixel(x1, y1, color)
            putpixel(x1 + 1, y1, 3)
            putpixel(x1 + 2, y1 + 1, color)

        image = check.line(my_line).picture
        assert image is not None
        colors = set(image.array.ravel().tolist())
        assert {bgi.LIGHTRED, bgi.LIGHTBLUE, bgi.YELLOW} <= colors

    def test_is_saved_where_it_is_asked_for(self, tmp_path, monkeypatch, capsys):
        monkeypatch.setattr(check, "save", tmp_path / "new")
        check.line(drawing(lambda: None))
        file = tmp_path / "new" / "line.png"
        assert file.read_bytes().startswith(b"\x89PNG")
        assert str(file) in capsys.readouterr().out


def test_a_debugger_stays_at_work():
    seen = []

    def debugger(frame, event, argument):
        seen.append(event)

    sys.settrace(debugger)
    try:
        verdict = check.line(dda)
        assert sys.gettrace() is debugger
    finally:
        sys.settrace(None)
    assert verdict and seen
