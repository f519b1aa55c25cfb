"""The house rules: a file imports only from what stands above it, and only pages set pixels."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent

# From the foundation up; entries ending in a dot stand for a package's modules.
LAYERS = [
    "bgi.constants",
    "bgi.errors",
    "bgi.kernel.hints",
    "bgi.kernel.callers",
    "bgi.kernel.arguments",
    "bgi.kernel.modes",
    "bgi.clib.strings",
    "bgi.clib.bits",
    "bgi.clib.reals",
    "bgi.clib.reading",
    "bgi.clib.printf",
    "bgi.clib.",
    "bgi.kernel.textmodes",
    "bgi.raster.arrays",
    "bgi.raster.lines",
    "bgi.raster.offsets",
    "bgi.raster.kept",
    "bgi.raster.brush",
    "bgi.raster.patterns",
    "bgi.raster.shortlines",
    "bgi.raster.styledboxes",
    "bgi.raster.polygons",
    "bgi.raster.regions",
    "bgi.raster.ellipses",
    "bgi.raster.slices",
    "bgi.raster.shapes",
    "bgi.raster.order",
    "bgi.raster.spans",
    "bgi.raster.floodfill",
    "bgi.memory.rgb",
    "bgi.memory.palette",
    "bgi.memory.sdl",
    "bgi.machine",
    "bgi.memory.pngfile",
    "bgi.memory.bmpfile",
    "bgi.memory.withpygame",
    "bgi.memory.withnumpy",
    "bgi.memory.backend",
    "bgi.memory.operators",
    "bgi.memory.boxes",
    "bgi.memory.scrolling",
    "bgi.memory.pixmap",
    "bgi.memory.areas",
    "bgi.memory.strokes",
    "bgi.memory.page",
    "bgi.memory.packedpage",
    "bgi.memory.cells",
    "bgi.memory.matching",
    "bgi.memory.gif",
    "bgi.memory.jpeg",
    "bgi.memory.imagefile",
    "bgi.memory.image",
    "bgi.memory.card",
    "bgi.memory",
    "bgi.fonts.",
    "bgi.settings",
    "bgi.kernel.drivers",
    "bgi.kernel.state",
    "bgi.kernel",
    "bgi.monitor.sdlkeys",
    "bgi.monitor.keycodes",
    "bgi.monitor.keyqueue",
    "bgi.monitor.script",
    "bgi.monitor.timeline",
    "bgi.monitor.moment",
    "bgi.monitor.protocol",
    "bgi.monitor.",
    "bgi.monitor.web.words",
    "bgi.monitor.web.guard",
    "bgi.monitor.web.assets",
    "bgi.monitor.web.webserver",
    "bgi.monitor.web.browserkeys",
    "bgi.monitor.web.pageinputs",
    "bgi.monitor.web.updates",
    "bgi.monitor.web.viewer",
    "bgi.monitor.web.audience",
    "bgi.monitor.web.webchild",
    "bgi.monitor.web.pagewindow",
    "bgi.monitor.web",
    "bgi.monitor.tab",
    "bgi.monitor",
    "bgi.graphics.linestyle",
    "bgi.graphics.screen",
    "bgi.graphics.pen",
    "bgi.graphics.drawing",
    "bgi.graphics.filling",
    "bgi.graphics.curves",
    "bgi.graphics.text",
    "bgi.graphics.images",
    "bgi.graphics",
    "bgi.graphics.slow",
    "bgi.graphics.strict",
    "bgi.console.glyphs",
    "bgi.console.teletype",
    "bgi.console.crt",
    "bgi.console.lineinput",
    "bgi.console",
    "bgi.current",
    "bgi.stdio",
    "bgi.conio.",
    "bgi.conio",
    "bgi.stdlib",
    "bgi.bios",
    "bgi.mouse",
    "bgi.interrupts.registers",
    "bgi.interrupts.",
    "bgi.interrupts.dispatch",
    "bgi.dos",
    "bgi.keyboard",
    "bgi.api.",
    "bgi",
    "bgi.demos",
    "bgi.lab.verdict",
    "bgi.lab.alarm",
    "bgi.lab.supervision",
    "bgi.lab.comparison",
    "bgi.lab.drawn",
    "bgi.lab.signs",
    "bgi.lab.answered",
    "bgi.lab.straight",
    "bgi.lab.ovalsigns",
    "bgi.lab.ovals",
    "bgi.lab.interiors",
    "bgi.lab.floods",
    "bgi.lab.pictured",
    "bgi.lab.lineclips",
    "bgi.lab.polygonclips",
    "bgi.lab.matrices",
    "bgi.lab.windowmaps",
    "bgi.lab.splines",
    "bgi.lab.spaceviews",
    "bgi.lab.showing",
    "bgi.lab.check",
    "bgi.lab.tasks",
    "bgi.lab.confinement",
    "bgi.lab.submission",
    "bgi.lab.grading",
    "bgi.lab.markspage",
    "bgi.lab",
    "bgi.lab.__main__",
    "bgi.turboc.faults",
    "bgi.turboc.explaining",
    "bgi.turboc.words.source",
    "bgi.turboc.words.lexer",
    "bgi.turboc.words.conditions",
    "bgi.turboc.words.preprocess",
    "bgi.turboc.grammar.nodes",
    "bgi.turboc.grammar.tree",
    "bgi.turboc.grammar.literals",
    "bgi.turboc.grammar.stream",
    "bgi.turboc.grammar.expressions",
    "bgi.turboc.grammar.declarations",
    "bgi.turboc.grammar.statements",
    "bgi.turboc.grammar.classes",
    "bgi.turboc.grammar.parser",
    "bgi.turboc.linking",
    "bgi.turboc.checker.types",
    "bgi.turboc.checker.typed",
    "bgi.turboc.checker.scopes",
    "bgi.turboc.checker.folding",
    "bgi.turboc.checker.conversions",
    "bgi.turboc.checker.headers",
    "bgi.turboc.checker.meaning",
    "bgi.turboc.checker.checkliterals",
    "bgi.turboc.checker.checkvalues",
    "bgi.turboc.checker.checkcalls",
    "bgi.turboc.checker.checkactions",
    "bgi.turboc.checker.checking",
    "bgi.turboc.emitter.wrapping",
    "bgi.turboc.emitter.loops",
    "bgi.turboc.emitter.effects",
    "bgi.turboc.emitter.gotos",
    "bgi.turboc.emitter.layouts",
    "bgi.turboc.emitter.emitplaces",
    "bgi.turboc.emitter.emitobjects",
    "bgi.turboc.emitter.emitvalues",
    "bgi.turboc.emitter.emitactions",
    "bgi.turboc.emitter.emit",
    "bgi.turboc.runtime.limits",
    "bgi.turboc.runtime.memory",
    "bgi.turboc.runtime.plaindata",
    "bgi.turboc.runtime.trace",
    "bgi.turboc.runtime.scripted",
    "bgi.turboc.runtime.scriptfile",
    "bgi.turboc.runtime.livepc",
    "bgi.turboc.runtime.folders",
    "bgi.turboc.runtime.timelimit",
    "bgi.turboc.runtime.session",
    "bgi.turboc.runtime.binding",
    "bgi.turboc.runtime.structures",
    "bgi.turboc.runtime.files",
    "bgi.turboc.runtime.farmemory",
    "bgi.turboc.runtime.scriptedints",
    "bgi.turboc.runtime.graphicslib",
    "bgi.turboc.runtime.winlib",
    "bgi.turboc.runtime.pclib",
    "bgi.turboc.runtime.timelib",
    "bgi.turboc.runtime.interruptlib",
    "bgi.turboc.runtime.alloclib",
    "bgi.turboc.runtime.mathlib",
    "bgi.turboc.runtime.stringlib",
    "bgi.turboc.runtime.varargs",
    "bgi.turboc.runtime.stdiolib",
    "bgi.turboc.runtime.filelib",
    "bgi.turboc.runtime.folderlib",
    "bgi.turboc.runtime.manipulators",
    "bgi.turboc.runtime.streambase",
    "bgi.turboc.runtime.streams",
    "bgi.turboc.runtime.filestreams",
    "bgi.turboc.runtime.headertexts",
    "bgi.turboc.runtime.library",
    "bgi.turboc.runtime",
    "bgi.turboc.understanding",
    "bgi.turboc.port.pycode",
    "bgi.turboc.port.origin",
    "bgi.turboc.port.walking",
    "bgi.turboc.port.outs",
    "bgi.turboc.port.pointershapes",
    "bgi.turboc.port.shaping",
    "bgi.turboc.port.singles",
    "bgi.turboc.port.magnitudes",
    "bgi.turboc.port.facts",
    "bgi.turboc.port.switches",
    "bgi.turboc.port.jumps",
    "bgi.turboc.port.ranges",
    "bgi.turboc.port.formats",
    "bgi.turboc.port.portnames",
    "bgi.turboc.port.helpers",
    "bgi.turboc.port.portplaces",
    "bgi.turboc.port.porttests",
    "bgi.turboc.port.portvalues",
    "bgi.turboc.port.portlibrary",
    "bgi.turboc.port.portfiles",
    "bgi.turboc.port.portwords",
    "bgi.turboc.port.portobjects",
    "bgi.turboc.port.portstreams",
    "bgi.turboc.port.portclasses",
    "bgi.turboc.port.porteffects",
    "bgi.turboc.port.portloops",
    "bgi.turboc.port.portactions",
    "bgi.turboc.port.weaving",
    "bgi.turboc.port.portfunctions",
    "bgi.turboc.port.porting",
    "bgi.turboc.port",
    "bgi.turboc.running",
    "bgi.turboc.watching",
    "bgi.turboc.command",
    "bgi.turboc",
    "bgi.__main__",
    "surfaces.beside",
    "surfaces.arrays",
    "surfaces.ticks",
    "surfaces.decades",
    "surfaces.dates",
    "surfaces.checks",
    "surfaces.formulas",
    "surfaces.animation",
    "surfaces.space.transforms",
    "surfaces.space.mapping",
    "surfaces.space.perspective",
    "surfaces.space.projections",
    "surfaces.space.fitting",
    "surfaces.space.view",
    "surfaces.space",
    "surfaces.shape.cells",
    "surfaces.shape.sampling",
    "surfaces.shape.rulers",
    "surfaces.shape.figures",
    "surfaces.shape.rim",
    "surfaces.shape.grid",
    "surfaces.shape.contours",
    "surfaces.shape.fields",
    "surfaces.shape.sheet",
    "surfaces.shape",
    "surfaces.systems.trace",
    "surfaces.systems.pen",
    "surfaces.systems.colors",
    "surfaces.systems.svg",
    "surfaces.systems.characters",
    "surfaces.systems",
    "surfaces.frame",
    "surfaces.visible.lattice",
    "surfaces.visible.order",
    "surfaces.visible.sweep",
    "surfaces.visible.horizon",
    "surfaces.visible.scan",
    "surfaces.visible.depth",
    "surfaces.visible.picking",
    "surfaces.visible.painter",
    "surfaces.visible.marks",
    "surfaces.visible.pictures",
    "surfaces.visible",
    "surfaces.scene",
    "surfaces.look",
    "surfaces.modes",
    "surfaces.bodies",
    "surfaces.plot",
    "surfaces.explorer.",
    "surfaces.command.",
    "surfaces",
]


def modules():
    """Every module of the project: its dotted name and its file."""
    for package in ("bgi", "surfaces"):
        for path in sorted((ROOT / package).rglob("*.py")):
            yield ".".join(path.relative_to(ROOT).with_suffix("").parts), path


def floor(name):
    """The layer a module stands on."""
    name = name.removesuffix(".__init__")
    name = name if name in LAYERS else name.removesuffix(".__main__")
    exact = [i for i, layer in enumerate(LAYERS) if layer == name]
    inside = [
        i for i, layer in enumerate(LAYERS) if f"{name}.".startswith(layer) and layer.endswith(".")
    ]
    assert exact or inside, f"{name} has no place in LAYERS"
    return (exact or inside)[0]


def imports(path):
    """The project's modules that a file imports."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: write absolute imports"
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        else:
            continue
        for name in names:
            found = [m for m, _ in MODULES if name == m or name.startswith(f"{m}.")]
            yield from [max(found, key=len)] if found else []


