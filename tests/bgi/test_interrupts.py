"""Interrupts on the registers of dos.h: what int86() answers, and what it leaves on the screen."""

import copy
import itertools
import threading
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import bgi
from bgi import conio, current, dos, mouse
from bgi.dos import REGPACK, REGS, SREGS, int86, int86x, intdos, intr
from bgi.fonts import rom
from bgi.interrupts import int10h, int33h
from bgi.interrupts.dispatch import INTERRUPTS
from bgi.memory.card import BLINKING, BRIGHT, NO_CURSOR
from bgi.memory.rgb import ega_rgb
from bgi.monitor.pointer import MOVED, pressed

VIDEO, KEYBOARD, CLOCK, DOS, MOUSE = 0x10, 0x16, 0x1A, 0x21, 0x33


def registers(**values: int) -> REGS:
    """Registers by name: `registers(ah=2, dx=5)`."""
    r = REGS()
    for name, value in values.items():
        setattr(r.x if hasattr(r.x, name) else r.h, name, value)
    return r


def video(ah: int, **values: int) -> REGS:
    r = registers(ah=ah, **values)
    int86(VIDEO, r)
    return r


def driver(ax: int, **values: int) -> REGS:
    r = registers(ax=ax, **values)
    int86(MOUSE, r)
    return r


def type_keys(monkeypatch: pytest.MonkeyPatch, script: str) -> None:
    monkeypatch.setenv("BGI_KEYS", script)
    conio.textmode(conio.C80)


def row(number: int) -> str:
    """What stands in a row of the screen, without blanks at its end."""
    return conio.gettext(1, number + 1, 80, number + 1)[::2].decode("cp437").rstrip()


class TestRegisters:
    def test_both_views_are_the_same_registers(self) -> None:
        r = REGS()
        r.x.ax = 0x1234
        assert (r.h.ah, r.h.al) == (0x12, 0x34)
        r.h.ah, r.h.al = 0xAB, 0xCD
        assert r.x.ax == 0xABCD
        for word, high, low in (("bx", "bh", "bl"), ("cx", "ch", "cl"), ("dx", "dh", "dl")):
            setattr(r.h, high, 7)
            setattr(r.h, low, 8)
            assert getattr(r.x, word) == 0x0708

    def test_what_is_too_large_loses_its_upper_bits(self) -> None:
        r = registers(ax=0x12345, bx=-1, cl=0x1FF, si=3.9)
        assert (r.x.ax, r.x.bx, r.x.cx, r.x.si) == (0x2345, 0xFFFF, 0xFF, 3)
        with pytest.raises(TypeError, match="ah must be a number, not str"):
            r.h.ah = "A"
        with pytest.raises(AttributeError):
            r.x.ah = 1  # type: ignore[attr-defined]

    def test_a_copy_is_a_copy(self) -> None:
        first = registers(ax=1)
        second = copy.copy(first)
        second.x.ax = 2
        assert (first.x.ax, second.x.ax) == (1, 2)
        assert repr(second).startswith("REGS(ax=0002h, bx=0000h,")


