"""Formulas such as "sin(x*y)/2": a text becomes a function, and never a program.

Python's own parser makes a tree of the text. Then we walk the tree, and each node must be in a
table: a number, a name, an operator, a function of those below. What is in no table is refused, so
a formula can only calculate. Numbers are floats, so no power grows beyond all bounds.

    f = formula("sin(x*y)/2")
    f(1.0, 2.0), f(xs, ys)

`^` is power, as on paper. Comparisons are 1 where they hold and 0 elsewhere: (x > 0)*y is half a
plane.
"""

from __future__ import annotations

import ast
import operator
import re
import warnings
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np

Part = Callable[[Any, Any], Any]
"""A piece of a formula: x and y in, a number (or an array of them) out."""

LONGEST, DEEPEST = 500, 100
"""How many characters a formula may have, and how many pieces may sit one inside the other."""

NAMES: dict[str, Part] = {
    "x": lambda x, y: x,
    "y": lambda x, y: y,
    "r": np.hypot,
    "theta": lambda x, y: np.arctan2(y, x),
    "pi": lambda x, y: np.float64(np.pi),
    "e": lambda x, y: np.float64(np.e),
}
"""x and y; r and theta, the same place in polar coordinates; pi and e."""

FUNCTIONS: dict[str, tuple[int, Callable[..., Any]]] = {
    "sin": (1, np.sin),
    "cos": (1, np.cos),
    "tan": (1, np.tan),
    "asin": (1, np.arcsin),
    "acos": (1, np.arccos),
    "atan": (1, np.arctan),
    "atan2": (2, np.arctan2),
    "arcsin": (1, np.arcsin),
    "arccos": (1, np.arccos),
    "arctan": (1, np.arctan),
    "arctan2": (2, np.arctan2),
    "sinh": (1, np.sinh),
    "cosh": (1, np.cosh),
    "tanh": (1, np.tanh),
    "exp": (1, np.exp),
    "log": (1, np.log),
    "ln": (1, np.log),
    "log2": (1, np.log2),
    "log10": (1, np.log10),
    "sqrt": (1, np.sqrt),
    "cbrt": (1, np.cbrt),
    "abs": (1, np.abs),
    "sign": (1, np.sign),
    "floor": (1, np.floor),
    "ceil": (1, np.ceil),
    "round": (1, np.rint),
    "mod": (2, np.mod),
    "min": (2, np.minimum),
    "max": (2, np.maximum),
    "hypot": (2, np.hypot),
    # sin(t)/t, as the paper draws it; numpy's own is sin(pi t)/(pi t).
    "sinc": (1, lambda t: np.sinc(t / np.pi)),
    "where": (3, lambda condition, a, b: np.where(condition != 0, a, b)),
}
"""Each function and how many values it takes; where(a > b, c, d) is c where a > b, else d."""

UNARY: dict[type[ast.AST], Callable[[Any], Any]] = {ast.UAdd: np.positive, ast.USub: np.negative}

BINARY: dict[type[ast.AST], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
}

COMPARISONS: dict[type[ast.AST], Callable[[Any, Any], Any]] = {
    ast.Lt: np.less,
    ast.LtE: np.less_equal,
    ast.Gt: np.greater,
    ast.GtE: np.greater_equal,
    ast.Eq: np.equal,
    ast.NotEq: np.not_equal,
}

OPERATORS = "+ - * / // % ^ < <= > >= == !="

# What people write, and what to write here.
HINTS: dict[type[ast.AST], str] = {
    ast.Attribute: "functions have no dot before them: sin(x)",
    ast.BoolOp: 'for "and" multiply: (x > 0)*(y > 0); for "or" take max(x > 0, y > 0)',
    ast.IfExp: "write where(x > 0, a, b)",
    ast.Tuple: "a comma stands only between the values of a function; decimals have a point",
}