MODULES = [(name.removesuffix(".__init__"), path) for name, path in modules()]


@pytest.mark.parametrize("layer", LAYERS)
def test_every_layer_is_there(layer):
    assert layer.removesuffix(".") in [name for name, _ in MODULES]


@pytest.mark.parametrize("name, path", MODULES, ids=[name for name, _ in MODULES])
def test_imports_point_up(name, path):
    for imported in imports(path):
        assert floor(imported) <= floor(name), f"{name} may not import {imported}"


def test_every_layer_exists():
    names = [f"{name}." for name, _ in MODULES]
    for layer in LAYERS:
        prefix = layer if layer.endswith(".") else f"{layer}."
        assert any(name.startswith(prefix) for name in names), layer


PROGRAMS = ("surfaces.explorer.", "surfaces.command.", "surfaces.__main__")
"""What opens screens, asks for keys and looks at the mouse, and draws by `surface()`."""


def test_the_plotter_meets_bgi_in_one_file():
    """The plotter knows the BGI through its pen only; the explorer and the command are programs."""
    users = [
        name
        for name, path in MODULES
        if name.startswith("surfaces") and any(i.split(".")[0] == "bgi" for i in imports(path))
    ]
    assert [name for name in users if not name.startswith(PROGRAMS)] == ["surfaces.systems.pen"]


