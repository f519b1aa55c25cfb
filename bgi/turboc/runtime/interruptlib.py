"""dos.h's way to the machine: interrupts, ports, and memory by segment and offset."""

from __future__ import annotations

import sys
from typing import Any

from bgi import dos
from bgi.interrupts.registers import REGS, SREGS
from bgi.turboc.runtime.farmemory import FarMemory, FarView
from bgi.turboc.runtime.memory import Pointer
from bgi.turboc.runtime.scripted import Scripted
from bgi.turboc.runtime.scriptedints import scripted_interrupt
from bgi.turboc.runtime.session import ProgramEnd, Session

TRACED = """
unsigned char inportb(int port); int inport(int port); void outportb(int port, unsigned char value);
void outport(int port, int value); void poke(unsigned segment, unsigned offset, int value);
void pokeb(unsigned segment, unsigned offset, char value);
void movedata(unsigned s, unsigned o, unsigned to_s, unsigned to_o, unsigned n);
"""

OTHERS = """
int int86(int number, REGS *in, REGS *out); int intdos(REGS *in, REGS *out);
int int86x(int number, REGS *in, REGS *out, SREGS *segments);
int intdosx(REGS *in, REGS *out, SREGS *segments); void intr(int number, REGPACK *registers);
void geninterrupt(int number); int bdos(int function, unsigned dx, unsigned al);
int bdosptr(int function, void *dx, unsigned al); void segread(SREGS *segments);
int peek(unsigned segment, unsigned offset); char peekb(unsigned segment, unsigned offset);
void *MK_FP(unsigned segment, unsigned offset); unsigned FP_SEG(void *p); unsigned FP_OFF(void *p);
int inp(unsigned port); unsigned inpw(unsigned port); int outp(unsigned port, int value);
unsigned outpw(unsigned port, unsigned value); void setvect(int number, void *isr);
void _dos_setvect(int number, void *isr); void *getvect(int number);
void *_dos_getvect(int number); void disable(void); void enable(void);
void _disable(void); void _enable(void); void ctrlbrk(void *handler); int getcbrk(void);
int setcbrk(int on); void keep(unsigned char status, unsigned size); void harderr(void *handler);
void hardresume(int how); void hardretn(int code); void _harderr(void *handler);
void _hardresume(int how); void _hardretn(int code);
void _chain_intr(void *isr); int getverify(void); void setverify(int on);
"""

NAMES = {"_registers": "REGS @", "_segments": "SREGS @"}

MACROS = {
    **{f"_{name}X": f"_registers.x.{name.lower()}x" for name in "ABCD"},
    **{
        f"_{name}{half}": f"_registers.h.{(name + half).lower()}"
        for name in "ABCD"
        for half in "HL"
    },
    **{"_SI": "_registers.x.si", "_DI": "_registers.x.di", "_FLAGS": "_registers.x.flags"},
    **{f"_{name}": f"_segments.{name.lower()}" for name in ("ES", "CS", "SS", "DS")},
}
"""The registers of the processor, by Turbo C's names."""

TYPES = {
    "WORDREGS": "struct @ { unsigned ax, bx, cx, dx, si, di, cflag, flags; };",
    "BYTEREGS": "struct @ { unsigned char al, ah, bl, bh, cl, ch, dl, dh; };",
    "REGS": "struct @ { WORDREGS x; BYTEREGS h; };",
    "SREGS": "struct @ { unsigned es, cs, ss, ds; };",
    "REGPACK": """struct @ { unsigned r_ax, r_bx, r_cx, r_dx, r_bp, r_si, r_di, r_ds, r_es,
        r_flags; };""",
}

_WORDS = ("ax", "bx", "cx", "dx", "si", "di", "cflag", "flags")


