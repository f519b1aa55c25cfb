"""Statements and declarations, with their types."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from bgi.turboc.checker.checkcalls import Calls
from bgi.turboc.checker.conversions import converted
from bgi.turboc.checker.scopes import Scope
from bgi.turboc.checker.typed import (
    Act,
    Again,
    Branch,
    Compute,
    Constant,
    Define,
    Give,
    Group,
    Jump,
    Leave,
    Listed,
    Loop,
    Mark,
    Quoted,
    Select,
    Value,
)
from bgi.turboc.checker.types import (
    CHAR,
    INT,
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
from bgi.turboc.faults import CError, Place
from bgi.turboc.grammar import nodes, tree


class Actions(Calls):
    """What a program does."""

    result: Type
    """Of the function that is looked at."""
    variables: list[Symbol]
    """Its variables."""
    jumps: list[tuple[str, Place]]
    """Where a goto leads."""
    labels: set[str]
    deep: list[list[tuple[int | None, str]]]
    """Of each switch around: the cases in its loops and branches, and their labels."""
    around: list[str]
    """Which loops and switches stand around."""
    statics: list[Define]
    """Variables that are declared in functions and outlive them."""

    # Statements

    def act(self, node: tree.Stmt) -> Act:
        """A statement; what is wrong with it is remembered, and the next one is looked at."""
        try:
            return _READERS[type(node)](self, node)
        except CError as error:
            self.errors.append(error)
            return Group(node.place, [])

    def block(self, node: tree.Block) -> Group:
        """Statements in a scope of their own."""
        self.scope = Scope(self.scope)
        items = [self.act(item) for item in node.items]
        symbols = [one for found in self.scope.names.values() for one in found]
        ending = tuple(one for one in symbols if ends(one))
        assert self.scope.outer is not None
        self.scope = self.scope.outer
        return Group(node.place, items, ending)

    def _expression(self, node: tree.ExprStmt) -> Act:
        if node.value is None:
            return Group(node.place, [])
        return Compute(node.value.place, self.computed(node.value))

    def _if(self, node: tree.If) -> Act:
        no = self.act(node.no) if node.no is not None else None
        return Branch(node.place, self.condition(node.condition), self.act(node.yes), no)

    def body(self, node: tree.Stmt) -> Act:
        """The body of a loop, in which break and continue may stand."""
        self.around.append("loop")
        body = self.act(node)
        self.around.pop()
        return body

    def _while(self, node: tree.While) -> Act:
        return Loop(node.place, None, self.condition(node.condition), None, self.body(node.body))

    def _do(self, node: tree.DoWhile) -> Act:
        body = self.body(node.body)
        return Loop(node.place, None, self.condition(node.condition), None, body, late=True)

    def _for(self, node: tree.For) -> Act:
        first = self.act(node.initial) if node.initial is not None else None
        condition = self.condition(node.condition) if node.condition is not None else None
        step = self.computed(node.step) if node.step is not None else None
        return Loop(node.place, first, condition, step, self.body(node.body))

    def _switch(self, node: tree.Switch) -> Act:
        value = self.number(node.value)
        if not isinstance(value.type, IntType):
            raise CError(node.place, "switch needs a whole number")
        self.scope = Scope(self.scope)
        parts: list[tuple[list[int | None], list[Act]]] = []
        written: dict[int, Value] = {}
        self.deep.append([])
        self.around.append("switch")
        for item in _without_blocks(node.body):
            if isinstance(item, tree.Case):
                if not parts or parts[-1][1]:
                    parts.append(([], []))
                known = None if item.value is None else self.constant(item.value)
                parts[-1][0].append(known)
                if item.value is not None and known is not None:
                    written[known] = self.value(item.value)
            elif parts:
                parts[-1][1].append(self.act(item))
            elif isinstance(item, tree.Declaration):
                self.act(item)
        assert self.scope.outer is not None
        self.scope = self.scope.outer
        deep = self.deep.pop()
        self.around.pop()
        if deep and parts:
            parts[-1][1].append(Leave(node.place))
        parts += [([known], [Jump(node.place, label)]) for known, label in deep]
        return Select(node.place, value, parts, written)

    def _case(self, node: tree.Case) -> Act:
        """A case in a loop or branch of its switch: a label that the switch jumps to."""
        if not self.deep:
            raise CError(node.place, "this case stands in no switch")
        known = None if node.value is None else self.constant(node.value)
        label = f"case {node.place.line} {node.place.column}"
        self.deep[-1].append((known, label))
        self.jumps.append((label, node.place))
        self.labels.add(label)
        return Mark(node.place, label)

    def _break(self, node: tree.Break) -> Act:
        if not self.around:
            raise CError(node.place, "this break stands in no loop and no switch")
        return Leave(node.place)

    def _continue(self, node: tree.Continue) -> Act:
        if "loop" not in self.around:
            raise CError(node.place, "this continue stands in no loop")
        return Again(node.place)

    def _return(self, node: tree.Return) -> Act:
        if node.value is None:
            return Give(node.place, None)
        value = self.value(node.value)
        if self.result == VOID:  # Turbo C took it
            return Give(node.place, converted(value, VOID))
        return Give(node.place, self.given(value, self.result))

    def _goto(self, node: tree.Goto) -> Act:
        self.jumps.append((node.label, node.place))
        return Jump(node.place, node.label)

    def _label(self, node: tree.Label) -> Act:
        if node.name in self.labels:
            raise CError(node.place, f"there is another label {node.name} in this function")
        self.labels.add(node.name)
        return Mark(node.place, node.name)

    def _asm(self, node: tree.Asm) -> Act:
        raise CError(node.place, "inline assembler cannot be run: its instructions are a PC's own")

    # Declarations

    def _declaration(self, node: tree.Declaration) -> Act:
        return Group(node.place, [one for name in node.names for one in self.local(name)])

    def local(self, node: tree.Declarator) -> list[Act]:
        """A variable of a function."""
        if node.storage == "typedef":
            self.declare_type(node.name, self.type(node.type))
            return []
        type_ = self.type(node.type)
        if isinstance(type_, FunctionType):
            self.prototype(node, type_)
            return []
        if node.storage == "extern":
            return []
        if type_ == VOID:
            raise CError(node.place, f"{node.name} cannot be void")
        made = Symbol(node.name, type_, node.place, "local")
        made.kind = "global" if node.storage == "static" else "local"
        self.declare(made)
        if self._is_constant(node, made):
            return []
        defined = Define(node.place, made, self.initial(node, made))
        if made.kind == "global":
            self.statics.append(defined)
            return []
        self.variables.append(made)
        return [defined]

    def _is_constant(self, node: tree.Declarator, symbol: Symbol) -> bool:
        """Whether `const int N = 10` declares a constant, which then is one."""
        if not (node.const and is_number(symbol.type) and node.initial is not None):
            return False
        value = self.value(node.initial)
        if not (isinstance(value, Constant) and is_number(value.type)):
            return False
        known = converted(value, symbol.type)
        assert isinstance(known, Constant)
        symbol.kind, symbol.value = "constant", known.value
        return True

    def prototype(self, node: tree.Declarator, type_: FunctionType) -> None:
        """A function that is declared, and defined somewhere else."""
        raise NotImplementedError

    def initial(self, node: tree.Declarator, symbol: Symbol) -> Value | None:
        """The value that a variable has from the beginning."""
        type_ = symbol.type
        inner = innermost(type_)
        if node.arguments is not None:
            given = [self.value(one) for one in node.arguments]
            if isinstance(type_, StructType):
                return self.created(type_, type_, given, node.place, None)
            return self.given(given[0], type_)
        if node.initial is not None:
            value = self.listed(node.initial, type_)
            if isinstance(type_, ArrayType) and not type_.count:
                symbol.type = value.type
            return value
        if isinstance(type_, ReferenceType):
            raise CError(node.place, f"the reference {node.name} needs something to refer to")
        if isinstance(type_, ArrayType) and not type_.count:
            raise CError(node.place, f"nothing says how long {node.name} is")
        if isinstance(inner, StructType):
            self.whole(inner, node.place)
        if isinstance(inner, StructType) and is_made(inner):
            return self.created(inner, type_, [], node.place, None)
        return None

    def listed(self, node: nodes.Expr, type_: Type) -> Value:
        """An initial value: for arrays and structs a list."""
        if isinstance(node, nodes.Braces):
            if not isinstance(type_, (ArrayType, StructType)):
                if not node.items:
                    raise CError(node.place, "a value is missing in these braces")
                return self.listed(node.items[0], type_)
            rest = list(node.items)
            text = len(rest) == 1 and isinstance(rest[0], nodes.StrLit)
            if text and isinstance(type_, ArrayType) and type_.of in (CHAR, UCHAR):
                return self.listed(rest[0], type_)
            value = self._list(rest, type_, node.place)
            if rest:
                raise CError(rest[0].place, f"too many values for {described(type_)}")
            return value
        if isinstance(node, nodes.StrLit) and isinstance(type_, ArrayType):
            count = type_.count or len(node.value) + 1
            return Quoted(node.place, ArrayType(type_.of, count), node.value[:count])
        return self.given(self.value(node), type_)

    def _list(self, rest: list[nodes.Expr], type_: Type, place: Place) -> Value:
        """As many of the values as an array or a struct takes."""
        items: list[Value | None] = []
        if isinstance(type_, StructType):
            for number, member in enumerate(type_.all_members().values()):
                given = rest and not (type_.kind == "union" and number)
                items.append(self._item(rest, member) if given else None)
            return Listed(place, type_, tuple(items))
        assert isinstance(type_, ArrayType)
        while rest and (not type_.count or len(items) < type_.count):
            items.append(self._item(rest, type_.of))
        inner = innermost(type_.of)
        if isinstance(inner, StructType) and is_made(inner):
            missing = range(len(items), type_.count)
            items += [self.created(inner, type_.of, [], place, None) for _ in missing]
        return Listed(place, ArrayType(type_.of, type_.count or len(items)), tuple(items))

    def _item(self, rest: list[nodes.Expr], type_: Type) -> Value:
        """The next value; braces around it may be left out."""
        first = rest[0]
        inner = isinstance(type_, (ArrayType, StructType))
        if inner and not isinstance(first, (nodes.Braces, nodes.StrLit)):
            if isinstance(type_, StructType) and self.value(first).type == type_:
                return self.given(self.value(rest.pop(0)), type_)
            return self._list(rest, type_, first.place)
        return self.listed(rest.pop(0), type_)

    def _struct(self, node: tree.StructDef) -> Act:
        self.define_struct(node)
        return Group(node.place, [])

    def define_struct(self, node: tree.StructDef) -> None:
        """A struct, union or class."""
        raise NotImplementedError

    def _enum(self, node: tree.EnumDef) -> Act:
        self.define_enum(node)
        return Group(node.place, [])

    def define_enum(self, node: tree.EnumDef) -> None:
        """The constants of an enum."""
        following = 0
        self.declare_type(node.tag, INT)
        for name, written in node.constants:
            number = following if written is None else self.constant(written)
            symbol = Symbol(name, INT, node.place, "constant", name, value=number)
            self.declare(symbol)
            if self.cls is not None:
                self.cls.statics[name] = symbol
            following = number + 1


def ends(symbol: Symbol) -> bool:
    """Whether it is an object with a destructor."""
    type_ = innermost(symbol.type)
    local = symbol.kind in ("local", "parameter")
    return local and isinstance(type_, StructType) and bool(type_.method(f"~{type_.tag}"))


def is_made(cls: StructType) -> bool:
    """Whether objects of a class are made by a constructor."""
    members = [innermost(one) for one in cls.all_members().values()]
    return bool(cls.methods.get(cls.tag)) or any(
        isinstance(one, StructType) and is_made(one) for one in [*members, cls.base] if one
    )


def _without_blocks(node: tree.Stmt) -> list[tree.Stmt]:
    """The statements of a switch in a row: a case and what stands behind it are a block."""
    if not isinstance(node, tree.Block):
        return [node]
    found: list[tree.Stmt] = []
    for item in node.items:
        inner = isinstance(item, tree.Block) and item.items and _begins_case(item)
        found += _without_blocks(item) if inner else [item]
    return found


def _begins_case(node: tree.Stmt) -> bool:
    if isinstance(node, tree.Block) and node.items:
        return _begins_case(node.items[0])
    return isinstance(node, tree.Case)


_READERS: dict[type, Callable[[Actions, Any], Act]] = {
    tree.Block: Actions.block,
    tree.ExprStmt: Actions._expression,
    tree.Declaration: Actions._declaration,
    tree.StructDef: Actions._struct,
    tree.EnumDef: Actions._enum,
    tree.If: Actions._if,
    tree.While: Actions._while,
    tree.DoWhile: Actions._do,
    tree.For: Actions._for,
    tree.Switch: Actions._switch,
    tree.Case: Actions._case,
    tree.Break: Actions._break,
    tree.Continue: Actions._continue,
    tree.Return: Actions._return,
    tree.Goto: Actions._goto,
    tree.Label: Actions._label,
    tree.Asm: Actions._asm,
}