class TestCalls:
    def test_the_answer_goes_into_the_second_registers(self) -> None:
        asked, answer = registers(ah=0x0F), REGS()
        assert int86(VIDEO, asked, answer) == answer.x.ax == 80 << 8 | conio.C80
        assert asked.x.ax == 0x0F00
        assert int86(VIDEO, asked) == asked.x.ax == answer.x.ax

    def test_intr_has_one_structure(self) -> None:
        pack = REGPACK(r_ax=0x0F00, r_si=5)
        intr(VIDEO, pack)
        assert (pack.r_ax, pack.r_bx, pack.r_si) == (80 << 8 | conio.C80, 0, 5)

    @pytest.mark.parametrize("number", [0, 0x11, -1, 10**30])
    def test_an_interrupt_that_is_not_there(self, number: int) -> None:
        with pytest.raises(ValueError, match="is not there, only 10h, 16h, 1Ah, 21h, 33h"):
            int86(number, REGS())

    @pytest.mark.parametrize(
        ("number", "values", "message"),
        [
            (VIDEO, {"ah": 0x55}, "interrupt 10h has no function 55h here, only 00h, 01h"),
            (VIDEO, {"ax": 0x1099}, "10h of interrupt 10h takes in AL only .* not 99h"),
            (VIDEO, {"ax": 0x0063}, "no video mode 63h"),
            (MOUSE, {"ax": 0x1234}, "interrupt 33h has no function 1234h"),
            (DOS, {"ah": 0x3D}, "interrupt 21h has no function 3Dh"),
        ],
    )
    def test_a_function_that_is_not_there(
        self, number: int, values: dict[str, int], message: str
    ) -> None:
        with pytest.raises(ValueError, match=message):
            int86(number, registers(**values))

    @settings(deadline=None, max_examples=300)
    @given(
        st.lists(
            st.tuples(
                st.sampled_from([(n, f) for n, found in INTERRUPTS.items() for f in found[1]]),
                st.lists(st.integers(0, 0xFFFF), min_size=6, max_size=6),
            ),
            max_size=8,
        )
    )
    def test_no_registers_do_harm(self, calls: list[tuple[tuple[int, int], list[int]]]) -> None:
        """Whatever the registers hold, a call answers, or says what is wrong."""
        for (number, function), values in calls:
            r = registers(**dict(zip(("ax", "bx", "cx", "dx", "si", "di"), values, strict=True)))
            if number == MOUSE:
                r.x.ax = function
            else:
                r.h.ah = function
            try:
                int86(number, r)
            except (ValueError, bgi.NobodyThere, SystemExit) as error:
                assert str(error)
            conio.cputs("still writing\r\n")
            current.console().print(b"and here\n")