class InterruptLibrary:
    """The functions for one program."""

    def __init__(self, program: Session, registers: Any, segments: Any) -> None:
        """
        Args:
            program: the program.
            registers, segments: what its pseudo-registers are.
        """
        self._program, self._pc = program, program.pc
        self._registers, self._segments = registers, segments
        self.far = FarMemory(program.scripted)
        self._told: set[str] = set()

    def _note(self, name: str, given: tuple[Any, ...], answer: Any = ...) -> None:
        if self._program.trace:
            self._program.trace.call(name, given, answer)

    # Interrupts

    def _interrupt(self, number: int, r: REGS, s: SREGS) -> None:
        if isinstance(self._pc, Scripted):
            scripted_interrupt(self._pc, number, r, self._program.print)
            return
        try:
            dos.int86x(number, r, r, s)
        except ValueError as error:
            if str(error) not in self._told:
                self._told.add(str(error))
                print(f"bgi: {error}: the program goes on without it", file=sys.stderr)
        except SystemExit as end:
            raise ProgramEnd("exit", int(end.code or 0)) from None

    def _called(self, number: int, words: Any, prefix: str = "", **segments: Any) -> None:
        """Call an interrupt with the registers that members of an object hold."""
        r = REGS()
        names = [name for name in _WORDS if hasattr(words, prefix + name)]
        for name in names:
            setattr(r.x, name, getattr(words, prefix + name))
        given = [r.x.ax, r.x.bx, r.x.cx, r.x.dx]
        self._interrupt(number & 0xFF, r, SREGS(**segments))
        for name in names:
            setattr(words, prefix + name, getattr(r.x, name))
        self._note("int86", (number, *given), (r.x.ax, r.x.bx, r.x.cx, r.x.dx))

    def _led(self, segment: int, offset: int) -> Any:
        """What an address leads to: a memory of the program, from there on."""
        pointer = self.far.pointer(segment, offset)
        if pointer is None or isinstance(pointer.memory, FarView):
            return None
        return pointer.memory[pointer.at :] if pointer.at else pointer.memory

    def int86(self, number: int, given: Pointer, out: Pointer) -> int:
        after = out.memory[out.at]
        after.assign(given.memory[given.at])
        self._called(number, after.x)
        return int(after.x.ax ^ 0x8000) - 0x8000

    def int86x(self, number: int, given: Pointer, out: Pointer, segments: Pointer) -> int:
        after, where = out.memory[out.at], segments.memory[segments.at]
        after.assign(given.memory[given.at])
        leads = {"es": self._led(where.es, after.x.dx), "ds": self._led(where.ds, after.x.dx)}
        self._called(number, after.x, **leads)
        return int(after.x.ax ^ 0x8000) - 0x8000

    def intdos(self, given: Pointer, out: Pointer) -> int:
        return self.int86(0x21, given, out)

    def intdosx(self, given: Pointer, out: Pointer, segments: Pointer) -> int:
        return self.int86x(0x21, given, out, segments)

    def intr(self, number: int, registers: Pointer) -> None:
        pack = registers.memory[registers.at]
        leads = {"es": self._led(pack.r_es, pack.r_dx), "ds": self._led(pack.r_ds, pack.r_dx)}
        self._called(number, pack, "r_", **leads)

    def geninterrupt(self, number: int) -> None:
        self._called(number, self._registers.x)

    def bdos(self, function: int, dx: int, al: int) -> int:
        words = type(self._registers)().x
        words.ax, words.dx = (function & 0xFF) << 8 | al & 0xFF, dx & 0xFFFF
        self._called(0x21, words)
        return int(words.ax ^ 0x8000) - 0x8000

    def bdosptr(self, function: int, dx: Pointer, al: int) -> int:
        return self.bdos(function, dx.at, al)

    def segread(self, segments: Pointer) -> None:
        segments.memory[segments.at].filled(es=0, cs=0x1000, ss=0x2000, ds=0x2000)

    # Ports

    def inportb(self, port: int) -> int:
        return self._pc.port(port & 0xFFFF)

    def inport(self, port: int) -> int:
        return 0

    def outportb(self, port: int, value: int) -> None:
        """Nothing hears it."""

    outport = outportb

    def inp(self, port: int) -> int:
        value = self.inportb(port)
        self._note("inportb", (port,), value)
        return value

    def inpw(self, port: int) -> int:
        self._note("inport", (port,), 0)
        return 0

    def outp(self, port: int, value: int) -> int:
        self._note("outportb", (port, value & 0xFF))
        return value

    def outpw(self, port: int, value: int) -> int:
        self._note("outport", (port, value))
        return value

    # Memory

    def peekb(self, segment: int, offset: int) -> int:
        return (self.far.segment(segment).get(offset) ^ 0x80) - 0x80

    def peek(self, segment: int, offset: int) -> int:
        where = self.far.segment(segment)
        return ((where.get(offset) | where.get(offset + 1) << 8) ^ 0x8000) - 0x8000

    def pokeb(self, segment: int, offset: int, value: int) -> None:
        self.far.segment(segment).put(offset, value)

    def poke(self, segment: int, offset: int, value: int) -> None:
        self.pokeb(segment, offset, value)
        self.pokeb(segment, offset + 1, value >> 8)

    def movedata(self, segment: int, offset: int, to_segment: int, to: int, n: int) -> None:
        source, target = self.far.pointer(segment, offset), self.far.pointer(to_segment, to)
        for place in range(n if source is not None and target is not None else 0):
            target.memory[target.at + place] = source.memory[source.at + place] & 0xFF  # type: ignore[union-attr]

    def MK_FP(self, segment: int, offset: int) -> Pointer | None:
        return self.far.pointer(segment, offset)

    def FP_SEG(self, pointer: Pointer | None) -> int:
        return self.far.address(pointer)[0]

    def FP_OFF(self, pointer: Pointer | None) -> int:
        return self.far.address(pointer)[1]

    def far_pointer(self, number: int) -> Pointer | None:
        """A number that the program takes for a pointer: segment and offset."""
        return self.far.pointer(number >> 16, number)

    # Vectors: no interrupt of the hardware comes

    def getvect(self, number: int) -> Any:
        self._note("getvect", (number,))
        return lambda *given: 0

    _dos_getvect = getvect

    def setvect(self, number: int, handler: Any) -> None:
        """It is never called."""
        self._note("setvect", (number,))

    _dos_setvect = setvect

    def disable(self) -> None:
        """There are none."""

    enable = _disable = _enable = disable

    def ctrlbrk(self, handler: Any) -> None:
        """Ctrl-Break ends the program."""

    harderr = hardresume = hardretn = _chain_intr = setverify = ctrlbrk
    _harderr = _hardresume = _hardretn = ctrlbrk

    def getcbrk(self) -> int:
        return 0

    getverify = getcbrk

    def setcbrk(self, on: int) -> int:
        return on

    def keep(self, status: int, size: int) -> None:
        raise ProgramEnd("exit", status & 0xFF)
