"""C programs run: what their variables hold at the end is what C says."""

import pytest

from bgi.turboc.faults import CError, CErrors
from bgi.turboc.running import Runnable
from bgi.turboc.runtime.session import Session


def program(tmp_path, text, ending=".C"):
    """A program, understood."""
    path = tmp_path / f"T{ending}"
    path.write_text(text)
    return Runnable(str(path), {})


@pytest.fixture
def result(tmp_path):
    """What `r` holds after statements; what stands before them may come along."""

    def run(body, before="", kind="long", ending=".C"):
        made = program(tmp_path, f"{kind} r; {before}\nvoid main() {{ {body} }}", ending)
        names = made.load(Session())
        names["main"]()
        return names["r"]

    return run


@pytest.mark.parametrize(
    "value, expected",
    [
        ("32767 + i", -32768),
        ("i * 30000 * 3", 24464),
        ("-7 / 2", -3),
        ("(i - 8) / 2", -3),
        ("(i - 8) % 2", -1),
        ("i << 15", -32768),
        ("-i >> 1", -1),
        ("u - 2", 65535),
        ("u - 2 > 0", 1),
        ("-1 < u", 0),
        ("l * 70000", 605032704),
        ("(char) 200", -56),
        ("(unsigned char) -1", 255),
        ("(int) 3.99", 3),
        ("(int) -3.99", -3),
        ("(int) 70000.0", 4464),
        ("i ? 2 : 3", 2),
        ("!i + !!i", 1),
        ("(i, 5)", 5),
        ("sizeof(int) * 100 + sizeof(long) * 10 + sizeof(double)", 248),
        ("sizeof(a)", 12),
        ("0xFFFF", 65535),
        ("~0", -1),
        ("'A' + 1", 66),
        ("5 / 2.0 * 2", 5),
    ],
)
def test_arithmetic_has_as_many_bits_as_in_c(result, value, expected):
    declared = "int i = 1, a[2][3]; unsigned u = 1; long l = 70000;"
    assert result(f"r = {value};", declared) == expected


def test_loops_leave_their_variable_behind(result):
    assert result("int i, s = 0; for (i = 0; i < 10; i++) s += i; r = s * 100 + i;") == 4510
    assert result("int i; for (i = 0; i < 10; i++) if (i == 4) break; r = i;") == 4
    assert result("int i; for (i = 20; i < 10; i++); r = i;") == 20
    assert (
        result("int i, s = 0; for (i = 9; i; i -= 3) { if (i == 6) continue; s += i; } r = s;")
        == 12
    )
    assert result("int i = 0; do { if (i == 3) continue; r += i; } while (++i < 5);") == 7


@pytest.mark.parametrize(
    "loop, expected",
    [
        ("for (i = 9; i >= 0; i -= 3)", (9630, -3)),
        ("for (i = 4; i > 0; i--)", (4321, 0)),
        ("for (i = 1; i <= n - 1; i = i + 2)", (13, 5)),
        ("for (i = 1; i < n * 2; i += n)", (16, 11)),
        ("for (i = 5; i < 5; i += 2)", (0, 5)),
        ("for (i = 1; i < 5; i += zero & 3) if (r > 1000) break; else", (1111, 1)),
        ("for (i = 1; i < n; i += 2) if (i == 3) break; else", (1, 3)),
        ("for (i = 32766; i > 0; i++) if (i > 9)", (360427, -32768)),
        ("for (i = -32767; i < 0; i--) if (i < -9)", (-360438, 32767)),
        ("for (i = 32765; i <= 32766; i++) r = i + 2; if (0)", (-32768, 32767)),
        ("for (i = -32766; i >= -32767; i--) r = i - 2; if (0)", (32767, -32768)),
        ("for (i = -2; i < 5u; i++)", (0, -2)),
        ("for (i = n; i > 0; i -= 2) if (i == 3) n = 9; else", (51, -1)),
        ("for (u = 3; u >= 0 && k++ < 5; u--) i = u; if (0)", (0, -1)),
    ],
)
def test_loops_count_in_any_steps(result, loop, expected):
    declared = "int i, n = 5, zero = 0, k = 0; unsigned u;"
    assert result(f"{declared} {loop} r = r * 10 + i;") == expected[0]
    assert result(f"{declared} {loop} r = r * 10 + i; r = i;") == expected[1]