def test_the_plotter_knows_no_program():
    """So it can draw on any system, also where the BGI's screens are not wanted."""
    for name, path in MODULES:
        if name.startswith("surfaces.") and not f"{name}.".startswith(PROGRAMS):
            assert not any(f"{i}.".startswith(PROGRAMS) for i in imports(path)), name


def test_raster_is_pure():
    for name, path in MODULES:
        if name.startswith("bgi.raster"):
            assert not re.search(
                r"pygame|bgi\.(memory|settings|graphics)", path.read_text("utf-8")
            ), name


def test_only_pages_set_pixels():
    """No other drawing module writes into pixel memory."""
    kinds = ["pixmap", "areas", "strokes", "page", "packedpage", "cells", "withpygame", "withnumpy"]
    pages = [f"bgi.memory.{kind}" for kind in kinds]
    for name, path in MODULES:
        if name.startswith("bgi.") and name not in pages:
            text = path.read_text("utf-8")
            assert not re.search(r"\.(flat|array)\[.*\] *[\^|&]?=[^=]", text), name
            assert "pygame.draw" not in text, name


def test_arrays_are_repeated_as_32_bits_allow():
    """Where an address has 32 bits, np.repeat takes no counts of int64: then it must be told."""
    for name, path in MODULES:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and ast.unparse(node.func) == "np.repeat":
                counts = node.args[1]
                known = isinstance(counts, ast.Constant) or "np.intp" in ast.unparse(counts)
                assert known, f"{name}:{node.lineno}: use repeat() of bgi.raster or surfaces.arrays"


