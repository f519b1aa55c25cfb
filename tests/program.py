"""What a program can call, and all that it can ask for: for the tests that try every call."""

import inspect
from collections.abc import Callable

import bgi
from bgi import bios, conio, current, dos, keyboard, mouse, stdlib
from bgi.kernel.state import KERNEL

MODULES = bgi, conio, dos, mouse, keyboard, bios
OTHERS = [dos.Sleep, dos.clock, stdlib.srand, stdlib.rand, stdlib.random, stdlib.randomize]
"""What dos.h does not have, and chance; the rest of stdlib.h needs no screen."""

CALLS: list[Callable[..., object]] = [
    *(
        function
        for module in MODULES
        for name in module.__all__
        if inspect.isfunction(function := getattr(module, name))
        and (module is bgi or name not in bgi.__all__)
    ),
    *OTHERS,
]
"""Every public function that draws, asks, waits or computes, once."""


def state() -> tuple[object, ...]:
    """The pictures, and the answers of all calls that ask for something; the error code is last."""
    screen = current.screen
    return (
        [page.array.tobytes() for page in screen.pages],
        screen.card.palette.tobytes(),
        *(bgi.getviewsettings(), bgi.getx(), bgi.gety(), bgi.getcolor(), bgi.getbkcolor()),
        *(bgi.getpalette(), bgi.getfillsettings(), bgi.getfillpattern(), bgi.getlinesettings()),
        *(bgi.gettextsettings(), bgi.textwidth("m"), bgi.textheight("m"), bgi.getarccoords()),
        *(bgi.getaspectratio(), bgi.getactivepage(), bgi.getvisualpage(), bgi.getgraphmode()),
        *(bgi.getcurrentwindow(), mouse.position(), mouse.buttons()),
        *(
            KERNEL.pace.rate,
            KERNEL.pace.stepping,
            KERNEL.result.strict,
            KERNEL.bufsize,
            KERNEL.seed,
            KERNEL.user_scale,
        ),
        *(tuple(KERNEL.fonts._names), tuple(KERNEL.drivers._installed)),
        KERNEL.result._code,
    )