# What Python's parser complains of, and what it means here.
COMPLAINTS = (
    ("invalid syntax. Perhaps", "an operator is missing: multiplication is written 2*x"),
    ("invalid decimal", "an operator is missing: multiplication is written 2*x"),
    ("invalid imaginary", "an operator is missing: multiplication is written 2*x"),
    ("leading zeros", "a number does not begin with 0: write 7, not 07"),
    ("'(' was never closed", "this ( is never closed: add a )"),
    ("unmatched ')'", "there is no ( for this )"),
    ("too many nested", "this is nested too deeply"),
)

STRANGE = re.compile(r"[^\w .+\-*/%^(),<>=!]", re.ASCII)
LONE_EQUALS = re.compile(r"(?<![<>=!])=(?!=)")


class FormulaError(ValueError):
    """A text is not a formula: what is wrong, where, and what to do about it.

    Attributes:
        problem: What is wrong, in one sentence.
        text: The formula.
        column: Where in it the piece begins that the problem is about...
        width: ... and how many characters it has.
    """

    def __init__(self, problem: str, text: str, column: int, width: int) -> None:
        self.problem = problem
        self.text = "".join(c if c.isprintable() else "?" for c in text)
        self.column = min(column, len(text))
        self.width = max(1, width)
        super().__init__(f"{problem} (column {self.column + 1})\n{self.text}\n{self.caret}")

    @property
    def caret(self) -> str:
        """A line that points at the piece when it stands below the text."""
        return " " * self.column + "^" * self.width


def formula(text: str) -> Part:
    """Read z as a formula of x and y and return the function: numbers or arrays in, z out.

    The names x, y, r, theta, pi and e; functions such as sin, sqrt, min and where; the operators
    + - * / // % ^ (or **), comparisons and parentheses make a formula.

    Args:
        text: The formula, at most 500 characters.

    Returns:
        A function of two floats, or of two arrays that broadcast. It returns float64 of their
        common shape, and gives NaN or infinity, never an error or a warning, where z has no value.

    Raises:
        FormulaError: if the text is anything else.
    """
    part = _Reader(re.sub(r"\s", " ", text).strip()).read()

    def f(x: Any, y: Any) -> Any:
        xs, ys = np.asarray(x, dtype=np.float64), np.asarray(y, dtype=np.float64)
        with np.errstate(all="ignore"):
            z = part(xs, ys)
        # A constant has a value everywhere; x alone must not be the very array that came in.
        return np.array(np.broadcast_to(z, np.broadcast_shapes(xs.shape, ys.shape)))[()]

    return f


