"""stdio.h on the screen: what is written, what is typed, and Python's own words."""

import errno
import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

import bgi
from bgi import conio, current, stdio
from bgi.stdio import printf, puts, scanf


def lines(count=25):
    """The first rows of the text screen, without the blanks behind them."""
    cells = current.console().cells.array[:count]
    return [(row & 0xFF).astype("u1").tobytes().decode("cp437").rstrip() for row in cells]


@pytest.fixture
def typed(monkeypatch):
    """A function that has a text typed, Enter where a line ends."""

    def type_in(text):
        named = {"\n": "Enter", " ": "Space", "\b": "Backspace", "\x1b": "Esc", "\t": "Tab"}
        monkeypatch.setenv("BGI_KEYS", " ".join(named.get(c, c) for c in text))

    return type_in


# Writing


def test_a_first_program(typed):
    typed("7\n")
    printf("How old are you? ")
    age = scanf("%d")
    assert age == 7
    assert printf("In %d years you will be %d.\n", 10, age + 10) == 28
    assert lines(3) == ["How old are you? 7", "In 10 years you will be 17.", ""]


def test_puts_putchar_fprintf_fputs():
    assert (puts("one"), stdio.putchar("t"), stdio.putchar(ord("w"))) == (10, ord("t"), ord("w"))
    assert stdio.fputs("o\n", stdio.stdout) == 10
    assert stdio.fprintf(stdio.stderr, "%s %c\n", "three", "!") == 8
    assert lines(3) == ["one", "two", "three !"]
    with pytest.raises(TypeError, match="stream must be stdout or stderr, not 3"):
        stdio.fprintf(3, "x")


def test_a_tab_goes_to_the_next_eighth_column_and_a_line_feed_to_a_new_line():
    printf("a\tb\n\tc")
    assert lines(2) == ["a       b", "        c"]


def test_a_format_that_is_wrong_writes_nothing():
    printf("before")
    with pytest.raises(TypeError, match="%d"):
        printf("%d %d", 1)
    assert lines(1) == ["before"]


def test_perror_says_what_went_wrong():
    stdio.perror("nothing")
    try:
        raise FileNotFoundError(errno.ENOENT, "whatever Python says")
    except OSError:
        stdio.perror("data.txt")
    assert lines(2) == ["nothing: Error 0", "data.txt: No such file or directory"]


def test_sprintf_and_sscanf_know_no_screen():
    assert stdio.sprintf("%05.1f|%-4s|", 3.14159, "ab") == "003.1|ab  |"
    assert stdio.sscanf("3 4", "%d%d") == (3, 4)
    assert not current.is_open()


# Typing


def test_values_in_one_line_and_in_several(typed):
    typed("3 4\n5\n2.5 word\n")
    assert scanf("%d%d%d") == (3, 4, 5)
    assert scanf("%f%s") == (2.5, "word")
    assert lines(4) == ["3 4", "5", "2.5 word", ""]


def test_backspace_takes_back_and_esc_takes_back_all(typed):
    typed("12\b3\n" + "wrong\x1bright\n")
    assert scanf("%d") == 13
    assert stdio.gets() == ""  # the rest of the line, as in C
    assert stdio.gets() == "right"
    assert lines(2) == ["13", "right"]


def test_backspace_goes_back_to_the_row_above(typed):
    typed("abcd\b\b\bx\n")
    printf("%78s", ">")
    assert stdio.gets() == "ax"
    assert lines(2) == [" " * 77 + ">ax", ""]


def test_the_rest_of_a_line_waits_until_it_is_flushed(typed):
    typed("1 2\n3\n")
    assert scanf("%d") == 1
    assert stdio.fflush(stdio.stdin) == 0
    assert scanf("%d") == 3
    assert stdio.getchar() == 10
    assert stdio.fflush(stdio.stdout) == 0


def test_the_rest_of_a_line_goes_with_the_screen(typed):
    typed("1 2\n")
    assert scanf("%d") == 1
    current.close_screen()
    assert scanf("%d") == 1


def test_getchar_waits_for_enter(typed):
    typed("ab\n")
    assert [stdio.getchar() for _ in range(3)] == [ord("a"), ord("b"), 10]


def test_ctrl_z_ends_the_input(monkeypatch):
    screen = current.console()
    for key in (b"\x1a", b"\r"):
        current.screen.monitor.keys.load([key])
    assert stdio.getchar() == stdio.EOF
    current.screen.monitor.keys.load([b"\x1a", b"\r"])
    assert stdio.gets() is None
    assert lines(2) == ["^Z", "^Z"]
    assert screen is current.console()


def test_ctrl_c_interrupts():
    conio.clrscr()
    current.screen.monitor.keys.load([b"a", b"\x03"])
    with pytest.raises(KeyboardInterrupt):
        scanf("%d")


def test_what_does_not_fit_is_none(typed):
    typed("x\n")
    assert scanf("%d") is None
    assert stdio.gets() == "x"


