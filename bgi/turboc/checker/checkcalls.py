"""Calls: which of several functions is meant, and what its arguments become."""

from __future__ import annotations

from bgi.turboc.checker.checkvalues import Values
from bgi.turboc.checker.conversions import as_other, converted, decayed, is_place, passed
from bgi.turboc.checker.typed import (
    Constant,
    Creation,
    Inverse,
    Invocation,
    Itself,
    LibraryCall,
    MethodCall,
    Store,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    DOUBLE,
    INT,
    ArrayType,
    FunctionType,
    IntType,
    PointerType,
    ReferenceType,
    StructType,
    Symbol,
    Type,
    described,
    is_number,
    promoted,
)
from bgi.turboc.faults import CError, Place
from bgi.turboc.grammar import nodes

_OBJECT = 8
"""What it costs to make an object of a value."""

_NEVER = 1000
"""What it costs to convert what cannot be converted."""


def _cost(value: Value, type_: Type) -> int:
    """How far a value is from a type: 0 if it is of that type."""
    given = decayed(value).type
    if isinstance(type_, ReferenceType):
        type_ = type_.to
        given = value.type if isinstance(type_, ArrayType) else given
    if given == type_:
        return 0
    if is_number(given) and is_number(type_):
        if isinstance(given, IntType):
            return 1 if type_ == promoted(given) else 3
        return 1 if type_ == DOUBLE else 3
    if isinstance(type_, PointerType):
        null = isinstance(value, Constant) and value.value == 0
        return 5 if isinstance(given, PointerType) or null else _NEVER
    if isinstance(type_, StructType):
        if isinstance(given, StructType):
            return 2 if given.descends(type_) else _NEVER
        makers = type_.methods.get(type_.tag, [])
        return _OBJECT if any(_takes(one, 1) for one in makers) else _NEVER
    return _NEVER


def _takes(symbol: Symbol, count: int) -> bool:
    """Whether a function can be called with so many arguments."""
    type_ = symbol.type
    assert isinstance(type_, FunctionType)
    optional = sum(default is not None for default in symbol.defaults)
    least = len(type_.parameters) - optional
    return least <= count and (count <= len(type_.parameters) or type_.open)


def _unsaid(symbol: Symbol) -> bool:
    """Whether nothing is said of a function's parameters."""
    type_ = symbol.type
    assert isinstance(type_, FunctionType)
    return type_.open and not type_.parameters