def test_an_empty_loop_is_waited_for_and_not_run(tmp_path, monkeypatch):
    waited: list[int] = []
    monkeypatch.setattr("bgi.dos.delay", waited.append)
    text = """int busy = 1;
        void main() { int i; for (i = 1; i <= 30000; i++) { ; } for (i = 0; i < 9; i++) busy += i;
            for (i = 30000; i > 0; i--); for (i = 5; i < 5; i++); }
    """
    made = program(tmp_path, text)
    names = made.load(Session())
    for _ in range(2):
        names["main"]()
    assert waited == [7, 7, 7, 8]  # 8 cycles at 33 MHz, 30,000 times each
    names = made.load(Session(script_name="A"))
    names["main"]()
    assert waited == [7, 7, 7, 8]


def test_switch_falls_through_and_continues_the_loop_around(result):
    body = """
        int i;
        for (i = 0; i < 5; i++) {
            switch (i) {
                case 0: r += 1;
                case 1: r += 10; break;
                case 3: continue;
                default: r += 100;
            }
            r += 1000;
        }
    """
    assert result(body) == 4 * 1000 + 1 + 10 + 10 + 100 + 100


@pytest.mark.parametrize(
    "body, expected",
    [
        ("again: r++; if (r < 5) goto again;", 5),
        ("goto over; r = 1; over: r += 10;", 10),
        ("int i, j; for (i = 0; i < 9; i++) for (j = 0; j < 9; j++) if (i * j == 12) goto out;"
         " out: r = i * 10 + j;", 26),
        ("int i; for (i = 0; i < 5; i++) { if (i == 1) continue; if (i == 4) break;"
         " if (i == 9) goto end; r = r * 10 + i; } end: r = r * 10 + 7;", 237),
        ("int i = 0; top: switch (i++) { case 0: r += 1; goto top; case 1: r += 10;"
         " case 2: r += 100; break; default: r = 0; } if (i < 3) goto top;", 211),
        ("int i = 3; if (i) { back: r = r * 10 + i; } else r = 9; if (--i) goto back;", 321),
        ("int i = 2, j = 1; if (i == 2) { if (j == 2) { r = 1; in: r += 5; } else r += 10; }"
         " else r += 100; if (r < 11) goto in;", 15),
        ("int i = 0; do { if (i == 2) goto end; i++; } while (i < 9); end: r = i;", 2),
    ],
)  # fmt: skip
def test_goto_leads_to_any_label_of_the_function(result, body, expected):
    assert result(body) == expected


def test_pointers_walk_through_arrays_and_strings(result):
    assert result('char *p = "abc"; while (*p) r = r * 2 + *p++ - 96;') == 11
    assert result("int a[4], *p = a, i; for (i = 0; i < 4; i++) *p++ = i; r = p - a + a[3];") == 7
    assert result("int a[2][3], (*p)[3] = a; p++; (*p)[1] = 7; r = a[1][1];") == 7
    assert result("int x = 1, *p = &x, **q = &p; **q += 4; r = x;") == 5
    swap = "void swap(int *a, int *b) { int t = *a; *a = *b; *b = t; }"
    assert result("int a = 1, b = 2; swap(&a, &b); r = a * 10 + b;", swap) == 21