class _Reader:
    """A walk over the tree of one formula."""

    def __init__(self, text: str) -> None:
        self.text = text
        # Python's ^ is something else, and binds less: so it reads **, and columns are counted.
        self.columns = [i for i, c in enumerate(text) for _ in range(2 if c == "^" else 1)]

    def read(self) -> Part:
        """The whole formula."""
        text = self.text
        if not text:
            raise FormulaError("there is no formula: write one like sin(x*y)/2", text, 0, 1)
        if len(text) > LONGEST:
            problem = f"the formula is too long: at most {LONGEST} characters"
            raise FormulaError(problem, text[: LONGEST + 1], LONGEST, 1)
        if strange := STRANGE.search(text):
            problem = f"{strange[0]!r} means nothing in a formula: leave it out"
            raise FormulaError(problem, text, strange.start(), 1)
        if equals := LONE_EQUALS.search(text):
            problem = "write only what z is equal to, without ="
            raise FormulaError(problem, text, equals.start(), 1)
        return self._part(self._tree(), 1)

    def _tree(self) -> ast.expr:
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # such as "invalid decimal literal" for 1if
                return ast.parse(self.text.replace("^", "**"), mode="eval").body
        except SyntaxError as error:
            raise self._complaint(error) from None
        except (RecursionError, MemoryError):
            raise FormulaError("this is nested too deeply", self.text, 0, 1) from None

    def _complaint(self, error: SyntaxError) -> FormulaError:
        """Say in our words what Python's parser did not like."""
        start = (error.offset or 0) - 1  # Python counts from 1, and says 0 for the end
        if not 0 <= start < len(self.columns):
            problem = "the formula ends too soon: something is missing"
            return FormulaError(problem, self.text, len(self.text), 1)
        end = max((error.end_offset or 0) - 1, start + 1)
        column, width = self._place(start, end)
        found = self.text[column : column + width]
        problem = f"{found!r} does not fit here: something is missing before it, or it is too much"
        for complaint, ours in COMPLAINTS:
            if (error.msg or "").startswith(complaint):
                problem = ours
        return FormulaError(problem, self.text, column, width)

    def _place(self, start: int, end: int) -> tuple[int, int]:
        """The column and the width, in the text, of a piece of the source."""
        last = self.columns[min(end, len(self.columns)) - 1]
        column = self.columns[min(start, len(self.columns) - 1)]
        return column, last + 1 - column

    def _error(self, node: ast.expr, problem: str) -> FormulaError:
        column, width = self._place(node.col_offset, node.end_col_offset or 0)
        return FormulaError(problem, self.text, column, width)

    def _part(self, node: ast.expr, depth: int) -> Part:
        """The function that a node stands for; FormulaError if it is in no table."""
        if depth > DEEPEST:
            raise self._error(
                node, f"this is nested too deeply: at most {DEEPEST} one inside the other"
            )
        match node:
            case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
                return self._number(node, value)
            case ast.Name(id=name):
                return self._name(node, name)
            case ast.UnaryOp(op=op, operand=operand) if type(op) in UNARY:
                return _applied(UNARY[type(op)], [self._part(operand, depth + 1)])
            case ast.BinOp(left=left, op=op, right=right) if type(op) in BINARY:
                both = [self._part(side, depth + 1) for side in (left, right)]
                return _applied(BINARY[type(op)], both)
            case ast.Compare(ops=ops) if all(type(op) in COMPARISONS for op in ops):
                return self._comparison(node, depth)
            case ast.Call():
                return self._call(node, depth)
            case ast.BinOp() | ast.Compare() | ast.UnaryOp():
                raise self._error(node, f"this operator is none of {OPERATORS}")
        raise self._error(node, HINTS.get(type(node), "this is no part of a formula"))

    def _number(self, node: ast.expr, value: float) -> Part:
        try:
            number = np.float64(value)
        except OverflowError:
            number = np.float64("inf")
        if not np.isfinite(number):
            raise self._error(node, "this number is too large: at most 1.79e308")
        return lambda x, y: number

    def _name(self, node: ast.expr, name: str) -> Part:
        if name in FUNCTIONS:
            raise self._error(node, f"{name} is a function: write {_usage(name)}")
        if name not in NAMES:
            raise self._error(node, f"unknown name {name!r}: there are {', '.join(NAMES)}")
        return NAMES[name]

    def _comparison(self, node: ast.Compare, depth: int) -> Part:
        """1 where all of a < b < c holds, and 0 elsewhere."""
        parts = [self._part(side, depth + 1) for side in (node.left, *node.comparators)]
        tests = [COMPARISONS[type(op)] for op in node.ops]

        def holds(x: Any, y: Any) -> Any:
            values = [part(x, y) for part in parts]
            z = 1.0
            for test, (a, b) in zip(tests, pairwise(values), strict=True):
                z = z * test(a, b)
            return z

        return holds

    def _call(self, node: ast.Call, depth: int) -> Part:
        if not isinstance(node.func, ast.Name) or node.func.id in NAMES:
            hint = HINTS.get(type(node.func), "this is no function: to multiply write 2*(x + y)")
            raise self._error(node.func, hint)
        name = node.func.id
        if name not in FUNCTIONS:
            names = ", ".join(FUNCTIONS)
            raise self._error(node.func, f"unknown function {name!r}: there are {names}")
        count, function = FUNCTIONS[name]
        if len(node.args) != count or node.keywords:
            values = "one value" if count == 1 else f"{count} values"
            raise self._error(node, f"{name} takes {values}: write {_usage(name)}")
        return _applied(function, [self._part(value, depth + 1) for value in node.args])


def _applied(function: Callable[..., Any], parts: list[Part]) -> Part:
    return lambda x, y: function(*[part(x, y) for part in parts])


def _usage(name: str) -> str:
    """How a function is written: atan2(a, b)."""
    return f"{name}({', '.join('abc'[: FUNCTIONS[name][0]])})"
