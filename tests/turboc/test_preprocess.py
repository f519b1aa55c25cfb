"""Text, words and directives of C programs."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bgi.turboc.faults import CError, Place, shown
from bgi.turboc.words.lexer import tokens
from bgi.turboc.words.preprocess import preprocess
from bgi.turboc.words.source import decode


def words(text, beside=None, **defined):
    """What the preprocessor leaves, in one line; and what is wrong."""
    found = preprocess(text, "T.C", {"stdio.h": ""}, (beside or {}).get, defined)
    return " ".join(word.text for word in found.tokens[:-1]), list(map(str, found.errors))


def test_a_file_of_dos_becomes_text():
    assert decode(b"int x;\r\n\xc9\x1argarbage") == "int x;\n╔\n"


def test_words_and_their_places():
    found = list(tokens('a+=b; // c\n  "x\\"y" \'\\n\' 1.5e-3f /* two\nlines */ 0x1FL->*', "T.C"))
    assert [(w.kind, w.text, w.place.line, w.place.column) for w in found] == [
        ("name", "a", 1, 1),
        ("operator", "+=", 1, 2),
        ("name", "b", 1, 4),
        ("operator", ";", 1, 5),
        ("string", '"x\\"y"', 2, 3),
        ("character", "'\\n'", 2, 10),
        ("number", "1.5e-3f", 2, 15),
        ("number", "0x1FL", 3, 10),
        ("operator", "->*", 3, 15),
        ("end", "", 3, 1),
    ]
    assert [w.first for w in found] == [True, *[False] * 3, True, *[False] * 4, True]


def test_a_backslash_joins_lines():
    found = list(tokens("#define A 1 + \\\n 2\nb", "T.C"))
    assert [(w.text, w.place.line, w.first) for w in found[-3:-1]] == [
        ("2", 2, False),
        ("b", 3, True),
    ]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("int a; /* no end", "T.C:1:8: this comment never ends"),
        ('x = "abc\n', 'T.C:1:5: there is no second " in this line'),
        ("a @ b", "T.C:1:3: nothing in C begins with '@'"),
    ],
)
def test_what_is_no_word(text, message):
    assert words(text) == ("", [message])


def test_an_error_is_shown_with_its_line():
    error = CError(Place("T.C", 3, 6), "no")
    error.source = "\tx = @;"
    assert shown(error) == "T.C:3:6: no\n            x = @;\n                ^"


def test_macros():
    assert words("#define N 10\nint a[N];") == ("int a [ 10 ] ;", [])
    assert words("#define SQ(x) ((x)*(x))\nSQ(a + 1) SQ") == (
        "( ( a + 1 ) * ( a + 1 ) ) SQ",
        [],
    )
    assert words('#define S(x) #x\n#define J(a, b) a##b\nS(a  "b") J(x, 1)') == (
        '"a \\"b\\"" x1',
        [],
    )
    assert words("#define A B\n#define B A\nA") == ("A", [])
    assert words("#define F(x) x\nF((1, 2)) F()") == ("( 1 , 2 )", [])
    assert words("__LINE__\n__LINE__ __FILE__") == ('1 2 "T.C"', [])
    assert words("#define A 1\n#undef A\nA", B="2 + 3") == ("A", [])
    assert words("B", B="2 + 3") == ("2 + 3", [])


def test_a_macro_with_too_few_arguments():
    assert words("#define F(a, b) a\nF(1)")[1] == ["T.C:2:1: the macro F takes 2 arguments, not 1"]
    assert words("#define F(a) a\nF(1")[1] == ["T.C:2:1: the arguments of the macro F do not end"]


@pytest.mark.parametrize(
    ("condition", "holds"),
    [
        ("1 + 2 * 3 == 7", True),
        ("defined(N) && !defined M", True),
        ("N > 9 ? 0 : 1", False),
        ("UNKNOWN", False),
        ("(1 << 4) % 5 == 1 && -7 / 2 < 0", True),
        ("'A' == 65 || ~0 == -1", True),
    ],
)
def test_conditions(condition, holds):
    text, errors = words(f"#define N 10\n#if {condition}\nyes\n#else\nno\n#endif")
    assert (text, errors) == ("yes" if holds else "no", [])


def test_parts_of_conditions():
    text = "#ifdef A\na\n#elif 1\nb\n#elif 1\nc\n#else\nd\n#endif\n#ifndef A\ne\n#endif"
    assert words(text) == ("b e", [])
    assert words("#if 0\n#if 1\na\n#else\nb\n#endif\n#endif\nc") == ("c", [])


def test_what_is_left_out_need_be_no_words():
    assert words("#if 0\nit's @ \"quoted\n#endif\n#ifdef A\n#error don't\n#endif\nx") == ("x", [])


def test_files_beside_the_program():
    beside = {"point.h": '#include "deep.h"\nint p;', "deep.h": "int d;"}
    assert words('#include "point.h"\n#include <stdio.h>\nx', beside) == ("int d ; int p ; x", [])
    assert words('#include "C:\\LIB\\POINT.H"', {"POINT.H": "int p;"}) == ("int p ;", [])
    found = preprocess("#include <SYS\\STDIO.H>", "T.C", {"stdio.h": ""}, {}.get, {})
    assert found.headers == {"stdio.h"}


def test_what_directives_can_be_wrong():
    assert words("#include <none.h>")[1] == ["T.C:1:2: there is no file none.h"]
    assert words('#include "a.h"', {"a.h": '#include "a.h"'})[1] == [
        "a.h:1:2: a.h is included too deeply: does it include itself?"
    ]
    assert words("#endif\n#frob\n#error stop\n#if\n")[1] == [
        "T.C:1:2: #endif without an #if",
        "T.C:2:2: there is no directive #frob",
        "T.C:3:2: #error stop",
        "T.C:4:2: #if of what?",
    ]


@given(st.text("ab#()\"',\\ \n/*1<>definclu", max_size=60))
def test_any_text_is_read_or_refused(text):
    preprocess(text, "T.C", {"stdio.h": ""}, {}.get, {"a": "b(1)"})
