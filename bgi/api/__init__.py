"""The façade: the functions of graphics.h and WinBGIm, written out with types and docstrings.

Those of `drawing`, `curves`, `filling`, `text`, `images` and `screen` are one call each: of the
method of the same name, on the current screen (`bgi.current`). `system` opens and closes
screens and asks the kernel's tables, `windows` and `clicks` are what WinBGIm added.

A docstring begins with a sentence for a learner. `Source:` says whose rules a function follows.
"""
