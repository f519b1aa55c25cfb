"""What is wrong with a program: told before it starts where it can be, and always with the line."""

import pytest

from bgi.turboc.faults import CError, CErrors
from bgi.turboc.running import Runnable
from bgi.turboc.runtime.session import Session


def program(tmp_path, text, ending=".CPP"):
    path = tmp_path / f"T{ending}"
    path.write_text(text)
    return Runnable(str(path), {})


def main(body):
    return f"void main() {{ {body} }}"


@pytest.mark.parametrize(
    "text, message",
    [
        (main("break;"), "this break stands in no loop and no switch"),
        (main("switch (1) { case 1: continue; }"), "this continue stands in no loop"),
        (main("case 1: ;"), "this case stands in no switch"),
        (main("a: a: goto a;"), "there is another label a in this function"),
        (main("goto b;"), "there is no label b in this function"),
        (main("void x;"), "x cannot be void"),
        ("void x;" + main(""), "x cannot be void"),
        ("int main;", "there is no main() in this program"),
        ("int f(int);" + main("f(1);"), "f() has no body"),
        ("class A { public: void f(); };" + main("A a; a.f();"), "f() has no body"),
        ("struct A { struct A a; };" + main(""), "A stands in itself: use a pointer to it"),
        ("struct B; struct A { B b; };" + main(""), "B is not known yet: use a pointer to it"),
        ("class A : A { };" + main(""), "A is no class"),
        (
            "struct A { virtual void f() = 0; }; struct B : A { };" + main("B b;"),
            "B is abstract: its f() has no body",
        ),
        ("struct f { int a : 40; };" + main(""), "a cannot have 40 bits"),
        ("int a[2][0];" + main(""), "an array cannot have 0 elements"),
        (main("cho = 1;"), "there is no cho"),
        (main("outtextyx(1, 2, 3);"), "there is no outtextyx: did you mean outtextxy?"),
        ("int a[100000]; long b[3000][3000];" + main(""), "an array of 9000000 elements is too"),
    ],
)
def test_errors_are_told_before_the_program_starts(tmp_path, text, message):
    with pytest.raises(CErrors) as found:
        program(tmp_path, text)
    assert found.value.errors[0].message.startswith(message)


@pytest.mark.parametrize(
    "body, message",
    [
        ('char *p = "abc"; p[-1] = 1;', "outside of an array"),
        ("int a[3]; a[-1] = 1;", "outside of an array"),
        ("char *p; *p = 1;", "a null pointer was used"),
        ("void (*f)(); f();", "a null pointer was used"),
        (
            "double x = 1e300 * 1e300; int i = x;",
            "this real number is too large for a whole number",
        ),
        ("int a = 0; a = 5 % a;", "division by zero"),
        ("double a = 0; a = 5 / a;", "division by zero"),
        ("long n = 2000000000L; char *p = new char[n]; p = new char[n];", "that much memory"),
        ('printf("%d");', "the argument of %d (conversion 1) is missing"),
        ('char a[2]; strcpy(a, "long");', "outside of an array"),
    ],
)
def test_a_fault_is_told_in_the_words_of_c(tmp_path, body, message):
    with pytest.raises(CError) as found:
        program(tmp_path, main(f"\n\n{body}")).run(Session())
    assert found.value.place.line == 3
    assert message in found.value.message
    assert "Error" not in found.value.message


@pytest.mark.parametrize(
    "text",
    [
        "void f() { f(); }" + main("f();"),
        "struct A { A operator+(A b) { return *this + b; } };" + main("A a; a + a;"),
        "struct A { A() { A b; } };" + main("A a;"),
        "struct A { ~A() { A b; } };" + main("A a;"),
        "void f() { long a[1000]; f(); }" + main("f();"),
    ],
)
def test_every_endless_recursion_ends(tmp_path, text):
    with pytest.raises(CError, match="the stack overflowed"):
        program(tmp_path, text).run(Session())


def test_a_flood_fill_may_call_itself_for_every_pixel(tmp_path):
    text = "int depth; int down(long n) { depth = 1; return n ? down(n - 1) : 7; }"
    made = program(tmp_path, text + "int main() { return down(300000); }")
    assert made.run(Session()) == 7


@pytest.mark.parametrize(
    "macros, use",
    [
        ("".join(f"#define A{n} A{n + 1} A{n + 1}\n" for n in range(40)), "A0;"),
        ("".join(f"#define A{n} A{n + 1} A{n + 1}\n" for n in range(40)) + "#define A40\n", "A0;"),
        ("#define F(x) G(x, x)\n#define G(a, b) a b b a b a b a\n", "F(" * 9 + "1" + ")" * 9),
        ("#define A B + B\n#define B C + C\n#define C A + A\n", "int B, C = 1, A = C;"),
    ],
)
def test_macros_that_make_too_much_are_an_error(tmp_path, macros, use):
    with pytest.raises(CErrors):
        program(tmp_path, macros + main(use))


def test_a_function_of_the_library_may_be_declared_again(tmp_path):
    text = "double floor(double); char *malloc(); int abs(int);"
    text += "int main() { return floor(2.5) * 10 + abs(-3); }"
    assert program(tmp_path, text, ".C").run(Session()) == 23
