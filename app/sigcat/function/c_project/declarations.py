"""Declarations of C and C++ code: functions, variables, classes and types, each with its place."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, NamedTuple, TypeVar


class Place(NamedTuple):
    """A line of a file of the project."""

    file: str = ""
    line: int = 0


class CType(NamedTuple):
    """A type, with the names that it goes by: the written one first, then those of the types behind it."""

    kind: str
    """number, enumeration, record, array, pointer, void, or other."""
    names: tuple[str, ...] = ()
    key: str = ""
    """Key of a record or an enumeration."""
    sort: str = ""
    """Sort of a number: floating, signed, unsigned or boolean."""
    bits: int = 0
    length: int = 0
    """Elements of an array."""
    of: "CType | None" = None
    """Element of an array, or target of a pointer."""
    const: bool = False
    """Whether a pointer only reads."""

    @property
    def name(self) -> str:
        """The name that is written."""
        return self.names[0] if self.names else self.of.name if self.of else ""

    @property
    def target(self) -> "CType":
        """Target of a pointer; any other type itself."""
        return self.of if self.kind == "pointer" and self.of else self


class Member(NamedTuple):
    """A member of a struct or a class, or a parameter of a function."""

    name: str
    type: CType
    place: Place = Place()
    width: int | None = None
    """Bits of a bit field."""
    public: bool = True
    key: str = ""
    """Name in functions that use it."""
    is_const: bool = False


class Record(NamedTuple):
    """A struct or a union."""

    name: str
    members: tuple[Member, ...]
    place: Place
    is_union: bool = False
    is_complete: bool = True


class Constant(NamedTuple):
    """A name of an enumeration, and its number."""

    name: str
    value: int


class CFunction(NamedTuple):
    """A function that is declared or defined."""

    name: str
    result: CType
    parameters: tuple[Member, ...]
    place: Place
    is_defined: bool = False
    is_static: bool = False
    is_inline: bool = False
    uses: frozenset[str] = frozenset()
    """Names of functions and variables, and keys of members."""
    writes: frozenset[str] = frozenset()
    public: bool = True


class Variable(NamedTuple):
    """A variable that is declared or defined outside of functions."""

    name: str
    type: CType
    place: Place
    written: str = ""
    """The type as other files write it, with its qualifiers; of an array that of its elements."""
    is_const: bool = False
    is_static: bool = False
    is_defined: bool = False
    value: Any = None
    uses: frozenset[str] = frozenset()


class CClass(NamedTuple):
    """A class of C++."""

    name: str
    members: tuple[Member, ...]
    methods: tuple[CFunction, ...]
    place: Place


class CompilerError(NamedTuple):
    """An error of the compiler."""

    message: str
    place: Place
    column: int = 0
    is_own: bool = False
    """Whether the code itself says so, by `#error`."""
    is_syntax: bool = False
    """Whether the text is not C: what follows may be read wrong."""


class Declarations(NamedTuple):
    """Everything that a project declares."""

    functions: tuple[CFunction, ...] = ()
    variables: tuple[Variable, ...] = ()
    classes: tuple[CClass, ...] = ()
    records: Mapping[str, Record] = {}
    enumerations: Mapping[str, tuple[Constant, ...]] = {}
    errors: tuple[CompilerError, ...] = ()
    included: Mapping[str, tuple[str, ...]] = {}
    """Files by the file that includes them."""

    @property
    def named(self) -> "tuple[CFunction | Variable, ...]":
        """Functions and variables."""
        return (*self.functions, *self.variables)

    def all_included(self, path: str) -> frozenset[str]:
        """The files that a file includes, with those that these include."""
        found: set[str] = set()
        left = [path]
        while left:
            new = set(self.included.get(left.pop(), ())) - found
            found |= new
            left.extend(new)
        return frozenset(found)


T = TypeVar("T")


def declarations_from(answer: Mapping[str, Any]) -> Declarations:
    """The declarations in an answer of the worker, which has the names of the fields here."""
    return _made(Declarations, answer)


def _made(kind: Callable[..., T], fields: Mapping[str, Any]) -> T:
    return kind(**{name: _MAKERS[name](value) if name in _MAKERS else value for name, value in fields.items()})


def _list_of(kind: Callable[..., T]) -> Callable[[list[Any]], tuple[T, ...]]:
    return lambda items: tuple(_made(kind, each) for each in items)


def _mapping_of(make: Callable[[Any], T]) -> Callable[[Mapping[str, Any]], dict[str, T]]:
    return lambda values: {key: make(each) for key, each in values.items()}


_MAKERS: Mapping[str, Callable[[Any], object]] = {
    **dict.fromkeys(("type", "result", "of"), partial(_made, CType)),
    **dict.fromkeys(("parameters", "members"), _list_of(Member)),
    **dict.fromkeys(("functions", "methods"), _list_of(CFunction)),
    **dict.fromkeys(("uses", "writes"), frozenset),
    "names": tuple,
    "place": partial(_made, Place),
    "variables": _list_of(Variable),
    "classes": _list_of(CClass),
    "errors": _list_of(CompilerError),
    "records": _mapping_of(partial(_made, Record)),
    "enumerations": _mapping_of(_list_of(Constant)),
    "included": _mapping_of(tuple),
}
"""Values of fields whose JSON has another form, by the names of the fields."""
