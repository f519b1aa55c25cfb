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


def results(path, expressions):
    """What the program of the expressions makes of them."""
    declared = "".join(f"{NAMES[kind]} {name} = {n};" for name, (kind, n) in VARIABLES.items())
    declared = declared.replace("-2147483648", "-2147483647 - 1")
    body = "".join(f"r[{at}] = {one[0]};\n" for at, one in enumerate(expressions))
    path.write_text(f"{declared} long r[{len(expressions)}]; void main() {{ {body} }}")
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


@pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")
@settings(max_examples=4, deadline=None)
@given(expressions=EXPRESSIONS)
def test_gcc_agrees(folder, expressions):
    source, program = folder / "g.c", folder / "g"
    declared = "".join(f"volatile {GCC[k]} {name} = {n}LL;" for name, (k, n) in VARIABLES.items())
    body = "".join(f'printf("%d ", (int) {one[1]});\n' for one in expressions)
    source.write_text(f"#include <stdio.h>\n{declared} int main() {{ {body} return 0; }}")
    subprocess.run(["gcc", "-w", "-fwrapv", "-o", program, source], check=True)
    said = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    assert results(folder / "T.C", expressions) == [int(word) for word in said.split()]
