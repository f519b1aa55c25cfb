"""The types of a whole program: everything that is wrong with it is told at once."""

from __future__ import annotations

from bgi.turboc.checker.checkactions import Actions, ends, is_made
from bgi.turboc.checker.conversions import converted
from bgi.turboc.checker.headers import Headers
from bgi.turboc.checker.scopes import Scope, python_name
from bgi.turboc.checker.typed import (
    Act,
    Compute,
    Define,
    Field,
    Itself,
    MethodCall,
    Routine,
    Store,
    TypedProgram,
    Value,
)
from bgi.turboc.checker.types import (
    CHAR,
    UCHAR,
    VOID,
    ArrayType,
    FunctionType,
    IntType,
    ReferenceType,
    StructType,
    Symbol,
    Type,
    described,
    innermost,
    is_number,
)
from bgi.turboc.faults import MOST_ERRORS, NOWHERE, CError, CErrors
from bgi.turboc.grammar import nodes, tree


class Checker(Actions):
    """A whole program."""

    def __init__(self, headers: Headers, cplusplus: bool) -> None:
        super().__init__(headers, cplusplus)
        self.statics: list[Define] = []
        self.routines: list[Routine] = []
        self.waiting: list[tuple[tree.FunctionDef, Symbol, StructType | None]] = []
        """Functions whose bodies are still to be looked at."""
        self.result: Type = VOID
        self.variables: list[Symbol] = []
        self.jumps, self.labels = [], set()
        self.deep, self.around = [], []

    def program(self, program: tree.Program) -> TypedProgram:
        """The typed tree; CErrors if something is wrong."""
        for item in program.items:
            self._guarded(self._top, item)
        self._give_way()
        for node, symbol, cls in self.waiting:
            self._guarded(self._body, node, symbol, cls)
        main = [one for one in self.top.names.get("main", []) if one.defined]
        if not main and not self.errors:
            self.errors.append(CError(NOWHERE, "there is no main() in this program"))
        self._look_for_bodies()
        if self.errors:
            kept = sorted(self.errors, key=lambda error: error.place)
            raise CErrors(kept[:MOST_ERRORS])
        return TypedProgram(self.structs, self.statics, self.routines, main[0])

    def _guarded(self, action: object, *given: object) -> None:
        try:
            action(*given)  # type: ignore[operator]
        except CError as error:
            self.errors.append(error)
            self.scope = self.top

    def _look_for_bodies(self) -> None:
        """A function that is declared and called, and defined nowhere, is an error."""
        found = [one for same in self.top.names.values() for one in same if one.kind == "function"]
        for cls in self.structs:
            named = cls.methods.items()
            found += [one for name, same in named if name not in cls.pure for one in same]
        for one in found:
            if not one.defined and one.written:
                self.errors.append(CError(one.place, f"{one.name}() has no body"))

    def _give_way(self) -> None:
        """A function of the library may be declared once more: the library's is meant."""
        for name, found in list(self.top.names.items()):
            declared = all(one.kind == "function" and not one.defined for one in found)
            library = self.headers.symbol(name)
            if declared and library is not None and library.kind == "library":
                del self.top.names[name]

    def _top(self, node: tree.Top) -> None:
        match node:
            case tree.FunctionDef():
                self._function(node)
            case tree.Declaration():
                for name in node.names:
                    self._guarded(self._global, name)
            case tree.StructDef():
                self.define_struct(node)
            case tree.EnumDef():
                self.define_enum(node)
            case tree.Asm():
                self.act(node)

    def _global(self, node: tree.Declarator) -> None:
        """A variable of the whole program, a typedef or a prototype."""
        type_ = self.type(node.type)
        if node.storage == "typedef":
            self.declare_type(node.name, type_)
            return
        if isinstance(type_, FunctionType):
            self.prototype(node, type_)
            return
        if "::" in node.name:
            self._static_member(node)
            return
        if type_ == VOID:
            raise CError(node.place, f"{node.name} cannot be void")
        name = node.name
        before = self.top.names.get(name, [])
        if node.storage == "extern" and before:
            return
        made = Symbol(name, type_, node.place, "global")
        if before and before[0].kind == "global":
            made = before[0]  # declared again
            if isinstance(made.type, ArrayType) and not made.type.count:
                made.type = type_
        else:
            self.declare(made)
        if not self._is_constant(node, made):
            if node.storage == "extern":
                made.type = type_
            value = self.initial(node, made) if node.storage != "extern" else None
            self.statics = [one for one in self.statics if one.symbol is not made or value is None]
            if all(one.symbol is not made for one in self.statics):
                self.statics.append(Define(node.place, made, value))

    def _static_member(self, node: tree.Declarator) -> None:
        """`int Class::name = 0;`: the value of a static member."""
        owner, _, name = node.name.rpartition("::")
        cls = self.named_type(owner, node.place)
        symbol = cls.static(name) if isinstance(cls, StructType) else None
        if symbol is None:
            raise CError(node.place, f"{owner} has no static member {name}")
        for defined in self.statics:
            if defined.symbol is symbol:
                defined.value = self.initial(node, symbol)

    # Functions

    def prototype(self, node: tree.Declarator, type_: FunctionType) -> None:
        """A function that is declared, and defined somewhere else."""
        parts = node.type.parts
        self._known(node.name, type_, parts, node)

    def _known(
        self,
        name: str,
        type_: FunctionType,
        parts: tuple[nodes.Part, ...],
        node: tree.Declarator | tree.FunctionDef,
    ) -> Symbol:
        """The symbol of a function: the one that was declared, or another that is overloaded."""
        names = self.top.names
        found = [one for one in names.get(name, []) if one.kind == "function"]
        for one in found:
            if not self.cplusplus or one.type == type_ or name == "main":
                self._take_defaults(one, parts)
                if isinstance(node, tree.FunctionDef) or not isinstance(one.type, FunctionType):
                    one.type = type_
                return one
        made = Symbol(name, type_, node.place, "function")
        self._take_defaults(made, parts)
        names[name] = [*found, made]
        return made

    def _take_defaults(self, symbol: Symbol, parts: tuple[nodes.Part, ...]) -> None:
        part = parts[0] if parts else None
        if not isinstance(part, nodes.FunctionPart) or symbol.defaults:
            return
        given = [one.default for one in part.parameters]
        if any(one is not None for one in given):
            values = (None if one is None else self.value(one) for one in given)
            symbol.defaults = tuple(values)

    def _function(self, node: tree.FunctionDef) -> None:
        type_ = self.type(node.type)
        assert isinstance(type_, FunctionType)
        cls: StructType | None = None
        if node.cls:
            found = self.named_type(node.cls, node.place)
            assert isinstance(found, StructType)
            cls = found
            symbol = self._declared_method(cls, node, type_)
        else:
            symbol = self._known(node.name, type_, node.type.parts, node)
        if symbol.defined:
            raise CError(node.place, f"{node.name}() has two bodies")
        symbol.defined = True
        symbol.place = node.place
        self.waiting.append((node, symbol, cls))

    def _body(self, node: tree.FunctionDef, symbol: Symbol, cls: StructType | None) -> None:
        """The body of a function."""
        type_ = symbol.type
        part = node.type.parts[0]
        assert isinstance(type_, FunctionType) and isinstance(part, nodes.FunctionPart)
        self.cls, self.result = cls, type_.result
        self.variables, self.jumps, self.labels = [], [], set()
        self.scope = Scope(self.top)
        parameters = []
        for written, one in zip(part.parameters, type_.parameters, strict=True):
            parameter = Symbol(written.name or "unused", one, written.place, "parameter")
            parameters.append(parameter)
            self.declare(parameter)
        before = self._construction(node, cls) if cls and node.name == cls.tag else []
        after = self._destruction(node, cls) if cls and node.name[0] == "~" else []
        body = self.block(node.body)
        body.ending += tuple(one for one in parameters if ends(one))
        self.scope, self.cls = self.top, None
        for label, place in self.jumps:
            if label not in self.labels:
                self.errors.append(CError(place, f"there is no label {label} in this function"))
        jumps = bool(self.jumps)
        made = Routine(symbol, parameters, body, self.variables, before, after, jumps)
        self.routines.append(made)

    # Classes

    def define_struct(self, node: tree.StructDef) -> None:
        """A struct, union or class with its members."""
        cls = self.tagged(node.kind, node.tag)
        if cls.complete:
            raise CError(node.place, f"{node.tag} is defined twice")
        cls.complete, cls.kind, cls.place = True, node.kind, node.place
        self.structs.append(cls)
        if len(node.bases) > 1:
            raise CError(node.place, "a class with two bases is not supported")
        if node.bases:
            base = self.named_type(node.bases[0], node.place)
            if not isinstance(base, StructType) or not base.complete or base is cls:
                raise CError(node.place, f"{node.bases[0]} is no class")
            cls.base = base
        cls.pure = node.pure
        outer, self.cls = self.cls, cls
        for member in node.members:
            self._member_of(cls, member, node)
        if not cls.methods.get(cls.tag) and is_made(cls):
            self._function(_implicit(node, node.tag))
        if not cls.method(f"~{cls.tag}") and self._destruction(node, cls):
            self._function(_implicit(node, f"~{node.tag}"))
        if cls.kind == "union":
            self._check_union(cls, node)
        self.cls = outer

    def _check_union(self, cls: StructType, node: tree.StructDef) -> None:
        """The members of a union share their bytes, so they have to consist of bytes."""
        for name, type_ in cls.members.items():
            if not is_number(type_) and innermost(type_) not in (CHAR, UCHAR):
                what = "only numbers and characters can share memory in a union"
                raise CError(node.place, f"{name}: {what}")

    def _member_of(self, cls: StructType, member: tree.Member_, node: tree.StructDef) -> None:
        match member:
            case tree.StructDef():
                self.define_struct(member)
            case tree.EnumDef():
                self.define_enum(member)
            case tree.FunctionDef():
                self._function(member)
            case tree.Declaration(names=names):
                for one in names:
                    self._data(cls, one, one.name in node.virtuals)

    def _data(self, cls: StructType, node: tree.Declarator, virtual: bool) -> None:
        type_ = self.type(node.type)
        if isinstance(type_, FunctionType):
            self._add_method(cls, node, type_, virtual)
        elif node.storage == "static":
            symbol = Symbol(node.name, type_, node.place, "global")
            cls.statics[node.name] = symbol
            self.statics.append(Define(node.place, symbol, None))
        elif node.name:
            inner = innermost(type_)
            if inner is cls or (isinstance(inner, StructType) and not inner.complete):
                known = "stands in itself" if inner is cls else "is not known yet"
                raise CError(node.place, f"{described(inner)} {known}: use a pointer to it")
            cls.members[node.name] = type_ if node.bits is None else self._bits(node, type_)

    def _bits(self, node: tree.Declarator, type_: Type) -> Type:
        """A bit field: a whole number of so many bits."""
        assert node.bits is not None
        width = self.constant(node.bits)
        if not isinstance(type_, IntType) or not 0 < width <= type_.bits:
            raise CError(node.place, f"{node.name} cannot have {width} bits")
        return IntType(width, type_.signed)

    def _declared_method(
        self, cls: StructType, node: tree.FunctionDef, type_: FunctionType
    ) -> Symbol:
        """The symbol of a method that is defined."""
        for one in cls.methods.get(node.name, []):
            if one.type == type_ or node.name[0] == "~" or node.name.startswith("operator "):
                return one
        return self._add_method(cls, node, type_, node.virtual)

    def _add_method(
        self,
        cls: StructType,
        node: tree.Declarator | tree.FunctionDef,
        type_: FunctionType,
        virtual: bool,
    ) -> Symbol:
        inherited = [
            one
            for one in (cls.base.method(node.name) if cls.base else [])
            if isinstance(one.type, FunctionType) and one.type.parameters == type_.parameters
        ]
        made = Symbol(node.name, type_, node.place, "method", owner=cls)
        made.static = node.storage == "static"
        made.virtual = virtual or any(one.virtual for one in inherited)
        if inherited and made.virtual:
            made.python = inherited[0].python
        self._take_defaults(made, node.type.parts)
        same = cls.methods.setdefault(node.name, [])
        same.append(made)
        made.python = made.python or python_name(made, len(same))
        return made

    def _construction(self, node: tree.FunctionDef, cls: StructType) -> list[Act]:
        """What a constructor does before its body: its base and its members are constructed."""
        written = dict(node.initializers)
        done: list[Act] = []
        itself = Itself(node.place, cls)
        if cls.base is not None and (cls.base.methods.get(cls.base.tag) or cls.base.tag in written):
            given = [self.value(one) for one in written.get(cls.base.tag, ())]
            symbol, arguments = self.constructed(cls.base, given, node.place)
            if symbol is not None:
                call = MethodCall(node.place, VOID, itself, symbol, arguments, True)
                done.append(Compute(node.place, call))
        for name, type_ in cls.members.items():
            value = self._member_value(name, type_, written.get(name), node)
            if value is not None:
                field = Field(node.place, type_, itself, name)
                done.append(Compute(node.place, Store(node.place, type_, field, value)))
        return done

    def _destruction(self, node: tree.FunctionDef | tree.StructDef, cls: StructType) -> list[Act]:
        """What a destructor does behind its body: its members and its base are destroyed."""
        place, itself = node.place, Itself(node.place, cls)
        objects: list[Value] = [
            Field(place, type_, itself, name)
            for name, type_ in reversed(cls.members.items())
            if isinstance(type_, StructType)
        ]
        if cls.base is not None:
            objects.append(Itself(place, cls.base))
        done: list[Act] = []
        for one in objects:
            assert isinstance(one.type, StructType)
            for method in one.type.method(f"~{one.type.tag}"):
                done.append(Compute(place, MethodCall(place, VOID, one, method, (), True)))
        return done

    def _member_value(
        self,
        name: str,
        type_: Type,
        written: tuple[nodes.Expr, ...] | None,
        node: tree.FunctionDef,
    ) -> Value | None:
        """What a constructor gives to a member, if it does."""
        given = [self.value(one) for one in written or ()]
        inner = innermost(type_)
        if isinstance(inner, StructType) and (given or inner.methods.get(inner.tag)):
            made = self.created(inner, type_, given, node.place, None)
            return made if made.constructor or given else None
        if given:
            if isinstance(type_, ReferenceType):
                return self.given(given[0], type_)
            return converted(given[0], type_)
        return None


def _implicit(node: tree.StructDef, name: str) -> tree.FunctionDef:
    """The constructor or destructor of a class whose members or base have one."""
    type_ = nodes.TypeName(node.place, nodes.Words(("void",)), (nodes.FunctionPart(()),))
    body = tree.Block(node.place, ())
    return tree.FunctionDef(node.place, name, type_, body, cls=node.tag)


def check(program: tree.Program, headers: Headers, cplusplus: bool) -> TypedProgram:
    """The typed tree of a program; CErrors holds all that is wrong with it."""
    return Checker(headers, cplusplus).program(program)
