"""time.h, the clock of dos.h and bios.h: what a program is told of the time."""

from __future__ import annotations

import calendar
import time as _time
from typing import Any

from bgi import dos
from bgi.turboc.runtime.binding import characters, string
from bgi.turboc.runtime.memory import Pointer, write_text
from bgi.turboc.runtime.scripted import Scripted
from bgi.turboc.runtime.scriptedints import ticks_of_day
from bgi.turboc.runtime.session import Session

TRACED = "void delay(unsigned ms); void sleep(unsigned s); long clock(void);"

OTHERS = """
void Sleep(unsigned ms); void usleep(unsigned long us); void _delay(unsigned ms);
long time(long *to); long biostime(int command, long to); void randomize(void);
void gettime(time *to); void getdate(date *to); void settime(time *to); void setdate(date *to);
void _dos_gettime(dostime_t *to); void _dos_getdate(dosdate_t *to);
unsigned _dos_settime(dostime_t *to); unsigned _dos_setdate(dosdate_t *to);
double difftime(long a, long b); char *ctime(long *seconds); char *asctime(tm *when);
tm *localtime(long *seconds); tm *gmtime(long *seconds); long mktime(tm *when);
unsigned strftime(char *to, unsigned most, text format, tm *when); int stime(long *seconds);
void tzset(void); long dostounix(date *day, time *when); void unixtodos(long s, date *d, time *t);
int _bios_timeofday(int command, long *ticks); char *_strdate(char *to); char *_strtime(char *to);
void ftime(timeb *to);
"""

TYPES = {
    "time": "struct @ { unsigned char ti_min, ti_hour, ti_hund, ti_sec; };",
    "date": "struct @ { int da_year; char da_day, da_mon; };",
    "dostime_t": "struct @ { unsigned char hour, minute, second, hsecond; };",
    "dosdate_t": "struct @ { unsigned char day, month; unsigned year; unsigned char dayofweek; };",
    "tm": """struct @ { int tm_sec, tm_min, tm_hour, tm_mday, tm_mon, tm_year, tm_wday, tm_yday,
        tm_isdst; };""",
    "timeb": "struct @ { long time; int millitm, timezone, dstflag; };",
}

CONSTANTS: dict[str, int | float] = {
    **{"CLK_TCK": 18.2, "CLOCKS_PER_SEC": 18.2, "_TIME_GETCLOCK": 0, "_TIME_SETCLOCK": 1},
}

_DAYS = ["Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"]
_MONTHS = ["Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"]


