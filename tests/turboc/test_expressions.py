"""Made-up expressions of whole numbers: what they are worth is computed again, step by step.

The emitted Python cuts numbers to their bits as late as it can; here every step cuts, once in
Python and once by gcc.
"""

import shutil
import subprocess

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bgi.turboc.running import Runnable
from bgi.turboc.runtime.session import Session

INT, UNSIGNED, LONG, ULONG = (16, True), (16, False), (32, True), (32, False)
NAMES = {INT: "int", UNSIGNED: "unsigned", LONG: "long", ULONG: "unsigned long"}
NAMES |= {(8, True): "char", (8, False): "unsigned char"}
GCC = {INT: "short", UNSIGNED: "unsigned short", LONG: "int", ULONG: "unsigned"}
GCC |= {(8, True): "signed char", (8, False): "unsigned char"}

VARIABLES = {
    **{"i1": (INT, 32767), "i2": (INT, -32768), "i3": (INT, -7), "i4": (INT, 300)},
    **{"u1": (UNSIGNED, 65535), "u2": (UNSIGNED, 3), "l1": (LONG, 0x7FFFFFFF)},
    **{"l2": (LONG, -0x80000000), "l3": (LONG, 100000), "m1": (ULONG, 0xFFFFFFFF)},
    **{"c1": ((8, True), -128), "c2": ((8, True), 127), "b1": ((8, False), 255)},
}


def fitted(value, kind):
    """A number in so many bits."""
    bits, signed = kind
    value &= (1 << bits) - 1
    return value - (value >> bits - 1 << bits) if signed else value


def promoted(kind):
    return INT if kind[0] < 16 else kind


def common(left, right):
    left, right = promoted(left), promoted(right)
    if left[0] != right[0]:
        return max(left, right)
    return (left[0], left[1] and right[1])


def cast(text, kind):
    return f"(({GCC[kind]})({text}))"


def converted(value, kind):
    text, gcc, _, number = value
    return text, cast(gcc, kind), kind, fitted(number, kind)


def quotient(left, right):
    whole = abs(left) // abs(right)
    return whole if (left < 0) == (right < 0) else -whole


OPERATIONS = {
    **{"+": int.__add__, "-": int.__sub__, "*": int.__mul__, "&": int.__and__, "|": int.__or__},
    **{"^": int.__xor__, "/": quotient, "%": lambda a, b: a - b * quotient(a, b)},
}
COMPARISONS = {
    **{"<": int.__lt__, "<=": int.__le__, ">": int.__gt__, ">=": int.__ge__},
    **{"==": int.__eq__, "!=": int.__ne__},
}


def binary(op, left, right):
    """Two expressions with an operator between them: text, gcc's text, type and value."""
    kind = common(left[2], right[2])
    _, one, _, a = converted(left, kind)
    _, other, _, b = converted(right, kind)
    text = f"({left[0]} {op} {right[0]})"
    if op in COMPARISONS:
        return text, cast(f"{one} {op} {other}", INT), INT, int(COMPARISONS[op](a, b))
    if op in "/%" and b in (0, -1):
        return binary("+", left, right)
    return text, cast(f"{one} {op} {other}", kind), kind, fitted(OPERATIONS[op](a, b), kind)


def shifted(op, left, count):
    kind = promoted(left[2])
    _, one, _, a = converted(left, kind)
    value = a << count if op == "<<" else a >> count
    return f"({left[0]} {op} {count})", cast(f"{one} {op} {count}", kind), kind, fitted(value, kind)


def unary(op, operand):
    kind = promoted(operand[2])
    _, one, _, a = converted(operand, kind)
    if op == "!":
        return f"(!{operand[0]})", cast(f"!{one}", INT), INT, int(not a)
    value = -a if op == "-" else ~a
    return f"({op}{operand[0]})", cast(f"{op}{one}", kind), kind, fitted(value, kind)


def chosen(condition, yes, no):
    kind = common(yes[2], no[2])
    _, one, _, a = converted(yes, kind)
    _, other, _, b = converted(no, kind)
    text = f"({condition[0]} ? {yes[0]} : {no[0]})"
    gcc = cast(f"{condition[1]} ? {one} : {other}", kind)
    return text, gcc, kind, a if condition[3] else b


