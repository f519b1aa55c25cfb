"""What is special about structs and classes, and functions with their bodies."""

from __future__ import annotations

from bgi.turboc.faults import Place
from bgi.turboc.grammar.declarations import Named_, Specifiers
from bgi.turboc.grammar.nodes import Expr, FunctionPart, Parameter, TypeName, Words
from bgi.turboc.grammar.statements import Statements
from bgi.turboc.grammar.tree import Block, Declaration, Declarator, FunctionDef, Member_, StructDef

_ACCESS = ("public", "private", "protected")


class Classes(Statements):
    """Structs with their members, and functions."""

    def struct_body(self, place: Place, word: str, tag: str) -> StructDef:
        """`: public Base { members }` of a struct, union or class."""
        bases: list[str] = []
        if self.accept(":"):
            while True:
                while self.accept(*_ACCESS, "virtual"):
                    pass
                bases.append(self.name().text)
                if not self.accept(","):
                    break
        members: list[Member_] = []
        virtuals: set[str] = set()
        pure: set[str] = set()
        self.expect("{")
        with self.deeper():
            while not self.at("}") and self.word.kind != "end":
                if self.cplusplus and self.at(*_ACCESS) and self.ahead(1).text == ":":
                    self.take()
                    self.take()
                elif not self.accept(";"):
                    members += self._member_of(tag, virtuals, pure)
        self.expect("}")
        kind = "struct" if word == "class" else word
        return StructDef(
            place, kind, tag, tuple(bases), tuple(members), frozenset(virtuals), frozenset(pure)
        )

    def _member_of(self, tag: str, virtuals: set[str], pure: set[str]) -> list[Member_]:
        """The members that one declaration declares, and the types that it defines."""
        if self.at("operator") and self.starts_type(1):
            return [self._conversion(tag)]
        said = self._specifiers_of_member(tag)
        if said.storage == "friend":
            self.skip_statement()
            return []
        made: list[Member_] = list(said.defined)
        if self.accept(";"):
            return made
        found = self.declarator(abstract=True)
        if found.parts and isinstance(found.parts[0], FunctionPart):
            if said.virtual:
                virtuals.add(found.name)
            if self.at("{", ":"):
                return [*made, self.function(said, found, tag)]
            if self.accept("="):
                self.take()
                pure.add(found.name)
        names = [self._plain(said, found)]
        while self.accept(","):
            names.append(self._plain(said, self.declarator(abstract=True)))
        self.expect(";")
        return [*made, Declaration(said.place, tuple(names))]

    def _conversion(self, tag: str) -> Member_:
        """`operator int()`: a method that says what an object is as another type."""
        place = self.take().place
        type_ = self.new_type()
        name = f"operator {self.converted_to(type_)}"
        self.expect("(")
        part, _ = self.parameters()
        self.accept("const")
        said = Specifiers(place, type_.base)
        found = Named_(place, name, (part, *type_.parts))
        if self.at("{"):
            return self.function(said, found, tag)
        declared = Declaration(place, (self._plain(said, found),))
        self.expect(";")
        return declared

    def _specifiers_of_member(self, tag: str) -> Specifiers:
        """Those of a member; a constructor and a destructor have none."""
        place, virtual = self.place, False
        while self.at("virtual") and self.ahead(1).text == "~":
            self.take()
            virtual = True
        if self.at("~") or (self.at(tag) and self.ahead(1).text == "("):
            return Specifiers(place, Words(("void",)), virtual=virtual)
        return self.specifiers()

    def _plain(self, said: Specifiers, found: Named_) -> Declarator:
        """A member, behind which the width of a bit field may stand."""
        type_ = TypeName(said.place, said.base, found.parts)
        width = self.conditional() if self.accept(":") else None
        return Declarator(
            found.place, found.name, type_, storage=said.storage, const=said.const, bits=width
        )

    # Functions

    def function(self, said: Specifiers, found: Named_, cls: str = "") -> FunctionDef:
        """A function with its body."""
        type_ = TypeName(said.place, said.base, found.parts)
        if found.old or not self.at("{", ":"):
            type_ = self._old_style(type_, found.old)
        initializers: list[tuple[str, tuple[Expr, ...]]] = []
        if self.accept(":"):
            while True:
                name = self.name().text
                self.expect("(")
                initializers.append((name, self._arguments()))
                if not self.accept(","):
                    break
        with self.inside(_parameters(type_)):
            body: Block = self.block()
        storage = said.storage if said.storage != "extern" else ""
        owner = found.scope or cls
        return FunctionDef(
            found.place, found.name, type_, body, storage, owner, said.virtual, tuple(initializers)
        )

    def _old_style(self, type_: TypeName, names: tuple[str, ...]) -> TypeName:
        """The type of a function whose parameters are declared before its body."""
        types: dict[str, TypeName] = {}
        while not self.at("{") and self.starts_type():
            for one in self.declaration(self.specifiers()).names:
                types[one.name] = one.type
        place = type_.place
        parameters = tuple(
            Parameter(place, name, types.get(name, TypeName(place, Words(("int",)))))
            for name in names
        )
        return TypeName(place, type_.base, (FunctionPart(parameters), *type_.parts[1:]))


def _parameters(type_: TypeName) -> list[str]:
    """The names of a function's parameters."""
    part = type_.parts[0] if type_.parts else None
    return [one.name for one in part.parameters] if isinstance(part, FunctionPart) else []
