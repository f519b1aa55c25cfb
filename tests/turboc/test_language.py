"""The corners of C and C++: what old programs may contain, and few do."""

import pytest

from bgi.turboc.running import Runnable
from bgi.turboc.runtime.session import Session


@pytest.fixture
def result(tmp_path):
    """What `r` holds after statements; what stands before them may come along."""

    def run(body, before="", ending=".C"):
        path = tmp_path / f"T{ending}"
        path.write_text(f"long r; {before}\nvoid main() {{ {body} }}")
        names = Runnable(str(path), {}).load(Session())
        names["main"]()
        return names["r"]

    return run


def test_a_case_may_stand_in_a_loop_of_its_switch(result):
    duff = """
        int copied(int n) {
            int s = 0, k = (n + 3) / 4;
            switch (n % 4) {
                case 0: do { s += 1; case 3: s += 1; case 2: s += 1; case 1: s += 1; } while (--k);
            }
            return s;
        }
    """
    assert result("int n; for (n = 1; n < 10; n++) r = r * 10 + copied(n);", duff) == 123456789
    deep = "int f(int a) { switch (a) { case 1: if (a) { case 2: return 5; } default: return 7; } }"
    assert result("r = f(1) * 100 + f(2) * 10 + f(3);", deep) == 557


def test_else_if_goes_on_as_long_as_one_likes(result):
    chain = "".join(f"if (x == {n}) r = {n * n}; else " for n in range(300))
    assert result(f"int x = 299; {chain} r = -1;") == 299 * 299


def test_bit_fields_have_as_many_bits_as_they_say(result):
    fields = "struct f { unsigned a : 1; unsigned b : 3; int c : 4; unsigned d : 7; } x;"
    body = "x.a = 3; x.b = 9; x.c = 9; x.d = 300;"
    assert result(f"{body} r = x.a * 1000 + x.b * 100 + x.c;", fields) == 1000 + 100 - 7
    assert result(f"{body} r = x.d; x.a++; r = r * 10 + x.a;", fields) == 440
    assert result("r = sizeof(struct f);", fields) == 2


def test_an_object_becomes_a_number_by_its_operator(result):
    ratio = "class R { int a, b; public: R(int x, int y) { a = x; b = y; } operator int(); "
    ratio += "operator double() { return (double) a / b; } }; R::operator int() { return a / b; }"
    assert result("R q(7, 2); int i = q; double d = q; r = i * 100 + d * 10;", ratio, ".CPP") == 335
    assert result("R q(7, 2); r = q + 1; if (!q) r = 0;", ratio, ".CPP") == 4


def test_a_reference_may_be_to_one_of_two(result):
    pair = "struct P { int x, y; int &operator[](int i) { return i ? y : x; } };"
    assert result("P p; p[0] = 4; p[1] = 5; p[1]++; r = p.x * 10 + p.y;", pair, ".CPP") == 46


def test_methods_of_a_base_call_its_own(result):
    classes = """
        int log;
        class A { public: virtual ~A() { log = log * 10 + 1; } void f() { r = 1; }
            void g() { f(); } };
        class B : public A { public: ~B() { log = log * 10 + 2; } void f() { r = 2; } };
    """
    assert result("B b; b.g();", classes, ".CPP") == 1
    assert result("A *a = new B; delete a; r = log;", classes, ".CPP") == 21