def test_structs_are_values(result):
    point = "struct point { int x, y; char name[4]; };"
    body = 'struct point p = {1, 2, "ab"}, q; q = p; q.x = 5; q.name[0]++; r = '
    assert result(body + "p.x * 100 + q.x * 10 + q.y;", point) == 152
    assert result(body + "q.name[0] - p.name[0];", point) == 1
    move = point + "struct point moved(struct point p) { p.x++; return p; }"
    assert result("struct point p = {1}; r = moved(p).x * 10 + p.x;", move) == 21
    chain = "struct node { int v; struct node *next; };"
    body = """
        struct node a, b, *p; a.v = 1; a.next = &b; b.v = 2; b.next = 0;
        for (p = &a; p; p = p->next) r = r * 10 + p->v;
    """
    assert result(body, chain) == 12


def test_functions_are_pointed_to_and_keep_static_variables(result):
    twice = "int twice(int x) { return 2 * x; } int (*f)(int) = twice;"
    assert result("r = f(4) + (*f)(1);", twice) == 10
    assert (
        result("int i; for (i = 0; i < 3; i++) r = n();", "int n() { static int c; return ++c; }")
        == 3
    )


def test_arguments_with_effects_are_computed_from_right_to_left(result):
    before = "int n; int next() { return ++n; } int sub(int a, int b) { return a * 10 + b; }"
    assert result("r = sub(next(), next());", before) == 21


def test_memory_of_malloc_is_what_its_pointer_says(result):
    body = "int *p = (int *) malloc(10 * sizeof(int)); p[9] = 3; r = p[9]; free(p);"
    assert result(body) == 3


def test_classes_have_constructors_virtual_methods_and_operators(result):
    before = """
        class Shape {
        protected: int n;
        public: Shape(int a = 4) { n = a; } virtual int area() { return n; }
        };
        class Square : public Shape {
        public: Square(int a) : Shape(a) {} int area() { return n * n; }
        };
        struct V { int x; V(int a) : x(a) {} V operator+(const V &o) { return V(x + o.x); } };
        void set(int &x) { x = 7; }
        int f(int) { return 1; } int f(double) { return 2; }
    """
    body = "Shape *s = new Square(5); Shape t; int x; set(x); V v = V(1) + V(2);"
    assert result(f"{body} r = s->area() * 100 + t.area() * 10 + x;", before, ending=".CPP") == 2547
    assert result(f"{body} r = v.x * 100 + f(1) * 10 + f(1.5);", before, ending=".CPP") == 312


@pytest.mark.parametrize(
    "body, line, message",
    [
        ("int *p = 0;\n*p = 1;", 2, "a null pointer was used"),
        ("int a[3], i = 3;\n\na[i] = 1;", 3, "outside of an array"),
        ("int a[3], i = -1;\na[i] = 1;", 2, "outside of an array"),
        ("int i = 0;\nr = 1 / i;", 2, "division by zero"),
    ],
)
def test_a_fault_names_its_line(tmp_path, body, line, message):
    made = program(tmp_path, f"int r; void main() {{ {body} }}")
    with pytest.raises(CError) as found:
        made.run(Session())
    assert (found.value.place.line, found.value.message) == (line, message)


def test_endless_recursion_is_a_fault(tmp_path):
    with pytest.raises(CError, match="the stack overflowed"):
        program(tmp_path, "int f(int n) { return f(n + 1); } void main() { f(0); }").run(Session())


def test_all_errors_are_told_at_once(tmp_path):
    text = 'void main() {\n  x = 1;\n  outtextx(1, 2, "a");\n  circle(1, 2);\n  5 = 6;\n}'
    with pytest.raises(CErrors) as found:
        program(tmp_path, text)
    assert [f"{one.place.line}: {one.message}" for one in found.value.errors] == [
        "2: there is no x",
        "3: there is no outtextx: did you mean outtextxy?",
        "4: circle takes 3 arguments, not 2",
        "5: what stands on the left is no variable",
    ]


