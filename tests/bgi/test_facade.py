"""The façade: written out, documented, and one with class Graphics."""

import ast
import inspect
from contextlib import suppress
from importlib import import_module
from pathlib import Path

import pytest

import bgi
from bgi import api, constants
from bgi.graphics import Graphics

API = Path(api.__file__).parent


def functions(path):
    """The public functions of a module; graphics.h has two whose names begin with a line."""
    return {
        node.name
        for node in ast.parse(path.read_text(encoding="utf-8")).body
        if isinstance(node, ast.FunctionDef)
        and (not node.name.startswith("_") or node.name.startswith("_graph"))
    }


FUNCTIONS = set().union(*map(functions, API.glob("*.py")))
TEXT_MODES = {"LASTMODE", "BW40", "C40", "BW80", "C80", "MONO", "C4350"}
"""Constants of conio.h: `bgi.conio` has them."""
DRAWING = sorted(FUNCTIONS & set(dir(Graphics)))


@pytest.mark.parametrize("path", [p for p in API.glob("*.py") if p.stem != "__init__"], ids=str)
def test_every_topic_has_a_table_of_contents(path):
    assert sorted(import_module(f"bgi.api.{path.stem}").__all__) == sorted(functions(path))


def test_everything_is_exported():
    """`bgi.__all__` is written out, for mypy; so nothing may be missing there."""
    constants_of_graphics = {n for n in vars(constants) if not n.startswith("_")} - TEXT_MODES
    assert set(bgi.__all__) >= FUNCTIONS | constants_of_graphics
    assert all(hasattr(bgi, name) for name in bgi.__all__)
    assert len(bgi.__all__) == len(set(bgi.__all__))


def test_star_import_shadows_nothing_of_python():
    import builtins

    assert not set(bgi.__all__) & set(dir(builtins))


@pytest.mark.parametrize("name", DRAWING)
def test_same_signature_as_the_method(name):
    function = inspect.signature(getattr(bgi, name), eval_str=True)
    method = inspect.signature(getattr(Graphics, name), eval_str=True)
    itself, *parameters = method.parameters.values()
    assert itself.name == "self"
    assert list(function.parameters.values()) == parameters
    assert function.return_annotation == method.return_annotation


@pytest.mark.parametrize("name", DRAWING)
def test_function_and_method_stand_in_modules_of_the_same_name(name):
    function, method = getattr(bgi, name), getattr(Graphics, name)
    assert method.__module__ == function.__module__.replace("bgi.api.", "bgi.graphics.")


def test_a_screen_has_all_its_attributes_from_the_beginning(vga):
    before = set(vars(vga))
    for name in DRAWING:
        with suppress(OSError):
            getattr(vga, name)(*CALLS[name])
    assert set(vars(vga)) == before


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_docstring_tells_a_learner(name):
    text = inspect.getdoc(getattr(bgi, name))
    first = text.split("\n\n")[0].replace("\n", " ")
    assert first.endswith("."), first
    assert "Source:" in inspect.getmodule(getattr(bgi, name)).__doc__
    for parameter in inspect.signature(getattr(bgi, name)).parameters:
        assert parameter in text, f"{name} does not explain {parameter}"


CALLS = {
    name: [1]
    * len(
        [
            p
            for p in inspect.signature(getattr(bgi, name)).parameters.values()
            if p.default is p.empty
        ]
    )
    for name in DRAWING
}
CALLS |= {
    "outtext": ["a"],
    "outtextxy": [1, 1, "a"],
    "textwidth": ["a"],
    "textheight": ["a"],
    "drawpoly": [[(1, 1), (2, 2)]],
    "fillpoly": [[(1, 1), (2, 2)]],
    "setallpalette": [[1, 2]],
    "setfillpattern": [bytes(8), 1],
    "putimage": [1, 1, bytes(100), 0],
    "readimagefile": ["/nonexistent/x.png"],
    "writeimagefile": ["/nonexistent/x.png"],
}


@pytest.mark.parametrize("name", [*DRAWING, "setgraphmode", "restorecrtmode"])
def test_before_initgraph_and_after_closegraph(name):
    arguments = CALLS.get(name, [0] if name == "setgraphmode" else [])
    with pytest.raises(bgi.BGIError, match=r"Graphics not initialized \(use 'initgraph'\)"):
        getattr(bgi, name)(*arguments)
    bgi.initgraph()
    bgi.closegraph()
    with pytest.raises(bgi.BGIError, match="Graphics not initialized"):
        getattr(bgi, name)(*arguments)
