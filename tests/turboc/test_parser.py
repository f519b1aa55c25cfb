"""The grammar: what programs become as trees, and what is said of those that are none."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bgi.turboc.faults import CErrors
from bgi.turboc.grammar.parser import parse
from bgi.turboc.grammar.tree import FunctionDef
from bgi.turboc.words.preprocess import preprocess
from tests.turboc.sketch import HEADERS, TYPES, body, declared, sketch, tree, value


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a + b * c - d", "(- (+ a (* b c)) d)"),
        (
            "a << 1 + 2 < b == c & d ^ e | f && g || h",
            "(|| (&& (| (^ (& (== (< (<< a (+ 1 2)) b) c) d) e) f) g) h)",
        ),
        ("a = b += c ? d : e ? f : g", "(= a (+= b (Conditional c d (Conditional e f g))))"),
        ("-a * !b, ~c", "(Comma (* (- a) (! b)) (~ c))"),
        ("*p++ + ++*q", "(+ (* (IncDec ++ p True)) (IncDec ++ (* q) False))"),
        ("&a[i].x->y", "(& (Member (Member (Index a i) x False) y True))"),
        ("(T) x + (int *) p", "(+ (Cast <T> x) (Cast <pointer to int> p))"),
        (
            "sizeof(int) + sizeof x + sizeof(x[0])",
            "(+ (+ (SizeofType <int>) (SizeofExpr x)) (SizeofExpr (Index x 0)))",
        ),
        ("f(a, (b, c))(d)", "(Call (Call f a (Comma b c)) d)"),
        ("'a' + '\\n' + '\\xff' + 'ab'", "(+ (+ (+ '97' '10') '-1') '25185')"),
        ('"a" "b\\0"', "'ab\\x00'"),
        ("0x1F + 010 + 7L + 3U + 1.5 + 2.f", "(+ (+ (+ (+ (+ 31 8) 7l) 3u) 1.5) 2.0f)"),
        (
            "(unsigned long (*)(int)) p",
            "(Cast <pointer to function(int) returning long unsigned> p)",
        ),
    ],
)
def test_values(text, expected):
    assert value(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("new int[5]", "(New <int> 5)"),
        ("new T(3) == 0", "(== (New <T> 3 -) 0)"),
        ("T(3) + int(x)", "(+ (Construct <T> 3) (Construct <int> x))"),
        ('cout << a << "b"', "(<< (<< cout a) 'b')"),
        ("A::b + ::c", "(+ A::b ::::c)"),
        ("true ? this : p->A::f()", "(Conditional 1 (This) (Call (Member p f True A)))"),
    ],
)
def test_values_of_cplusplus(text, expected):
    assert value(text, cplusplus=True) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("if (a) b; else c;", "(If a b; c;)"),
        ("while (a) ; do { b; } while (c);", "(While a -;) (DoWhile (Block b;) c)"),
        (
            "for (i = 0, j = 1; ; i++) { }",
            "(For (Comma (= i 0) (= j 1)); - (IncDec ++ i True) (Block))",
        ),
        (
            "switch (a) { case 1: case 2: b; break; default: c; }",
            "(Switch a (Block (Block (Case 1) (Block (Case 2) b;)) (Break) (Block (Case -) c;)))",
        ),
        ("again: goto again; return;", "(Block (Label again) (Goto again)) (Return -)"),
        ("T x; x * y;", "(Declaration (Declarator x <T> - - False -)) (* x y);"),
        ("asm mov ax, 3", "(Asm mov ax , 3)"),
        ("asm { int 10h; }", "(Asm int 10 h ;)"),
    ],
)
def test_statements(text, expected):
    assert body(text) == expected


@pytest.mark.parametrize(
    ("text", "name", "expected"),
    [
        ("int *a[3], (*b)[4];", "a", "array of 3 pointer to int"),
        ("int *a[3], (*b)[4];", "b", "pointer to array of 4 int"),
        (
            "char *(*f(int x))(double, ...);",
            "f",
            "function(int) returning pointer to function(double, ...) returning pointer to char",
        ),
        ("unsigned far *screen;", "screen", "pointer to unsigned"),
        ("void interrupt (*old)();", "old", "pointer to function(...) returning void"),
        ("main() { }", "main", "function(...) returning int"),
        ("static x = 3;", "x", "int"),
        ("f(a, b) int a; char *b; { }", "f", "function(int, pointer to char) returning int"),
        ("struct p { int x; } a, *b;", "b", "pointer to struct p"),
        ("enum { A, B = 4 } e;", "e", "enum 1 enum"),
        ("typedef struct { int x; } P; P p[2];", "p", "array of 2 P"),
        ("union REGS in;", "in", "union REGS"),
    ],
)
def test_declarations(text, name, expected):
    assert declared(text)[name] == expected


def test_a_class():
    program = tree(
        """
        class Shape : public Base {
            int x, y;
        public:
            Shape(int a = 1) : Base(a), x(0) { y = a; }
            virtual ~Shape();
            virtual void draw() = 0;
            Shape operator+(const Shape &other) { return *this; }
            static int count;
            friend ostream &operator<<(ostream &, Shape &);
        };
        Shape::~Shape() { }
        Shape s(3), *p;
        void g(Shape &r) { Shape local(1, 2); int n(5); }
        """,
        cplusplus=True,
    )
    shape, destructor, objects, function = program.items
    assert (shape.kind, shape.tag, shape.bases) == ("struct", "Shape", ("Base",))
    assert shape.virtuals == {"~Shape", "draw"} and shape.pure == {"draw"}
    made, plus = shape.members[1], shape.members[4]
    assert [(name, sketch(given)) for name, given in made.initializers] == [
        ("Base", "a"),
        ("x", "0"),
    ]
    assert (plus.name, plus.cls) == ("operator+", "Shape")
    assert (destructor.name, destructor.cls) == ("~Shape", "Shape")
    assert [sketch(one.arguments) for one in objects.names] == ["3", "-"]
    local, number = (one.names[0] for one in function.body.items)
    assert (sketch(local.arguments), sketch(number.arguments)) == ("1 2", "5")


def test_a_variable_of_the_name_of_a_type_hides_it():
    assert (
        body("int T; T = 3; T * 2;")
        == "(Declaration (Declarator T <int> - - False -)) (= T 3); (* T 2);"
    )


@pytest.mark.parametrize("cplusplus", [False, True])
def test_it_hides_it_in_its_block_only(cplusplus):
    text = "typedef int T; int f(int T) { if (T > 3) T += 2; return T; } T x; "
    text += "int g() { { T T; T++; } { T y; } return (T) x; }"
    first, second = (one for one in tree(text, cplusplus).items if isinstance(one, FunctionDef))
    assert sketch(first.body) == "(Block (If (> T 3) (+= T 2); -) (Return T))"
    assert sketch(second.body) == (
        "(Block (Block (Declaration (Declarator T <T> - - False -)) (IncDec ++ T True);)"
        " (Block (Declaration (Declarator y <T> - - False -))) (Return (Cast <T> x)))"
    )


def test_a_member_may_have_the_name_of_a_type():
    text = "typedef int T; struct A { int T; int get() { return T > 3 ? T : -T; } };"
    method = tree(text, cplusplus=True).items[1].members[1]
    assert sketch(method.body) == "(Block (Return (Conditional (> T 3) T (- T))))"


@pytest.mark.parametrize(
    ("text", "errors"),
    [
        ("int main() { x = 1 y = 2; }", ["T.C:1:19: a ';' is missing before 'y'"]),
        ("int f( { }", ["T.C:1:8: the type of a parameter expected, not '{'"]),
        ("int a[3;", ["T.C:1:8: a ']' is missing before ';'"]),
        ("float long char x;", ["T.C:1:1: char float long is no type"]),
        (
            "void f() { line(1, ; } void g() { if a) ; }",
            ["T.C:1:20: a value expected, not ';'", "T.C:1:38: '(' expected, not 'a'"],
        ),
        ("int x = 99999999999;", ["T.C:1:9: 99999999999 does not fit into a long"]),
        ("void f() {", ["T.C:1:11: a '}' is missing before the end of the file"]),
        ("(" * 1000, ["T.C:1:1: a declaration expected, not '('"]),
    ],
)
def test_what_is_wrong_and_where(text, errors):
    with pytest.raises(CErrors) as caught:
        tree(text)
    assert list(map(str, caught.value.errors))[: len(errors)] == errors


@pytest.mark.parametrize(
    "text", ["(", "{", "-", "a[", "f(", "if (1) ", "int (*", "struct {", "!", "a ? "]
)
def test_what_is_nested_too_deeply_is_refused(text):
    with pytest.raises(CErrors) as caught:
        tree("int f() { x = " + text * 100_000)
    assert any("nested too deeply" in str(e) or "expected" in str(e) for e in caught.value.errors)


PROGRAM = """
#include <graphics.h>
typedef struct point { int x, y; } POINT;
POINT p[10] = {{1, 2}, {3}};
int f(int a, char *s) { switch (a) { case 1: return *s++; default: break; } return sizeof(POINT); }
void main() { int gd = DETECT, gm; initgraph(&gd, &gm, "c:\\\\tc\\\\bgi");
for (int i = 0; i < 10; i++) { p[i].x = i << 2; do line(0, 0, p[i].x, 'a'); while (0); }
again: if (kbhit()) goto again; else getch(); closegraph(); }
"""


def read(text, cplusplus):
    found = preprocess(text, "T.C", HEADERS, {}.get, {})
    try:
        parse(found.tokens, TYPES, cplusplus)
    except CErrors as caught:
        assert 0 < len(caught.errors) <= 20


@settings(max_examples=200, deadline=None)
@given(st.data())
def test_damaged_programs_are_read_or_refused(data):
    text = PROGRAM
    for _ in range(data.draw(st.integers(1, 5))):
        start = data.draw(st.integers(0, len(text)))
        end = data.draw(st.integers(start, min(start + 9, len(text))))
        text = text[:start] + data.draw(st.text(max_size=4)) + text[end:]
    read(text, data.draw(st.booleans()))


WORDS = "int x ( ) { } [ ] ; , = * & class : :: ~ operator + 1 'a' \"s\" if else for case new T"


@settings(max_examples=100, deadline=None)
@given(st.lists(st.sampled_from(WORDS.split()), max_size=40), st.booleans())
def test_words_in_any_order_are_read_or_refused(words, cplusplus):
    read(" ".join(words), cplusplus)
