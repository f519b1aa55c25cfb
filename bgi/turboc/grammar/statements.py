"""Statements."""

from __future__ import annotations

from bgi.turboc.faults import MOST_ERRORS, CError, Place
from bgi.turboc.grammar.declarations import Declarations
from bgi.turboc.grammar.nodes import Expr
from bgi.turboc.grammar.tree import (
    Asm,
    Block,
    Break,
    Case,
    Continue,
    DoWhile,
    ExprStmt,
    For,
    Goto,
    If,
    Label,
    Return,
    Stmt,
    Switch,
    While,
)


class Statements(Declarations):
    """What a program does."""

    errors: list[CError]

    def block(self) -> Block:
        """`{ ... }`"""
        place = self.expect("{").place
        with self.deeper(), self.inside():
            items: list[Stmt] = []
            while not self.at("}") and self.word.kind != "end":
                items += self.statement_or_error()
            self.expect("}")
            return Block(place, tuple(items))

    def statement_or_error(self) -> list[Stmt]:
        """A statement; after an error the next one, which is none."""
        before = self.word
        try:
            return self.statements()
        except CError as error:
            self.errors.append(error)
            if len(self.errors) >= MOST_ERRORS:
                raise
            if self.word is before:
                self.take()
            self.skip_statement()
            return []

    def statements(self) -> list[Stmt]:
        """A statement; a declaration may be several: what it defines, and the names."""
        if self.starts_declaration():
            said = self.specifiers()
            names = self.declaration(said)
            return [*said.defined, *([names] if names.names else [])]
        return [self.statement()]

    def statement(self) -> Stmt:
        """One statement that is no declaration."""
        word = self.word
        with self.deeper():
            if word.kind == "name" and (reader := _READERS.get(word.text)):
                return reader(self)
            if self.at("{"):
                return self.block()
            if self.accept(";"):
                return ExprStmt(word.place, None)
            if word.kind == "name" and self.ahead(1).text == ":" and word.text not in _READERS:
                self.take()
                self.take()
                return self._then(Label(word.place, word.text))
            value = self.expression()
            self.expect(";")
            return ExprStmt(word.place, value)

    def _then(self, label: Label | Case) -> Stmt:
        """A label, and the statement that it stands before, if it is not the last."""
        if self.at("}"):
            return label
        return Block(label.place, (label, *self.statements()))

    def _body(self) -> Stmt:
        """The statement that `if` and loops have: where C++ allows it, a declaration."""
        found = self.statements()
        return found[0] if len(found) == 1 else Block(found[0].place, tuple(found))

    def _condition(self) -> Expr:
        self.expect("(")
        condition = self.expression()
        self.expect(")")
        return condition

    def _if(self) -> Stmt:
        chain: list[tuple[Place, Expr, Stmt]] = []
        no: Stmt | None = None
        while no is None:  # else if ... else if ... is a chain, however long
            place = self.take().place
            chain.append((place, self._condition(), self._body()))
            if not self.accept("else"):
                break
            if not self.at("if"):
                no = self._body()
        for place, condition, yes in reversed(chain):
            no = If(place, condition, yes, no)
        assert no is not None
        return no

    def _while(self) -> Stmt:
        place = self.take().place
        return While(place, self._condition(), self._body())

    def _do(self) -> Stmt:
        place = self.take().place
        body = self._body()
        self.expect("while")
        condition = self._condition()
        self.expect(";")
        return DoWhile(place, body, condition)

    def _for(self) -> Stmt:
        place = self.take().place
        self.expect("(")
        initial: Stmt | None = None
        if self.starts_declaration():
            initial = self.declaration(self.specifiers())
        else:
            first = self.place
            value = None if self.at(";") else self.expression()
            self.expect(";")
            initial = None if value is None else ExprStmt(first, value)
        condition = None if self.at(";") else self.expression()
        self.expect(";")
        step = None if self.at(")") else self.expression()
        self.expect(")")
        return For(place, initial, condition, step, self._body())

    def _switch(self) -> Stmt:
        place = self.take().place
        return Switch(place, self._condition(), self._body())

    def _case(self) -> Stmt:
        place = self.take().place
        value = self.conditional()
        self.expect(":")
        return self._then(Case(place, value))

    def _default(self) -> Stmt:
        place = self.take().place
        self.expect(":")
        return self._then(Case(place, None))

    def _break(self) -> Stmt:
        place = self.take().place
        self.expect(";")
        return Break(place)

    def _continue(self) -> Stmt:
        place = self.take().place
        self.expect(";")
        return Continue(place)

    def _return(self) -> Stmt:
        place = self.take().place
        value = None if self.at(";") else self.expression()
        self.expect(";")
        return Return(place, value)

    def _goto(self) -> Stmt:
        place = self.take().place
        label = self.name().text
        self.expect(";")
        return Goto(place, label)

    def _asm(self) -> Stmt:
        """`asm mov ax, 3`, up to the end of the line, or `asm { ... }`."""
        place = self.take().place
        words: list[str] = []
        if self.accept("{"):
            while not self.at("}") and self.word.kind != "end":
                words.append(self.take().text)
            self.expect("}")
        else:
            while not self.word.first and not self.at(";", "}"):
                words.append(self.take().text)
        self.accept(";")
        return Asm(place, " ".join(words))


_READERS = {
    "if": Statements._if,
    "while": Statements._while,
    "do": Statements._do,
    "for": Statements._for,
    "switch": Statements._switch,
    "case": Statements._case,
    "default": Statements._default,
    "break": Statements._break,
    "continue": Statements._continue,
    "return": Statements._return,
    "goto": Statements._goto,
    "asm": Statements._asm,
    "_asm": Statements._asm,
    "__asm": Statements._asm,
}