class Calls(Values):
    """What is called."""

    def call(self, node: nodes.Call) -> Value:
        """A call."""
        given = [self.value(one) for one in node.arguments]
        function = node.function
        while isinstance(function, nodes.Unary) and function.op == "*":
            function = function.operand
        if isinstance(function, nodes.Name):
            return self._by_name(function, given, node.place)
        if isinstance(function, nodes.Member):
            base = self.object(function)
            assert isinstance(base.type, StructType)
            if function.name[0] == "~" or base.type.method(function.name):
                return self.method(base, function.name, given, function.place, function.scope)
        return self._through(self.value(function), given, node.place)

    def _by_name(self, name: nodes.Name, given: list[Value], place: Place) -> Value:
        inside = self.cls is not None and name.scope != "::"
        local = not name.scope and self.scope.find_inside(name.name)
        if inside and not local and self.cls is not None:
            cls = self.named_type(name.scope, place) if name.scope else self.cls
            if isinstance(cls, StructType) and cls.method(name.name):
                itself = Itself(name.place, self.cls)
                return self.method(itself, name.name, given, name.place, name.scope)
            if not name.scope and self.cls.member(name.name):
                return self._through(self.value(name), given, place)
        if name.scope not in ("", "::"):
            cls = self.named_type(name.scope, place)
            if isinstance(cls, StructType) and cls.method(name.name):
                return self.method(Itself(place, cls), name.name, given, place, name.scope)
        found = self.find(name.name, name.scope, name.place)
        if not found:
            raise self.unknown(name.name, name.place, FunctionType(INT, (), open=True))
        if not isinstance(found[0].type, FunctionType):
            return self._through(self.named(found[0], place), given, place)
        library = self.headers.symbol(name.name)  # which a function of that name overloads
        usable = library is not None and _takes(library, len(given))
        own_fit = any(_takes(one, len(given)) and not _unsaid(one) for one in found)
        own_fit = own_fit and any(self._near(one, given) for one in found)
        if found[0].kind == "function" and library is not None and usable and not own_fit:
            found = [library]
        return self.function(found, given, name.place)

    def function(self, found: list[Symbol], given: list[Value], place: Place) -> Value:
        """A call of one of the functions that have a name."""
        symbol = self.chosen(found, given, place)
        type_ = symbol.type
        assert isinstance(type_, FunctionType)
        arguments = self.arguments(symbol.name, type_, symbol.defaults, given, place)
        if symbol.kind == "library":
            return LibraryCall(place, type_.result, symbol.name, arguments)
        symbol.written += 1
        return Invocation(place, type_.result, Variable(place, type_, symbol), arguments)

    def _through(self, value: Value, given: list[Value], place: Place) -> Value:
        """A call through a pointer, or of an object."""
        if isinstance(value.type, StructType):
            return self.operator("()", value, given, place)
        type_ = value.type.to if isinstance(value.type, PointerType) else value.type
        if not isinstance(type_, FunctionType):
            raise CError(place, f"{described(value.type)} is no function")
        arguments = self.arguments("the function", type_, (), given, place)
        return Invocation(place, type_.result, value, arguments)

    def chosen(self, found: list[Symbol], given: list[Value], place: Place) -> Symbol:
        """Which of several functions fits the arguments best."""
        if len(found) == 1:
            return found[0]
        best, least = None, _NEVER
        for symbol in found:
            type_ = symbol.type
            assert isinstance(type_, FunctionType)
            if _takes(symbol, len(given)):
                pairs = zip(given, type_.parameters, strict=False)
                cost = sum(_cost(value, wanted) for value, wanted in pairs)
                if cost < least:
                    best, least = symbol, cost
        if best is None:
            kinds = ", ".join(described(decayed(one).type) for one in given)
            raise CError(place, f"no {found[0].name} takes ({kinds})")
        return best

    def arguments(
        self,
        name: str,
        type_: FunctionType,
        defaults: tuple[Value | None, ...],
        given: list[Value],
        place: Place,
    ) -> tuple[Value, ...]:
        """The arguments as the types of the parameters."""
        wanted = type_.parameters
        more = [one for one in defaults[len(given) :] if one is not None]
        filled = given + more if len(given) < len(wanted) else given
        if len(filled) < len(wanted) or (len(filled) > len(wanted) and not type_.open):
            count = len(wanted)
            number = f"{count} argument{'s' * (count != 1)}"
            raise CError(place, f"{name} takes {number}, not {len(given)}")
        pairs = zip(filled, wanted, strict=False)
        made = [self.given(value, one) for value, one in pairs]
        return tuple(made + [passed(value) for value in filled[len(wanted) :]])

    def given(self, value: Value, type_: Type) -> Value:
        """A value as the type of a parameter, a variable or a result."""
        to = type_.to if isinstance(type_, ReferenceType) else type_
        if isinstance(to, StructType) and not (
            isinstance(value.type, StructType) and value.type.descends(to)
        ):
            made = self.created(to, to, [value], value.place, None)
            return converted(made, type_)
        if isinstance(type_, StructType) and is_place(value) and self._copies(type_):
            return self.created(type_, type_, [value], value.place, None)
        return converted(value, type_)

    def _copies(self, cls: StructType) -> bool:
        """Whether a class has a constructor that copies."""
        return any(
            isinstance(one.type, FunctionType) and one.type.parameters == (ReferenceType(cls),)
            for one in cls.methods.get(cls.tag, [])
        )

    # Methods

    def method(
        self, base: Value, name: str, given: list[Value], place: Place, scope: str = ""
    ) -> Value:
        """A call of a method of an object."""
        cls = base.type
        assert isinstance(cls, StructType)
        if scope:
            named = self.named_type(scope, place)
            assert isinstance(named, StructType)
            cls = named
        found = cls.method(name)
        if not found:
            raise CError(place, f"{described(cls)} has no {name}()")
        symbol = self.chosen(found, given, place)
        type_ = symbol.type
        assert isinstance(type_, FunctionType)
        arguments = self.arguments(name, type_, symbol.defaults, given, place)
        symbol.written += 1
        exact = bool(scope) or not symbol.virtual
        return self.referred(MethodCall(place, type_.result, base, symbol, arguments, exact))

    def operator(self, op: str, left: Value, right: list[Value], place: Place) -> Value:
        """An operator of a class: one of its methods, or a function of that name."""
        name = f"operator{op}"
        methods = left.type.method(name) if isinstance(left.type, StructType) else []
        functions = self.scope.find(name)
        usable = [one for one in methods if self._fits(one, right)]
        if functions and not any(self._exact(one, right) for one in usable):
            fitting = [one for one in functions if self._fits(one, [left, *right])]
            if fitting:
                return self.referred(self.function(fitting, [left, *right], place))
        if usable:
            return self.method(left, name, right, place)
        if op == "=" and isinstance(left.type, StructType):
            return self._assigned(left, right[0], place)
        numbers = [as_other(one) or one for one in (left, *right)]
        if len(right) == 1 and not any(isinstance(one.type, StructType) for one in numbers):
            return self.binary(op, numbers[0], numbers[1], place)
        if not right and op == "!" and numbers[0] is not left:
            return Inverse(place, INT, numbers[0])
        kinds = " and ".join(described(decayed(one).type) for one in (left, *right))
        raise CError(place, f"there is no {op} for {kinds}")

    def _assigned(self, left: Value, right: Value, place: Place) -> Value:
        """An object that takes over another's members."""
        return Store(place, left.type, left, converted(right, left.type))

    def _fits(self, symbol: Symbol, given: list[Value]) -> bool:
        type_ = symbol.type
        assert isinstance(type_, FunctionType)
        pairs = zip(given, type_.parameters, strict=False)
        return _takes(symbol, len(given)) and all(_cost(*pair) < _NEVER for pair in pairs)

    def _near(self, symbol: Symbol, given: list[Value]) -> bool:
        """Whether a function takes values without making objects of them."""
        type_ = symbol.type
        assert isinstance(type_, FunctionType)
        pairs = zip(given, type_.parameters, strict=False)
        return not self.cplusplus or all(_cost(*pair) < _OBJECT for pair in pairs)

    def _exact(self, symbol: Symbol, given: list[Value]) -> bool:
        type_ = symbol.type
        assert isinstance(type_, FunctionType)
        return all(_cost(*pair) == 0 for pair in zip(given, type_.parameters, strict=False))

    def created(
        self, type_: Type, result: Type, given: list[Value], place: Place, count: Value | None
    ) -> Creation:
        """A new object of a type, by its constructor if it has one."""
        constructor, arguments = None, tuple(given)
        if isinstance(type_, StructType):
            self.whole(type_, place)
            constructor, arguments = self.constructed(type_, given, place)
        elif given:
            arguments = (converted(given[0], type_),)
        return Creation(place, result, type_, count, constructor, arguments)

    def whole(self, cls: StructType, place: Place) -> None:
        """CError for a class of which no object can be made."""
        if not cls.complete:
            raise CError(place, f"nothing is known of {described(cls)}")
        for name in sorted(cls.missing()):
            raise CError(place, f"{cls.tag} is abstract: its {name}() has no body")

    def constructed(
        self, cls: StructType, given: list[Value], place: Place
    ) -> tuple[Symbol | None, tuple[Value, ...]]:
        """The constructor that is meant, and its arguments."""
        found = [one for one in cls.methods.get(cls.tag, []) if self._fits(one, given)]
        if not found:
            same = len(given) == 1 and isinstance(given[0].type, StructType)
            if (not given and not cls.methods.get(cls.tag)) or (same and _cost(given[0], cls) < 9):
                return None, tuple(given)
            kinds = ", ".join(described(decayed(one).type) for one in given)
            raise CError(place, f"{cls.tag} cannot be made of ({kinds})")
        symbol = self.chosen(found, given, place)
        type_ = symbol.type
        assert isinstance(type_, FunctionType)
        return symbol, self.arguments(cls.tag, type_, symbol.defaults, given, place)
