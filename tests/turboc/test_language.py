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


def test_arguments_are_computed_from_right_to_left_where_it_shows(result):
    pair = "int pair(int a, int b) { return a * 10 + b; } int g; int next() { return ++g; }"
    assert result("int i = 1; r = pair(i, i++) * 100 + pair(i, ++i);", pair) == 21 * 100 + 33
    assert result("r = pair(g, next());", pair) == 11
    assert result("char s[3] = {1, 2}, *p = s; r = pair(*p, *++p);", pair) == 22


def test_names_that_mean_something_in_python_mean_nothing(result):
    before = """
        struct lambda { int None, in, copy, assign, SIZE, __class__, _x; char self[3]; } def;
        int print(int __import__) { return __import__ + 1; }
        int None(int self) { return self; }
        int __builtins__ = 4, eval = 5, _1 = 6, _more;
    """
    members = "def.None = 1; def.in = 2; def.copy = 3; def.assign = 4; def.SIZE = 5; def._x = 7;"
    body = f"struct lambda is; {members} def.__class__ = 6; is = def; is.self[0] = 8;"
    assert result(f"{body} r = is.None + is.in + is.copy + is.SIZE + is._x + is.__class__;", before)
    assert result(f"{body} r = is.__class__ * 10 + is._x + is.self[0] + def.self[0];", before) == 75
    body = "int True = 1, nonlocal; nonlocal = print(True) + None(_1); r = nonlocal + __builtins__;"
    assert result(f"{body} r += eval + _more;", before) == 2 + 6 + 4 + 5
    methods = "struct A { int v; void copy() { v = 1; } int assign(int in) { return v + in; } };"
    assert result("A a, b; a.copy(); b = a; r = b.assign(4);", methods, ".CPP") == 5


def test_members_begin_with_strings_of_their_own(result):
    names = 'struct n { char in[4]; char *p; }; struct n a = {"ab", "ab"}, b = {"ab"};'
    assert result("a.in[0] = 'x'; r = b.in[0] * 100 + *a.p + sizeof(a.in);", names) == 9801


def test_objects_that_a_list_leaves_out_are_constructed(result):
    point = "struct P { int x; P(int n = 7) { x = n; } };"
    assert result("P p[3] = {P(1)}; r = p[0].x * 100 + p[1].x + p[2].x;", point, ".CPP") == 114


def test_a_choice_of_characters_is_one_in_cplusplus(result):
    kinds = "int f(int) { return 1; } int f(char) { return 2; }"
    assert result("r = f(r ? 'a' : 'b');", kinds, ".CPP") == 2


def test_std_may_stand_before_names(result):
    assert result("r = std::abs(-4);", "\n#include <cmath>\nusing namespace std;", ".CPP") == 4


def test_a_class_may_be_declared_before_it_is_defined(result):
    classes = """
        class B;
        class A { B *b; public: A(B *p) { b = p; } int get(); friend int both(A &, B &); };
        class B { public: int v; B() { v = 5; } };
        int A::get() { return b->v; }
    """
    assert result("B b; A a(&b); b.v++; r = a.get();", classes, ".CPP") == 6
