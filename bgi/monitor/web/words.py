"""What a page may say: a line of text, a word and what belongs to it, all of it checked.

======================  ==================================================================
to the program          meaning
======================  ==================================================================
``shown``               the last picture is on the screen: send the next
``down MODS CODE KEY``  a key goes down (and again while it repeats); `CODE` is its place
                        on the keyboard and `KEY` what it means, as in a KeyboardEvent;
                        `MODS` as `bgi.monitor.web.browserkeys` has it
``up MODS CODE``        it comes up
``blur``                whoever types looks elsewhere: all keys are up
``mouse EVENT X Y HELD``  as in `bgi.monitor.protocol`
``wheel CLICKS``        likewise
``board WANTED``        1: this page shows the board from now on, 0: no longer
``type``                this page wants to be the one that types
``close``               the user has closed the program
======================  ==================================================================

To the page go ``title``, ``sound``, ``pointer``, ``shape``, ``move``, ``limits`` and ``lens`` of
`bgi.monitor.protocol`, ``typing`` with ``yes`` or ``no``, and pictures (`bgi.monitor.web.updates`).
"""

import re

LONGEST = 256
"""Bytes that a message may have."""

# Why a connection was closed, for the page to tell its user.
ENDED, LEFT, FULL, REFUSED = 4000, 4001, 4002, 1008

_NUMBER = r"(-?[0-9]{1,4})"
_CODE = r"([A-Za-z0-9]{1,24})"
_KEY = r"([A-Z][A-Za-z0-9]{1,24}|[^\x00-\x1f\x7f])"
_FORMS = {
    word: re.compile(" ".join((word, *fields)))
    for word, *fields in (
        ("shown",),
        ("down", _NUMBER, _CODE, _KEY),
        ("up", _NUMBER, _CODE),
        ("blur",),
        ("mouse", _NUMBER, _NUMBER, _NUMBER, _NUMBER),
        ("wheel", _NUMBER),
        ("board", _NUMBER),
        ("type",),
        ("close",),
    )
}
# What numbers there may be, in their order.
_MODS = range(64)
_EVENTS = (1, 2, 4, 8, 16, 32, 64)
_PLACES = range(4096)
_RANGES: dict[str, tuple[range | tuple[int, ...], ...]] = {
    "down": (_MODS,),
    "up": (_MODS,),
    "mouse": (_EVENTS, _PLACES, _PLACES, range(8)),
    "wheel": (range(-20, 21),),
    "board": (range(2),),
}

Said = tuple[str, list[int], list[str]]
"""A word, its numbers and its texts."""


def understood(message: str | bytes) -> Said:
    """What a page has said; ValueError for what no page of ours would say."""
    if not isinstance(message, str):
        raise ValueError("a page says texts only")
    word = message.partition(" ")[0]
    form = _FORMS.get(word)
    found = form.fullmatch(message) if form else None
    if found is None:
        raise ValueError("no page of ours says that")
    ranges = _RANGES.get(word, ())
    fields = found.groups()
    numbers = [int(field) for field in fields[: len(ranges)]]
    if not all(number in allowed for number, allowed in zip(numbers, ranges, strict=True)):
        raise ValueError("a number is out of its range")
    return word, numbers, list(fields[len(ranges) :])
