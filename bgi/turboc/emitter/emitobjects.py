"""New objects, arrays and initial values as Python."""

from __future__ import annotations

from bgi.turboc.checker.typed import Creation, Destruction, Listed, Quoted, Value
from bgi.turboc.checker.types import (
    CHAR,
    UCHAR,
    ArrayType,
    PointerType,
    ReferenceType,
    StructType,
    Symbol,
    Type,
    flat,
    innermost,
)
from bgi.turboc.emitter.emitplaces import Places, is_cell


class Objects(Places):
    """Writes what makes memory."""

    def given(self, value: Value) -> str:
        """A value that is given away: an object as a copy, if it stands somewhere."""
        raise NotImplementedError

    def called(self, function: str, values: tuple[Value, ...], types: tuple[Type, ...]) -> str:
        """A call of a Python function."""
        raise NotImplementedError

    def creation(self, value: Creation) -> str:
        one = self.made(value)
        if not isinstance(value.type, PointerType):
            if isinstance(value.type, ArrayType):
                return f"[{one} for _ in range({flat(value.type)})]"
            return one
        if value.count is None:
            return (
                f"Pointer([{one}])"
                if value.what not in (CHAR, UCHAR)
                else (f"Pointer(bytearray([{one} & 255]))")
            )
        count = f"room({self.value(value.count)})"
        if isinstance(value.what, StructType):
            return f"Pointer([{one} for _ in range({count})])"
        count = self.scaled(count, flat(value.what))
        return f"Pointer({self.many(innermost(value.what), count)})"

    def made(self, value: Creation) -> str:
        """One object."""
        what = value.what
        if not isinstance(what, StructType):
            return self.value(value.arguments[0]) if value.arguments else self.nothing(what)
        if value.constructor is not None:
            call = f"{self.nothing(what)}.{value.constructor.python}"
            return self.called(call, value.arguments, ())
        if value.arguments:
            return self.given(value.arguments[0])
        return self.nothing(what)

    def destruction(self, value: Destruction) -> str:
        text = self.value(value.operand)
        if value.destructor is None:
            return f"({text}, 0)[-1]"
        owner, name = value.destructor.owner, value.destructor.python
        assert owner is not None
        method = (
            f"lambda _one: _one.{name}()" if value.destructor.virtual else f"{owner.python}.{name}"
        )
        return f"destroy({text}, {value.array}, {method})"

    def listed(self, value: Listed) -> str:
        type_ = value.type
        if isinstance(type_, StructType):
            items = [
                f"{self.attribute(name)}={self._member(item)}"
                for name, item in zip(type_.all_members(), value.items, strict=True)
                if item is not None
            ]
            return f"{self.nothing(type_)}.filled({', '.join(items)})"
        one = innermost(type_)
        texts: list[str] = []
        self._flatten(value, texts)
        text = f"[{', '.join(texts)}]"
        if one in (CHAR, UCHAR):
            text = f"bytearray([{', '.join(f'{item} & 255' for item in texts)}])"
        missing = flat(type_) - len(texts)
        return f"({text} + {self.many(one, str(missing))})" if missing else text

    def _member(self, value: Value) -> str:
        """A member's first value: a string in an array of its own."""
        if isinstance(value, Quoted) and isinstance(value.type, ArrayType):
            return _characters(value, value.type)
        return self.given(value)

    def _flatten(self, value: Value, texts: list[str]) -> None:
        """The elements of an array of any depth, one after the other."""
        if not isinstance(value.type, ArrayType):
            texts.append(self.given(value))
        elif isinstance(value, Quoted):
            texts += [str(code - (code >> 7 << 8)) for code in value.data]
            texts += ["0"] * (flat(value.type) - len(value.data))
        else:
            assert isinstance(value, Listed)
            begin = len(texts)
            for item in value.items:
                if item is not None:
                    self._flatten(item, texts)
            missing = flat(value.type) - (len(texts) - begin)
            texts += [self.nothing(innermost(value.type))] * missing

    def made_variable(self, symbol: Symbol, value: Value | None) -> str:
        """What a variable holds from the beginning, in its cell if it lives in one."""
        type_ = symbol.type
        if value is None:
            text = self.nothing(type_)
        elif isinstance(value, Quoted) and isinstance(type_, ArrayType):
            text = _characters(value, type_)
        elif isinstance(type_, ReferenceType):
            text = self.value(value)
        else:
            text = self.given(value)
        return self.cell(text, type_) if is_cell(symbol) else text


def _characters(value: Quoted, type_: ArrayType) -> str:
    """A string that an array begins with."""
    return f"bytearray({value.data.ljust(type_.count, bytes(1))!r})"
