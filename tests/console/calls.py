"""Calls of conio.h as the captures name them."""

import dataclasses

from bgi import conio, stdio


def call(name, *arguments):
    """One call, and its answer as the captures write it."""
    if name == "wherexy":
        return [conio.wherex(), conio.wherey()]
    if name == "_wscroll":
        conio._wscroll = arguments[0]
        return []
    if name == "cprintf":
        return [conio.cprintf(arguments[0])]
    if name == "printf":
        stdio.printf(arguments[0])
        return []
    answer = getattr(conio, name)(*arguments)
    return list(dataclasses.astuple(answer)) if dataclasses.is_dataclass(answer) else answer
