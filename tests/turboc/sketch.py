"""Trees written short, for tests: `(= x (+ 1 y))`."""

from dataclasses import fields

from bgi.turboc.grammar import nodes
from bgi.turboc.grammar import tree as trees
from bgi.turboc.grammar.parser import parse
from bgi.turboc.words.preprocess import preprocess

HEADERS = dict.fromkeys(("graphics.h", "conio.h", "stdio.h", "iostream.h"), "")
TYPES = ("FILE", "ostream", "REGS")


def tree(text, cplusplus=False, beside=None):
    """The tree of a program."""
    found = preprocess(text, "T.C", HEADERS, (beside or {}).get, {})
    assert not found.errors, found.errors
    return parse(found.tokens, TYPES, cplusplus, found.headers)


def value(text, cplusplus=False):
    """An expression, short; `T` is a type there."""
    program = tree(f"typedef int T; int f() {{ return {text}; }}", cplusplus)
    return sketch(program.items[1].body.items[0].value)


def body(text, cplusplus=False):
    """Statements, short."""
    program = tree(f"typedef int T; int f() {{ {text} }}", cplusplus)
    return " ".join(map(sketch, program.items[1].body.items))


def declared(text, cplusplus=False):
    """The names that a program declares, with their types in words."""
    names = []
    for item in tree(text, cplusplus).items:
        if isinstance(item, trees.Declaration):
            names += [(one.name, words(one.type)) for one in item.names]
        elif isinstance(item, trees.FunctionDef):
            names.append((item.name, words(item.type)))
    return dict(names)


def words(type_):
    """A type in words, as one reads it aloud."""
    said = []
    for part in type_.parts:
        match part:
            case nodes.PointerPart():
                said.append("pointer to")
            case nodes.ReferencePart():
                said.append("reference to")
            case nodes.ArrayPart(size):
                said.append(f"array of {sketch(size)}" if size else "array of")
            case nodes.FunctionPart(parameters, open_):
                inside = [words(one.type) for one in parameters] + ["..."] * open_
                said.append(f"function({', '.join(inside)}) returning")
    match type_.base:
        case nodes.Words(base):
            said.append(" ".join(base) or "int")
        case nodes.Named(name):
            said.append(name)
        case nodes.Tagged(kind, tag):
            said.append(f"{kind} {tag}")
    return " ".join(said)


def sketch(node):
    """A node, without its place."""
    match node:
        case None:
            return "-"
        case nodes.IntLit(_, number, suffix):
            return f"{number}{suffix}"
        case nodes.FloatLit(_, number, suffix):
            return f"{number}{suffix}"
        case nodes.CharLit(_, number):
            return f"'{number}'"
        case nodes.StrLit(_, text):
            return repr(text)[1:]
        case nodes.Name(_, name, scope):
            return f"{scope}::{name}" if scope else name
        case trees.ExprStmt(_, inner):
            return f"{sketch(inner)};"
        case nodes.TypeName():
            return f"<{words(node)}>"
        case str() | bool() | int():
            return str(node)
        case tuple():
            return " ".join(map(sketch, node))
    kind = type(node).__name__
    parts = [getattr(node, field.name) for field in fields(node) if field.name != "place"]
    if kind in ("Binary", "Logical", "Assign", "Unary"):
        kind, *parts = parts
    inside = " ".join(filter(None, map(sketch, parts)))
    return f"({kind} {inside})" if inside else f"({kind})"