@pytest.mark.parametrize("package", ["bgi", "surfaces"])
def test_a_name_of_a_module_or_class_stands_for_one_thing(package):
    """But for the topics: `bgi.api.X` holds the functions whose methods `bgi.graphics.X` holds."""
    topics = {path.stem for name, path in MODULES if name.startswith("bgi.graphics.")}
    stems, classes = [], []
    for name, path in MODULES:
        if name.startswith(f"{package}.") and path.stem not in ("__init__", "__main__"):
            tree = ast.parse(path.read_text(encoding="utf-8"))
            classes += [node.name for node in tree.body if isinstance(node, ast.ClassDef)]
            if not (name.startswith("bgi.api.") and path.stem in topics):
                stems.append(path.stem)
    for names in (stems, classes):
        assert sorted(names) == sorted(set(names))


def test_no_module_is_long():
    for name, path in MODULES:
        assert len(path.read_text(encoding="utf-8").splitlines()) <= 400, name


def test_no_function_is_longer_than_a_screen():
    """Fifty lines, without signature and docstring."""
    for name, path in MODULES:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef):
                body = node.body[1:] if ast.get_docstring(node) else node.body
                lines = node.end_lineno - body[0].lineno + 1 if body else 0
                assert lines <= 50, f"{name}.{node.name}"