def printed(tmp_path, text, ending=".CPP"):
    """What a program prints, by its trace."""
    made = program(tmp_path, text, ending)
    made.run(Session(tmp_path / "trace", "A"))
    lines = (tmp_path / "trace").read_text().splitlines()
    return [line.removeprefix("print ")[1:-1] for line in lines if line.startswith("print")]


def test_objects_are_made_copied_and_destroyed_in_order(tmp_path):
    text = """
        #include <iostream.h>
        class A {
            static int n; int k;
        public:
            static int count() { return n; }
            A() { k = ++n; }
            A(const A &o) { k = o.k * 10; }
            ~A() { cout << '~' << k; }
            friend ostream &operator<<(ostream &o, const A &a);
        };
        int A::n = 4;
        ostream &operator<<(ostream &o, const A &a) { return o << 'A' << a.k; }
        class Two { public: A one, other; };
        void show(A a) { cout << a; }
        void main() {
            A a, *p = new A;
            show(a);
            delete p;
            { A pair[2]; Two two; cout << two.other << A::count(); }
            cout << endl;
        }
    """
    assert printed(tmp_path, text) == ["A50~50~6A1010~10~9~8~7\\n~5"]


def test_a_member_hides_what_is_global_and_a_local_hides_a_member(result):
    before = """
        int p[3]; int f() { return 1; }
        class A {
            int p;
        public:
            A() { p = 5; }
            int f() { return 2; }
            int sum() { p += 10; return p * 10 + f(); }
            int local(int p) { p++; return p * 100 + this->p; }
        };
    """
    assert result("A a; r = a.sum() * 1000L + a.local(1);", before, ending=".CPP") == 152215
    before = "enum { one = 1 }; struct A { int one; A() : one(7) { } int get() { return one; } };"
    assert result("A a; r = a.get() * 10 + one;", before, ending=".CPP") == 71


def test_unions_share_their_bytes(result):
    union = "union number { int i; unsigned char c[2]; };"
    assert result("union number n; n.i = 0x1234; r = n.c[0] * 256 + n.c[1];", union) == 0x3412
    body = "union number n, m; n.i = 5; m = n; m.c[1] = 1; r = m.i * 10 + n.i;"
    assert result(body, union) == 2615


def test_a_function_called_as_one_of_the_library_overloads_it(result):
    before = "int floor(int a, int b) { return a + b; }"
    assert result("r = floor(1, 2) + floor(7.5);", before, ending=".CPP") == 10


def test_a_sum_too_long_is_an_error(tmp_path):
    with pytest.raises(CErrors, match=r"T.C:1:\d+: this is too long for one expression"):
        program(tmp_path, f"void main() {{ int x = 1; x = {'+'.join(['x'] * 5000)}; }}")


def test_brackets_around_a_conversion_are_no_cast(result):
    assert result("double x = 7.5; r = (int(x) % 4) * (int)x;", ending=".CPP") == 21


def test_a_c_file_may_hold_cplusplus(result):
    assert result("r = 3; for (int i = 0; i < 2; i++) { } r += i;", "class A { };") == 5


def test_floats_are_computed_in_32_bits(result):
    declared = "float a = 130, b = 180, t; int d = 180;"
    assert result("t = a / b; r = 120 + t * d;", declared) == 250
    assert result("t = a / b; r = 120 + t * (double) d;", declared) == 249
    assert result("t = 0.1; r = (t == 0.1) * 10 + (t == 0.1f);", declared) == 1


def test_restorecrtmode_behind_closegraph_does_nothing(tmp_path):
    text = """
        #include <graphics.h>
        void main() {
            int gd = DETECT, gm;
            initgraph(&gd, &gm, ""); closegraph(); restorecrtmode();
        }
    """
    program(tmp_path, text).run(Session(tmp_path / "trace", "A"))
    lines = (tmp_path / "trace").read_text().splitlines()
    assert lines[1:] == ["closegraph", "restorecrtmode", "end exit"]