class TestModes:
    @pytest.mark.parametrize("number", [0, 1, 2, 3, 7])
    def test_text(self, number: int) -> None:
        bgi.initgraph()
        video(0, al=number)
        assert conio.gettextinfo().currmode == number
        assert current.console().is_text
        r = video(0x0F)
        assert (r.h.al, r.h.ah, r.h.bh) == (number, 40 if number < 2 else 80, 0)
        with pytest.raises(bgi.BGIError, match="Not in graphics mode"):
            bgi.line(0, 0, 1, 1)

    @pytest.mark.parametrize(
        ("number", "width", "height", "colors"),
        [
            (0x04, 320, 200, 4),
            (0x06, 640, 200, 2),
            (0x0D, 320, 200, 16),
            (0x0E, 640, 200, 16),
            (0x0F, 640, 350, 2),
            (0x10, 640, 350, 16),
            (0x11, 640, 480, 2),
            (0x12, 640, 480, 16),
            (0x13, 320, 200, 256),
        ],
    )
    def test_graphics(self, number: int, width: int, height: int, colors: int) -> None:
        video(0, al=number | 0x80)
        size = bgi.getmaxx() + 1, bgi.getmaxy() + 1, bgi.getmaxcolor() + 1
        assert size == (width, height, colors)
        r = video(0x0F)
        assert (r.h.al, r.h.ah) == (number, width // 8)

    def test_the_bios_knows_no_mode_of_others(self) -> None:
        bgi.initgraph(bgi.HERCMONO, bgi.HERCMONOHI)
        assert video(0x0F).h.al == 3
        conio.textmode(conio.C4350)
        assert video(0x0F).h.al == 3

    def test_the_adapter_is_a_vga(self) -> None:
        assert video(0x1A).x.ax & 0xFF == 0x1A
        assert video(0x12, bl=0x10).x.bx == 3

    def test_a_page_of_a_picture_is_shown(self) -> None:
        bgi.initgraph(bgi.VGA, bgi.VGAMED)
        for page, shown in ((1, 1), (200, 1), (0, 0)):
            video(5, al=page)
            assert bgi.getvisualpage() == shown


class TestCursor:
    def test_it_moves_and_is_found(self) -> None:
        video(2, dh=5, dl=7)
        assert (conio.wherex(), conio.wherey()) == (8, 6)
        r = video(3)
        assert (r.h.dh, r.h.dl) == (5, 7)

    def test_outside_the_screen_it_is_hidden_and_text_goes_on(self) -> None:
        video(2, dh=25, dl=0)
        assert current.console().card.cursor[0] == NO_CURSOR
        conio.cputs("x")
        assert row(24) == "x"

    @pytest.mark.parametrize(
        ("asked", "shape"),
        [(0x0607, 0x0D0E), (0x0007, 0x000F), (0x0D0E, 0x0D0E), (0x2000, 0x2000), (0x0407, 0x080F)],
    )
    def test_its_shape(self, asked: int, shape: int) -> None:
        video(1, cx=asked)
        assert video(3).x.cx == shape


class TestCharacters:
    def test_a_row_of_one_character(self) -> None:
        video(2, dh=1, dl=78)
        video(9, al=ord("*"), bl=0x1E, cx=4)
        cells = current.console().cells.array
        assert [hex(cell) for cell in cells.ravel()[158:163]] == ["0x1e2a"] * 4 + ["0x720"]
        r = video(3)
        assert (r.h.dh, r.h.dl) == (1, 78)
        video(0x0A, al=ord("+"), bl=0x44, cx=1)
        assert video(8).x.ax == 0x1E2B

    @pytest.mark.parametrize(("function", "rows"), [(6, "cde"), (7, " ab")])
    def test_a_box_scrolls(self, function: int, rows: str) -> None:
        for y, letter in enumerate("abcde"):
            video(2, dh=y, dl=10)
            video(9, al=ord(letter), bl=7, cx=2)
        video(function, al=1 if function == 7 else 2, bh=0x17, ch=0, cl=10, dh=4, dl=10)
        cells = current.console().cells.array
        assert bytes(cells[:3, 10].astype("u1")).decode() == rows
        assert bytes(cells[:5, 11].astype("u1")).decode() == "abcde"
        assert cells[4 if function == 6 else 0, 10] == 0x1720

    def test_no_lines_are_all_of_them(self) -> None:
        conio.cputs("words")
        video(6, al=0, bh=0x07, cx=0, dh=200, dl=200)
        assert (current.console().cells.array == 0x0720).all()

    def test_teletype(self) -> None:
        for letter in b"ab\r\nc":
            video(0x0E, al=letter)
        assert (row(0), row(1)) == ("ab", "c")

    def test_over_a_picture_in_colour(self) -> None:
        bgi.initgraph(bgi.VGA, bgi.VGAHI)
        video(2, dh=2, dl=3)
        video(9, al=ord("A"), bl=bgi.YELLOW, cx=2)
        picture = current.screen.page.array
        letter = rom.glyphs(16)[ord("A")]
        for x in (24, 32):
            assert (picture[32:48, x : x + 8] == letter * bgi.YELLOW).all()
        assert video(8).h.al == ord("A")
        video(9, al=ord("A"), bl=bgi.YELLOW | 0x80, cx=1000)
        assert not picture[32:48, :40].any()  # by XOR it has gone again
        assert (picture[32:48, 40:] == np.tile(letter, 75) * bgi.YELLOW).all()
        assert video(8).h.al == 0
        video(0x0E, al=ord("A"), bl=bgi.RED)
        assert (picture[32:48, 24:32] == letter * bgi.RED).all()

    def test_in_256_colours_no_bit_is_for_xor(self) -> None:
        video(0, al=0x13)
        for _ in range(2):
            video(9, al=ord("█"[0].encode("cp437")), bl=0xC5, cx=1)
        assert (current.screen.page.array[:8, :8] == 0xC5).all()


class TestPixels:
    def test_they_are_set_wherever_the_viewport_is(self) -> None:
        bgi.initgraph(bgi.VGA, bgi.VGAHI)
        bgi.setviewport(100, 100, 200, 200, 1)
        video(0x0C, al=5, cx=639, dx=479)
        assert video(0x0D, cx=639, dx=479).h.al == 5
        video(0x0C, al=0x83, cx=639, dx=479)
        assert video(0x0D, cx=639, dx=479).h.al == 6
        video(0x0C, al=5, cx=640, dx=0xFFFF)
        assert np.count_nonzero(current.screen.page.array) == 1
        assert video(0x0D, cx=640, dx=0, al=9).h.al == 0

    def test_in_256_colours_no_bit_is_for_xor(self) -> None:
        video(0, al=0x13)
        for _ in range(2):
            video(0x0C, al=0xFE, cx=3, dx=4)
        assert bgi.getpixel(3, 4) == 0xFE

    def test_text_has_none(self) -> None:
        video(0x0C, al=5, cx=1, dx=1)
        assert video(0x0D, al=9, cx=1, dx=1).h.al == 0


class TestPalette:
    @pytest.mark.parametrize("mode", [0x03, 0x12])
    def test_an_index_takes_another_value(self, mode: int) -> None:
        video(0, al=mode)
        video(0x10, al=0, bl=1, bh=0x26)
        card = current.console().card
        assert tuple(card.palette[1]) == ega_rgb(0x26)
        assert video(0x10, al=7, bl=1).h.bh == 0x26
        assert video(0x10, al=7, bl=200).h.bh == 0
        video(0x10, al=0, bl=99, bh=1)
        video(0x10, al=1, bh=5)
        assert tuple(card.palette[2]) == ega_rgb(2)
        video(0, al=mode)
        assert tuple(card.palette[1]) == ega_rgb(1)

    @pytest.mark.parametrize(("mode", "register"), [(0x03, 20), (0x12, 20), (0x13, 6)])
    def test_registers_of_the_dac(self, mode: int, register: int) -> None:
        video(0, al=mode)
        video(0x10, al=0x10, bx=register, dh=63, ch=0, cl=32)
        assert tuple(current.console().card.palette[6]) == (255, 0, 130)
        r = video(0x10, al=0x15, bx=register)
        assert (r.h.dh, r.h.ch, r.h.cl) == (63, 0, 32)

    def test_blocks(self) -> None:
        video(0, al=0x13)
        colors = [63, 0, 0, 0, 63, 0]
        int86x(VIDEO, registers(ax=0x1012, bx=100, cx=2), None, SREGS(es=colors))
        assert current.screen.card.palette[100:102].tolist() == [[255, 0, 0], [0, 255, 0]]
        found = bytearray(7)
        int86x(VIDEO, registers(ax=0x1017, bx=100, cx=2), None, SREGS(es=found))
        assert found == bytes([*colors, 0])
        video(0, al=0x12)
        int86x(VIDEO, registers(ax=0x1002), None, SREGS(es=bytes(range(32, 49))))
        assert bgi.getpalette().colors == list(range(32, 48))

    @pytest.mark.parametrize("given", [None, [1, 2], "abcdef", 5])
    @pytest.mark.parametrize("al", [2, 0x12, 0x17])
    def test_blocks_that_are_none(self, al: int, given: object) -> None:
        with pytest.raises((ValueError, TypeError), match="es must"):
            int86x(VIDEO, registers(ah=0x10, al=al, cx=2), None, SREGS(es=given))

    def test_blinking_or_bright(self) -> None:
        video(0x10, al=3, bl=0)
        card = current.console().card
        assert card.attributes == BRIGHT
        video(0x10, al=3, bl=1)
        assert card.attributes == BLINKING

    def test_the_background_of_a_picture(self) -> None:
        bgi.initgraph(bgi.CGA, bgi.CGAC1)
        video(0x0B, bh=0, bl=bgi.BLUE)
        assert bgi.getbkcolor() == bgi.BLUE


class TestKeyboard:
    def test_keys(self, monkeypatch: pytest.MonkeyPatch) -> None:
        type_keys(monkeypatch, "a Up")
        for look in (1, 0x11):
            r = registers(ah=look)
            assert int86(KEYBOARD, r) == 0x1E61
            assert not r.x.flags & 0x40
        assert int86(KEYBOARD, registers(ah=0)) == 0x1E61
        assert int86(KEYBOARD, registers(ah=0x10)) == 0x4800
        r = registers(ah=1)
        assert int86(KEYBOARD, r) == 0
        assert r.x.flags & 0x40

    def test_what_is_held(self, monkeypatch: pytest.MonkeyPatch) -> None:
        type_keys(monkeypatch, "+Ctrl a")
        conio.getch()
        assert int86(KEYBOARD, registers(ax=0x0200)) == 0x0204


def scripted_noon(monkeypatch: pytest.MonkeyPatch) -> None:
    """The clock stands at noon of 1 January 1992, a Wednesday."""
    type_keys(monkeypatch, "a")


class TestClock:
    def test_ticks(self, monkeypatch: pytest.MonkeyPatch) -> None:
        scripted_noon(monkeypatch)
        r = registers(ax=0x0055)
        int86(CLOCK, r)
        assert (r.x.cx << 16 | r.x.dx) == int(12 * 3600 * 18.2)
        assert r.h.al == 0

    def test_in_decimal_digits(self, monkeypatch: pytest.MonkeyPatch) -> None:
        scripted_noon(monkeypatch)
        dos.delay(59_000)
        r = registers(ah=2)
        int86(CLOCK, r)
        assert (r.x.cx, r.h.dh, r.x.cflag) == (0x1200, 0x59, 0)
        r = registers(ah=4)
        int86(CLOCK, r)
        assert (r.x.cx, r.x.dx) == (0x1992, 0x0101)

    def test_by_dos(self, monkeypatch: pytest.MonkeyPatch) -> None:
        scripted_noon(monkeypatch)
        dos.delay(1_250)
        r = registers(ah=0x2A)
        assert intdos(r) & 0xFF == 3
        assert (r.x.cx, r.h.dh, r.h.dl) == (1992, 1, 1)
        r = registers(ah=0x2C)
        intdos(r)
        assert (r.h.ch, r.h.cl, r.h.dh, r.h.dl) == (12, 0, 1, 25)


class TestDos:
    def test_keys_one_by_one(self, monkeypatch: pytest.MonkeyPatch) -> None:
        type_keys(monkeypatch, "a b Up c d")
        found = [intdos(registers(ah=ah)) & 0xFF for ah in (0x01, 0x08, 0x07, 0x07)]
        assert bytes(found) == b"ab\0H"
        assert row(0) == "a"
        assert intdos(registers(ah=0x0B)) & 0xFF == 0xFF
        r = registers(ah=6, dl=0xFF)
        assert (intdos(r) & 0xFF, r.x.flags & 0x40) == (ord("c"), 0)
        intdos(registers(ax=0x0C06, dl=0xFF))
        assert intdos(registers(ah=0x0B)) & 0xFF == 0
        r = registers(ah=6, dl=0xFF)
        assert (intdos(r) & 0xFF, r.x.flags & 0x40) == (0, 0x40)

    @pytest.mark.parametrize("ah", [1, 8])
    def test_ctrl_c_stops_the_program(self, monkeypatch: pytest.MonkeyPatch, ah: int) -> None:
        type_keys(monkeypatch, "a \x03")
        conio.getch()
        with pytest.raises(KeyboardInterrupt):
            intdos(registers(ah=ah))

    def test_characters(self) -> None:
        for letter in b"A\tB\nC\r":
            assert intdos(registers(ah=2, dl=letter)) & 0xFF == letter
        intdos(registers(ah=6, dl=ord("D")))
        assert (row(0), row(1)) == ("A       B", "D        C")

    @pytest.mark.parametrize("text", ["Hello$, you", b"Hello$", bytearray(b"Hello")])
    def test_a_text(self, text: object) -> None:
        dos.intdosx(registers(ah=9), None, SREGS(ds=text))
        assert row(0) == "Hello"
        with pytest.raises(ValueError, match="ds must lead to a text, not to None"):
            intdos(registers(ah=9))

    def test_a_line_that_is_typed(self, monkeypatch: pytest.MonkeyPatch) -> None:
        type_keys(monkeypatch, "a b c d Backspace x Enter")
        buffer = bytearray([4]) + bytearray(6)
        dos.intdosx(registers(ah=0x0A), None, SREGS(ds=buffer))
        assert buffer == bytes([4, 3]) + b"abx\r\0"
        assert row(0) == "abx"
        for lacking in (None, b"\4\0\0\0\0\0", bytearray([9, 0])):
            with pytest.raises(ValueError, match="ds must lead to a bytearray"):
                dos.intdosx(registers(ah=0x0A), None, SREGS(ds=lacking))

    def test_the_end(self) -> None:
        for ax, status in ((0x4C03, 3), (0x0003, 0)):
            with pytest.raises(SystemExit) as end:
                intdos(registers(ax=ax))
            assert end.value.code == status
        assert intdos(registers(ah=0x30)) == 5


def hear(event: int, x: int, y: int, buttons: int = 0) -> None:
    """The monitor reports an event."""
    current.screen.monitor.mouse.hear(event, x, y, buttons)


class TestMouse:
    def test_there_is_one(self) -> None:
        r = driver(0)
        assert (r.x.ax, r.x.bx) == (0xFFFF, 3)
        assert current.console().is_text

    @pytest.mark.parametrize(
        ("mode", "pixel", "said"),
        [
            (0x12, (321, 77), (321, 77)),
            (0x10, (639, 349), (639, 349)),
            (0x13, (319, 199), (638, 199)),
            (0x04, (10, 20), (20, 20)),
            (0x03, (83, 33), (80, 16)),  # column 10, row 2
            (0x01, (83, 33), (160, 16)),
        ],
    )
    def test_places_are_those_of_the_driver(
        self, mode: int, pixel: tuple[int, int], said: tuple[int, int]
    ) -> None:
        video(0, al=mode)
        driver(0)
        hear(pressed(0), *pixel, 1)
        r = driver(3)
        assert (r.x.bx, r.x.cx, r.x.dx) == (1, *said)
        r = driver(5, bx=0)
        assert (r.x.ax, r.x.bx, r.x.cx, r.x.dx) == (1, 1, *said)
        driver(4, cx=said[0], dx=said[1])
        r = driver(3)
        assert (r.x.cx, r.x.dx) == said
        assert driver(6, bx=0).x.bx == 0

    def test_text_of_eight_rows(self) -> None:
        conio.textmode(conio.C4350)
        hear(MOVED, 83, 33)
        r = driver(3)
        assert (r.x.cx, r.x.dx) == (80, 32)

    def test_ranges(self) -> None:
        video(0, al=0x13)
        driver(7, cx=100, dx=200)
        driver(8, cx=0xFFFF, dx=50)  # from -1 on
        driver(4, cx=0xFFF0, dx=199)
        assert mouse.position() == (50, 50)
        driver(4, cx=638, dx=0x8000)
        assert mouse.position() == (100, 0)

    def test_show_hide_and_what_has_no_effect(self) -> None:
        for ax in (1, 2, 0x0A, 0x0F):
            driver(ax, bx=1, cx=2, dx=3)

    def test_motion(self) -> None:
        video(0, al=0x12)
        driver(0)
        hear(MOVED, 310, 245)
        r = driver(0x0B)
        assert (r.x.cx, r.x.dx) == (0x10000 - 10, 10)

    def test_the_look_of_the_pointer(self, monkeypatch: pytest.MonkeyPatch) -> None:
        told: list[tuple[object, ...]] = []
        driver(0)
        monkeypatch.setattr(current.screen.monitor.mouse, "_tell", lambda *word: told.append(word))
        rows = [0xFFFF] * 16 + [0x0180] * 16
        int86x(MOUSE, registers(ax=9, bx=0xFFFF, cx=8), None, SREGS(es=rows))
        assert told == [("shape", -1, 8, *rows)]
        with pytest.raises(ValueError, match="es must lead to 32 numbers"):
            driver(9)

    def test_a_handler(self) -> None:
        video(0, al=0x13)
        driver(0)
        calls, done = [], threading.Event()

        def handler(*event: int) -> None:
            calls.append(event)
            done.set()

        int86x(MOUSE, registers(ax=0x0C, cx=2), None, SREGS(es=handler))
        hear(MOVED, 1, 1)
        hear(pressed(0), 30, 40, 1)
        assert done.wait(10)
        assert calls == [(2, 1, 60, 40)]
        driver(0x0C, cx=0)
        assert current.screen.monitor.mouse.handlers == {}

    def test_a_button_that_no_mouse_has(self) -> None:
        with pytest.raises(ValueError, match="button must be 0"):
            driver(5, bx=3)


def test_steps_are_whole_cells() -> None:
    step = int33h.Step(8, 16)
    assert [step.to_units(pixel) for pixel in (0, 15, 16, 399)] == [0, 0, 8, 192]
    assert [step.to_pixels(unit) for unit in (0, 7, 8, -1)] == [0, 0, 16, -16]


@pytest.mark.parametrize("functions", [found for _, found in INTERRUPTS.values()])
def test_every_function_says_what_it_does(functions: dict[int, Callable[..., object]]) -> None:
    for function in itertools.chain(functions.values(), int10h.PALETTE.values()):
        assert function.__doc__