def test_a_line_is_never_longer_than_dos_takes(typed):
    typed("9" * 300 + "\n")
    assert stdio.gets() == "9" * 126


def test_cgets_cscanf_and_getpass_read_in_the_window(typed):
    typed("Eve\n" + "7 8\n" + "secret\n" + "123456789\n")
    conio.window(5, 2, 30, 10)
    conio.cputs("Name: ")
    assert conio.cgets() == "Eve"
    assert conio.cscanf("%d%d") == (7, 8)
    assert conio.getpass("Word? ") == "secret"
    assert conio.cgets(4) == "1234"
    assert lines(5) == ["", "    Name: Eve", "    7 8", "    Word?", "    1234"]
    with pytest.raises(ValueError, match="longest must be 1 to 254, not 0"):
        conio.cgets(0)


def test_cscanf_refuses_what_is_no_format_before_a_line_is_typed(typed):
    typed("7\n")
    with pytest.raises(ValueError, match="no conversion of scanf"):
        conio.cscanf("%y")
    assert lines(1) == [""]
    assert conio.cscanf("%d") == 7


def test_cprintf_knows_the_window_and_the_attribute():
    conio.window(79, 1, 80, 2)
    conio.textattr(0x4E)
    assert conio.cprintf("%d%c", 12, "x") == 3
    assert conio.gettext(79, 1, 80, 2) == b"1\x4e2\x4ex\x4e \x07"


def test_numbers_typed_over_a_picture(typed):
    typed("100\n")
    bgi.initgraph()
    conio.gotoxy(1, 5)
    printf("Radius: ")
    radius = scanf("%d")
    bgi.circle(320, 240, radius)
    page = current.screen.page.array
    assert radius == 100
    assert page[64:80, : 8 * 11].any() and not page[80:140].any()


def test_nobody_types_without_keys():
    with pytest.raises(bgi.NobodyThere):
        scanf("%d")


# Python's own words


def test_print_and_input_go_to_the_screen(typed, capsys):
    typed("Ada\n")
    before = sys.stdin, sys.stdout, sys.stderr
    with stdio.on_screen():
        name = input("Name? ")
        print("Hello,", name)
        print("careful", file=sys.stderr)
    assert lines(4) == ["Name? Ada", "Hello, Ada", "careful", ""]
    assert (sys.stdin, sys.stdout, sys.stderr) == before
    assert capsys.readouterr() == ("", "")


def test_an_error_is_said_on_the_screen_too():
    with pytest.raises(ZeroDivisionError), stdio.on_screen():
        raise ZeroDivisionError("division by zero")
    assert "ZeroDivisionError: division by zero" in lines()


def test_lines_are_read_until_ctrl_z():
    conio.clrscr()
    current.screen.monitor.keys.load([b"a", b"\r", b"b", b"\r", b"\x1a", b"\r"])
    with stdio.on_screen():
        assert sys.stdin.read() == "a\nb\n"
        assert (sys.stdin.readable(), sys.stdout.writable()) == (True, True)


def test_words_go_on_where_the_window_is_gone(capsys):
    with stdio.on_screen():
        print("seen")
        current._lost(current.number, bgi.WindowClosed("the window was closed"))
        print("on the terminal")
    assert capsys.readouterr().out == "on the terminal\n"


# Whatever is written


@given(
    text=st.binary(max_size=300), box=st.tuples(*[st.integers(0, 30)] * 4), wscroll=st.booleans()
)
def test_nothing_outside_the_window_changes(text, box, wscroll):
    conio.textmode(conio.C40)
    current.console().teletype(bytes(range(14, 254)) * 4)
    left, top, right, bottom = box
    conio.window(left, top, right, bottom)
    left, top, right, bottom = current.console().window
    before = current.console().cells.array.copy()
    conio._wscroll = int(wscroll)
    try:
        conio.cputs(text)
        conio.insline()
        conio.clreol()
        for code in text[:20]:
            conio.putch(code)
        conio.delline()
    finally:
        conio._wscroll = 1
    after = current.console().cells.array.copy()
    assert left <= current.console().x <= right and top <= current.console().y <= bottom
    after[top : bottom + 1, left : right + 1] = before[top : bottom + 1, left : right + 1]
    assert (after == before).all()


@given(text=st.binary(max_size=100))
def test_a_character_at_a_time_is_the_same_as_all_at_once(text):
    screens = []
    for write in (conio.cputs, lambda codes: [conio.putch(code) for code in codes]):
        conio.textmode(conio.C80)
        conio.window(3, 2, 9, 6)
        write(text)
        screens.append((current.console().cells.array.tolist(), conio.wherex(), conio.wherey()))
    assert screens[0] == screens[1]


@given(text=st.binary(max_size=400))
def test_any_bytes_can_be_printed_over_a_picture(text):
    bgi.initgraph(bgi.CGA, bgi.CGAC0)
    current.console().print(text)
    assert current.console().x <= 39 and current.console().y <= 24
