"""Imported first, for one clear line where a program that is called bgi.py hides the package.

`from bgi import ...` finds that file, and could say no more than that a name is missing in it.
"""

from importlib.util import find_spec

_found = find_spec("bgi")
if _found is not None and _found.submodule_search_locations is None:
    raise ImportError(f"{_found.origin} hides the package bgi: give that file another name")
