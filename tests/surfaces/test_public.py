"""What `import surfaces` gives: the table of contents."""

import os
import pkgutil
import subprocess
import sys

import pytest

import surfaces


@pytest.mark.parametrize("name", surfaces.__all__)
def test_a_public_name_exists(name: str) -> None:
    assert hasattr(surfaces, name)


def test_none_is_named_twice() -> None:
    assert len(surfaces.__all__) == len(set(surfaces.__all__))


def test_none_hides_a_module() -> None:
    """A function `formula` beside a module `formula` made `import surfaces.formula` a riddle."""
    modules = {module.name for module in pkgutil.iter_modules(surfaces.__path__)}
    assert not modules & set(surfaces.__all__)


def test_what_a_demo_needs_is_public() -> None:
    f = surfaces.formula("x + 2*y")
    assert f(1.0, 2.0) == 5.0
    with pytest.raises(surfaces.FormulaError):
        surfaces.formula("x +")
    assert list(surfaces.FIELDS) == ["z", "slope", "light"]


def test_a_picture_needs_no_module_that_is_slow_to_import() -> None:
    """Each of them took a tenth of the start, for what most programs never do."""
    program = """
import sys, numpy, pygame
before = set(sys.modules)
import bgi, surfaces
bgi.initgraph()
surfaces.surface(lambda x, y: x * y, (-1, 1), (-1, 1))
slow = {"calendar", "difflib", "numpy.ma", "tempfile", "traceback", "urllib.request", "xml.sax"}
print(sorted(slow & set(sys.modules) - before))
"""
    environment = os.environ | {"BGI_MONITOR": "none", "PYGAME_HIDE_SUPPORT_PROMPT": "1"}
    ran = subprocess.run(
        [sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True
    )
    assert ran.stdout == "[]\n"