def as_written(kind, operand):
    return (f"(({NAMES[kind]}) {operand[0]})", *converted(operand, kind)[1:])


LEAVES = st.sampled_from([(name, name, *what) for name, what in VARIABLES.items()]) | st.integers(
    0, 32767
).map(lambda n: (str(n), cast(str(n), INT), INT, n))


def deeper(inner):
    return st.one_of(
        st.builds(binary, st.sampled_from([*OPERATIONS, *COMPARISONS]), inner, inner),
        st.builds(binary, st.sampled_from("+-*"), inner, inner),
        st.builds(shifted, st.sampled_from(["<<", ">>"]), inner, st.integers(0, 15)),
        st.builds(unary, st.sampled_from("-~!"), inner),
        st.builds(chosen, inner, inner, inner),
        st.builds(as_written, st.sampled_from(list(NAMES)), inner),
    )


EXPRESSIONS = st.lists(st.recursive(LEAVES, deeper, max_leaves=10), min_size=20, max_size=40)


needs_gcc = pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")


def literal(number):
    """A whole number as it is written: INT_MIN as a difference."""
    text = str(number) if number != -32768 else "(-32767 - 1)"
    kind = INT if number <= 32767 else LONG
    return text, cast(text, kind), kind, number


def declared(types):
    """The variables, of the types as one compiler calls them."""
    text = "".join(f"{types[kind]} {name} = {n};" for name, (kind, n) in VARIABLES.items())
    return text.replace("-2147483648", "-2147483647 - 1")


def compiled(folder, text):
    """What a program prints that gcc has compiled."""
    (folder / "g.c").write_text(f"#include <stdio.h>\n{text}")
    command = ["gcc", "-w", "-fwrapv", "-fno-builtin", "-o", folder / "g", folder / "g.c"]
    subprocess.run(command, check=True)
    return subprocess.run([folder / "g"], capture_output=True, text=True, check=True).stdout