class TimeLibrary:
    """The functions for one program."""

    def __init__(self, program: Session, tm: Any) -> None:
        self._program, self._pc, self._tm = program, program.pc, tm
        self._answer = Pointer([tm()])
        """The structure that all calls of localtime() share, as in C."""

    def _note(self, name: str, given: tuple[Any, ...] = (), answer: Any = ...) -> None:
        if self._program.trace:
            self._program.trace.call(name, given, answer)

    # Waiting

    def delay(self, milliseconds: int) -> None:
        self._pc.pass_time(milliseconds & 0xFFFF)

    Sleep = _delay = delay

    def sleep(self, seconds: int) -> None:
        self._pc.pass_time((seconds & 0xFFFF) * 1000)

    def usleep(self, microseconds: int) -> None:
        self._pc.pass_time(microseconds // 1000)

    # Seconds and ticks

    def clock(self) -> int:
        return self._pc.milliseconds() * 182 // 10000

    def time(self, to: Any) -> int:
        now = int(self._pc.now())
        self._note("time")
        if to is not None:
            to.memory[to.at] = now
        return now

    def difftime(self, later: int, earlier: int) -> float:
        return float(later - earlier)

    def biostime(self, command: int, to: int) -> int:
        now = self._ticks()
        self._note("biostime", (command,))
        return now

    def _ticks(self) -> int:
        now, when = self._moment()
        second = (when.tm_hour * 60 + when.tm_min) * 60 + when.tm_sec
        return ticks_of_day(second + now % 1)

    def _bios_timeofday(self, command: int, ticks: Pointer) -> int:
        ticks.memory[ticks.at] = self._ticks()
        return 0

    def randomize(self) -> None:
        seed = self._pc.seed()
        if seed >= 0:
            dos.srand(seed & 0xFFFF)

    # The day and its hours

    def _moment(self) -> tuple[float, _time.struct_time]:
        now = self._pc.now()
        return now, self._local(now)

    def _local(self, seconds: float) -> _time.struct_time:
        """The day of a number of seconds: in a script that of Greenwich, everywhere the same."""
        return (_time.gmtime if isinstance(self._pc, Scripted) else _time.localtime)(seconds)

    def _clock_time(self) -> tuple[int, int, int, int]:
        now, when = self._moment()
        return when.tm_hour, when.tm_min, when.tm_sec, round(now % 1 * 1000) // 10

    def gettime(self, to: Pointer) -> None:
        values = hour, minute, second, hundredths = self._clock_time()
        to.memory[to.at].filled(ti_hour=hour, ti_min=minute, ti_sec=second, ti_hund=hundredths)
        self._note("gettime", (), values)

    def _dos_gettime(self, to: Pointer) -> None:
        values = hour, minute, second, hundredths = self._clock_time()
        to.memory[to.at].filled(hour=hour, minute=minute, second=second, hsecond=hundredths)
        self._note("_dos_gettime", (), values)

    def getdate(self, to: Pointer) -> None:
        when = self._moment()[1]
        values = when.tm_year, when.tm_mon, when.tm_mday
        to.memory[to.at].filled(da_year=values[0], da_mon=values[1], da_day=values[2])
        self._note("getdate", (), values)

    def _dos_getdate(self, to: Pointer) -> None:
        when = self._moment()[1]
        year, month, day = when.tm_year, when.tm_mon, when.tm_mday
        weekday = (when.tm_wday + 1) % 7
        to.memory[to.at].filled(day=day, month=month, year=year, dayofweek=weekday)
        self._note("_dos_getdate", (), (year, month, day))

    def settime(self, to: Pointer) -> None:
        """The clock is the whole computer's: it stays."""
        self._note("settime")

    def setdate(self, to: Pointer) -> None:
        """The clock is the whole computer's: it stays."""
        self._note("setdate")

    def _dos_settime(self, to: Pointer) -> int:
        return 0

    _dos_setdate = stime = _dos_settime

    def tzset(self) -> None:
        """The time zone is that of the computer."""

    # Structures of time

    def _store(self, to: Any, when: _time.struct_time) -> None:
        to.filled(tm_sec=when.tm_sec, tm_min=when.tm_min, tm_hour=when.tm_hour)
        to.filled(tm_mday=when.tm_mday, tm_mon=when.tm_mon - 1, tm_year=when.tm_year - 1900)
        to.filled(tm_wday=(when.tm_wday + 1) % 7, tm_yday=when.tm_yday - 1)
        to.filled(tm_isdst=max(when.tm_isdst, 0))

    def localtime(self, seconds: Pointer) -> Pointer:
        self._store(self._answer.memory[0], self._local(seconds.memory[seconds.at]))
        return self._answer

    def gmtime(self, seconds: Pointer) -> Pointer:
        self._store(self._answer.memory[0], _time.gmtime(seconds.memory[seconds.at]))
        return self._answer

    def mktime(self, when: Pointer) -> int:
        one = when.memory[when.at]
        years, month = divmod(one.tm_mon, 12)
        fields = (one.tm_year + 1900 + years, month + 1, one.tm_mday)
        clock = (one.tm_hour, one.tm_min, one.tm_sec)
        if isinstance(self._pc, Scripted):
            seconds = calendar.timegm((*fields, *clock, 0, 0, 0))
        else:
            seconds = int(_time.mktime((*fields, *clock, 0, 0, -1)))
        self._store(one, self._local(seconds))
        return seconds

    def asctime(self, when: Pointer) -> Pointer:
        one = when.memory[when.at]
        day, month = _DAYS[one.tm_wday % 7], _MONTHS[one.tm_mon % 12]
        clock = f"{one.tm_hour:02}:{one.tm_min:02}:{one.tm_sec:02}"
        return string(f"{day} {month} {one.tm_mday:2} {clock} {one.tm_year + 1900}\n")

    def ctime(self, seconds: Pointer) -> Pointer:
        return self.asctime(self.localtime(seconds))

    def strftime(self, to: Pointer, most: int, format: Any, when: Pointer) -> int:
        one = when.memory[when.at]
        fields = (one.tm_year + 1900, one.tm_mon + 1, one.tm_mday, one.tm_hour, one.tm_min)
        day = one.tm_sec, (one.tm_wday - 1) % 7, one.tm_yday + 1, one.tm_isdst
        data = _time.strftime(characters(format).decode("cp437"), (*fields, *day)).encode("cp437")
        if len(data) >= most:
            return 0
        write_text(to, data)
        return len(data)

    def dostounix(self, day: Pointer, when: Pointer) -> int:
        d, t = day.memory[day.at], when.memory[when.at]
        return calendar.timegm((d.da_year, d.da_mon, d.da_day, t.ti_hour, t.ti_min, t.ti_sec))

    def unixtodos(self, seconds: int, day: Pointer, when: Pointer) -> None:
        one = _time.gmtime(seconds)
        day.memory[day.at].filled(da_year=one.tm_year, da_mon=one.tm_mon, da_day=one.tm_mday)
        clock = when.memory[when.at]
        clock.filled(ti_hour=one.tm_hour, ti_min=one.tm_min, ti_sec=one.tm_sec, ti_hund=0)

    def _strdate(self, to: Pointer) -> Pointer:
        write_text(to, _time.strftime("%m/%d/%y", self._moment()[1]).encode())
        return to

    def _strtime(self, to: Pointer) -> Pointer:
        write_text(to, _time.strftime("%H:%M:%S", self._moment()[1]).encode())
        return to

    def ftime(self, to: Pointer) -> None:
        now = self._pc.now()
        to.memory[to.at].filled(time=int(now), millitm=round(now % 1 * 1000))
