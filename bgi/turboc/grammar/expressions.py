"""Expressions, from the comma down to names and numbers.

Each level of the grammar is a method; the levels of binary operators are a table
(precedence climbing).
"""

from __future__ import annotations

from bgi.turboc.grammar import literals
from bgi.turboc.grammar.nodes import (
    Assign,
    Binary,
    Braces,
    Call,
    Cast,
    CharLit,
    Comma,
    Conditional,
    Construct,
    Delete,
    Expr,
    IncDec,
    Index,
    IntLit,
    Logical,
    Member,
    Name,
    New,
    SizeofExpr,
    SizeofType,
    StrLit,
    This,
    TypeName,
    Unary,
)
from bgi.turboc.grammar.stream import Stream

_LEVELS = {
    operator: level
    for level, operators in enumerate(
        ("||", "&&", "|", "^", "&", "== !=", "< > <= >=", "<< >>", "+ -", "* / %")
    )
    for operator in operators.split()
}
_ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
MOST_PARTS = 1000
"""Of one expression in a row: terms, or calls and indices."""

_SIGNS = {"-", "+", "!", "~", "*", "&"}


class Expressions(Stream):
    """What a value is written as."""

    cplusplus: bool

    # Types, which another part of the grammar knows

    def starts_type(self, ahead: int = 0) -> bool:
        """Whether a type begins with the word so many after the next."""
        raise NotImplementedError

    def type_name(self) -> TypeName:
        """A type without a name in it: `char *`, `int (*)(int)`."""
        raise NotImplementedError

    def new_type(self) -> TypeName:
        """The type behind `new`: without brackets."""
        raise NotImplementedError

    # Expressions

    def expression(self) -> Expr:
        """`a, b, c`"""
        place = self.place
        items = [self.assignment()]
        while self.accept(","):
            items.append(self.assignment())
        return items[0] if len(items) == 1 else Comma(place, tuple(items))

    def assignment(self) -> Expr:
        """`target = value`"""
        with self.deeper():
            target = self.conditional()
            operator = self.word
            if operator.text not in _ASSIGNMENTS:
                return target
            self.take()
            return Assign(operator.place, operator.text, target, self.assignment())

    def conditional(self) -> Expr:
        """`condition ? yes : no`"""
        condition = self.binary(0)
        question = self.accept("?")
        if question is None:
            return condition
        yes = self.expression()
        self.expect(":")
        return Conditional(question.place, condition, yes, self.assignment())

    def binary(self, lowest: int) -> Expr:
        """Operators between operands, of a level or above; those of one level from the left."""
        left = self.cast()
        terms = 0
        while (level := _LEVELS.get(self.word.text, -1)) >= lowest:
            operator = self.take()
            terms = self._one_more(terms)
            right = self.binary(level + 1)
            kind = Logical if level < 2 else Binary
            left = kind(operator.place, operator.text, left, right)
        return left

    def _one_more(self, count: int) -> int:
        """Count the parts of a value; CError for too many."""
        if count >= MOST_PARTS:
            raise self.error("this is too long for one expression")
        return count + 1

    def cast(self) -> Expr:
        """`(type) operand`"""
        converts = self.cplusplus and self.ahead(2).text == "(" and self.ahead(3).text != "*"
        if not (self.at("(") and self.starts_type(1)) or converts:  # as in (int(x) + 1)
            return self.unary()
        with self.deeper():
            place = self.take().place
            type_ = self.type_name()
            self.expect(")")
            return Cast(place, type_, self.cast())

    def unary(self) -> Expr:
        """A sign, `++`, `sizeof`, `new` or `delete` before an operand."""
        word = self.word
        with self.deeper():
            if word.text in _SIGNS:
                self.take()
                return Unary(word.place, word.text, self.cast())
            if self.accept("++", "--"):
                return IncDec(word.place, word.text, self.unary(), postfix=False)
            if self.accept("sizeof"):
                return self._sizeof()
            if self.cplusplus and self.at("::") and self.ahead(1).text in ("new", "delete"):
                self.take()
            if self.cplusplus and self.accept("new"):
                return self._new()
            if self.cplusplus and self.accept("delete"):
                array = self.accept("[") is not None
                if array and not self.at("]"):
                    self.expression()
                if array:
                    self.expect("]")
                return Delete(word.place, self.cast(), array)
            return self.postfix()

    def _sizeof(self) -> Expr:
        place = self.place
        if self.at("(") and self.starts_type(1):
            self.take()
            type_ = self.type_name()
            self.expect(")")
            return SizeofType(place, type_)
        return SizeofExpr(place, self.unary())

    def _new(self) -> Expr:
        place = self.place
        bracketed = self.at("(") and self.starts_type(1) and self.take()
        type_ = self.type_name() if bracketed else self.new_type()
        if bracketed:
            self.expect(")")
        if self.accept("["):
            count = self.expression()
            self.expect("]")
            return New(place, type_, (), count)
        arguments = self._arguments() if self.accept("(") else ()
        return New(place, type_, arguments)

    def postfix(self) -> Expr:
        """Calls, indices, members and `++` behind a value."""
        value = self.primary()
        parts = -1
        while True:
            word = self.word
            parts = self._one_more(parts)
            if self.accept("("):
                value = Call(word.place, value, self._arguments())
            elif self.accept("["):
                value = Index(word.place, value, self.expression())
                self.expect("]")
            elif self.accept(".", "->"):
                value = self._member(value, word.text == "->")
            elif self.accept("++", "--"):
                value = IncDec(word.place, word.text, value, postfix=True)
            else:
                return value

    def _member(self, base: Expr, arrow: bool) -> Expr:
        place = self.place
        destructor = "~" if self.accept("~") else ""
        name, scope = self.name().text, ""
        if self.cplusplus and self.accept("::"):
            scope, name = name, self.name().text
        return Member(place, base, destructor + name, arrow, scope)

    def _arguments(self) -> tuple[Expr, ...]:
        """What stands between the brackets of a call; the first has been taken."""
        given: list[Expr] = []
        while not self.at(")"):
            given.append(self.assignment())
            if not self.accept(","):
                break
        self.expect(")")
        return tuple(given)

    def primary(self) -> Expr:
        """A name, number, character, string, or an expression in brackets."""
        word = self.word
        if word.kind == "number":
            return literals.number(self.take().text, word.place)
        if word.kind == "character":
            return CharLit(word.place, literals.character(self.take().text))
        if word.kind == "string":
            text = b""
            while self.word.kind == "string":
                text += literals.string(self.take().text)
            return StrLit(word.place, text)
        if self.accept("("):
            value = self.expression()
            self.expect(")")
            return value
        if self.cplusplus and word.text in ("true", "false", "this") and word.kind == "name":
            self.take()
            return (
                This(word.place)
                if word.text == "this"
                else IntLit(word.place, int(word.text == "true"))
            )
        if word.kind == "name" and self.starts_type() and self._makes():
            return self._construct()
        return self.qualified_name()

    def _makes(self) -> bool:
        """Whether a type here makes a value, and is no name of a variable as well."""
        return self.word.text in RESERVED or self.ahead(1).text == "("

    def _construct(self) -> Expr:
        """`int(x)`, `Point(1, 2)`."""
        place = self.place
        type_ = self.new_type()
        self.expect("(")
        return Construct(place, type_, self._arguments())

    def qualified_name(self) -> Name:
        """`name`, `Class::name`, `::name`, `operator+`."""
        place, scope = self.place, ""
        if self.cplusplus and self.accept("::"):
            scope = "::"
        if self.word.kind != "name" or self.word.text in RESERVED:
            raise self.error("a value expected")
        name = self.take().text
        while self.cplusplus and self.at("::"):
            self.take()
            scope = name
            name = "~" + self.name().text if self.accept("~") else self.name().text
        if self.cplusplus and name == "operator":
            name += self.operator_name()
        return Name(place, name, scope)

    def operator_name(self) -> str:
        """What stands behind `operator`."""
        if self.accept("("):
            self.expect(")")
            return "()"
        if self.accept("["):
            self.expect("]")
            return "[]"
        if self.at("new", "delete"):
            return " " + self.take().text
        if self.word.kind != "operator":
            raise self.error("an operator expected")
        return self.take().text

    def initializer(self) -> Expr:
        """A value behind `=`, or several in braces."""
        if not self.at("{"):
            return self.assignment()
        with self.deeper():
            place = self.take().place
            items: list[Expr] = []
            while not self.at("}"):
                items.append(self.initializer())
                if not self.accept(","):
                    break
            self.expect("}")
            return Braces(place, tuple(items))


_RESERVED = """
    break case char const continue default do double else enum extern float for goto if int long
    return short signed sizeof static struct switch typedef union unsigned void while
"""
RESERVED = frozenset(_RESERVED.split())
"""C's own words, which are no names."""