def results(path, expressions):
    """What the program of the expressions makes of them."""
    body = "".join(f"r[{at}] = {one[0]};\n" for at, one in enumerate(expressions))
    path.write_text(f"{declared(NAMES)} long r[{len(expressions)}]; void main() {{ {body} }}")
    names = Runnable(str(path), {}).load(Session())
    names["main"]()
    return names["r"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("c")


@settings(max_examples=40, deadline=None)
@given(expressions=EXPRESSIONS)
def test_bits_are_cut_where_they_can_be_seen(folder, expressions):
    found = results(folder / "T.C", expressions)
    assert dict(zip([one[0] for one in expressions], found, strict=True)) == {
        one[0]: fitted(one[3], LONG) for one in expressions
    }


@needs_gcc
@settings(max_examples=4, deadline=None)
@given(expressions=EXPRESSIONS)
def test_gcc_agrees(folder, expressions):
    body = "".join(f'printf("%d ", (int) {one[1]});\n' for one in expressions)
    said = compiled(folder, f"{declared(GCC)} int main() {{ {body} return 0; }}")
    assert results(folder / "T.C", expressions) == [int(word) for word in said.split()]


STEPS = st.lists(
    st.tuples(
        st.sampled_from(list(VARIABLES)),
        st.sampled_from([*OPERATIONS, "<<", ">>", "=", "++", "--"]),
        st.sampled_from(list(VARIABLES)) | st.integers(-300, 300),
    ),
    min_size=20,
    max_size=40,
)


def followed(steps):
    """Assignments in C and for gcc, and what the variables hold behind them."""
    holds = {name: number for name, (_, number) in VARIABLES.items()}
    lines: list[str] = []
    gcc: list[str] = []
    for name, op, other in steps:
        kind = VARIABLES[name][0]
        own = (name, name, kind, holds[name])
        if op in ("++", "--"):
            made, text = binary(op[0], own, literal(1)), f"{name}{op}"
        elif op in ("<<", ">>"):
            count = len(lines) % 16
            made, text = shifted(op, own, count), f"{name} {op}= {count}"
        else:
            right = literal(other) if isinstance(other, int) else None
            right = right or (other, other, VARIABLES[other][0], holds[other])
            if op in "/%" and right[3] in (0, -1):
                continue
            made = right if op == "=" else binary(op, own, right)
            text = f"{name} {op.rstrip('=')}= {right[0]}"
        holds[name] = fitted(made[3], kind)
        lines.append(f"{text};")
        gcc.append(f"{name} = {cast(made[1], kind)};")
    return lines, gcc, holds


@settings(max_examples=60, deadline=None)
@given(steps=STEPS)
def test_what_is_assigned_is_cut_to_the_variable(folder, steps):
    lines, _, holds = followed(steps)
    assert left_behind(folder, lines) == list(holds.values())


@needs_gcc
@settings(max_examples=4, deadline=None)
@given(steps=STEPS)
def test_gcc_assigns_the_same(folder, steps):
    lines, gcc, _ = followed(steps)
    shown = "".join(f'printf("%d ", (int) {name});' for name in VARIABLES)
    said = compiled(folder, f"{declared(GCC)} int main() {{ {' '.join(gcc)} {shown} return 0; }}")
    assert left_behind(folder, lines) == [
        number & 0xFFFFFFFF if VARIABLES[name][0] == ULONG else number
        for name, number in zip(VARIABLES, map(int, said.split()), strict=True)
    ]


def left_behind(folder, lines):
    """What the variables hold behind assignments, in a function of which they are locals."""
    kept = "".join(f"k_{name} = {name};" for name in VARIABLES)
    kinds = "".join(f"{NAMES[kind]} k_{name};" for name, (kind, _) in VARIABLES.items())
    path = folder / "S.C"
    path.write_text(f"{kinds} void main() {{ {declared(NAMES)} {' '.join(lines)} {kept} }}")
    names = Runnable(str(path), {}).load(Session())
    names["main"]()
    return [names[f"k_{name}"] for name in VARIABLES]


def ends_of(kind):
    """A type, and numbers at which a loop over it may end: near its own."""
    low, high = (
        (-(1 << kind[0] - 1), (1 << kind[0] - 1) - 1) if kind[1] else (0, (1 << kind[0]) - 1)
    )
    near = [low, low + 1, low + 20, 0, 3, high - 20, high - 1, high]
    return st.tuples(st.just(kind), st.sampled_from(near))


SIZES = {
    "7": lambda s: 7,
    "s": int,
    "(s & 7)": lambda s: s & 7,
    "(s & 7) + 1": lambda s: (s & 7) + 1,
}


@settings(max_examples=250, deadline=None)
@given(
    end=st.sampled_from([INT, UNSIGNED, (8, True), (8, False)]).flatmap(ends_of),
    before=st.integers(-60, 60),
    s=st.integers(0, 40),
    size=st.sampled_from(list(SIZES)),
    op=st.sampled_from(["<", "<=", ">", ">="]),
    up=st.booleans(),
    more=st.integers(-3, 3),
    named=st.booleans(),
)
def test_loops_count_as_in_c(folder, end, before, s, size, op, up, more, named):
    """Whether they become ranges or not; those that do not end are left after 50 turns."""
    kind, last = end
    begin = i = fitted(last + before, kind)
    step, turns, total = SIZES[size](s), 0, 0
    limit = ("e", "e", kind, last) if named else literal(last)
    while turns < 50 and binary(op, ("i", "i", kind, i), limit)[3]:
        turns += 1
        total += binary("+", ("i", "i", kind, i), literal(more))[3]
        i = fitted(i + (step if up else -step), kind)
    path = folder / "L.C"
    path.write_text(
        f"long total, last; int turns; void main() {{ {NAMES[kind]} i, e = {literal(last)[0]};"
        f"int s = {s}; for (i = {literal(begin)[0]}; i {op} {limit[0]}; i {'-+'[up]}= {size})"
        f"{{ if (turns == 50) break; turns++; total += i + {more}; }} last = i; }}"
    )
    names = Runnable(str(path), {}).load(Session())
    names["main"]()
    assert (names["turns"], names["total"], names["last"]) == (turns, total, i)
