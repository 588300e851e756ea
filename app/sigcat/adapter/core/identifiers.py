"""Names of interfaces as identifiers of C and C++."""

import re
from collections.abc import Iterable

_NOT_IDENTIFIER = re.compile(r"[^A-Za-z0-9_]+")
_C = (
    "auto break case char const continue default do double else enum extern float for goto if inline int long register "
    "restrict return short signed sizeof static struct switch typedef union unsigned void volatile while bool true false"
)
_CPP = (
    "alignas alignof and and_eq asm bitand bitor catch char16_t char32_t class compl concept consteval constexpr "
    "constinit const_cast co_await co_return co_yield decltype delete dynamic_cast explicit export friend mutable "
    "namespace new noexcept not not_eq nullptr operator or or_eq private protected public reinterpret_cast requires "
    "static_assert static_cast template this thread_local throw try typeid typename using virtual wchar_t xor xor_eq"
)
KEYWORDS = frozenset((*_C.split(), *_CPP.split()))


def identifier(name: str) -> str:
    """A name that C and C++ take: `Wheel speed` → `Wheel_speed`, `switch` → `switch_`."""
    text = _NOT_IDENTIFIER.sub("_", name).strip("_") or "unnamed"
    return f"{text}_" if text in KEYWORDS else f"n{text}" if text[0].isdigit() else text


def unique(name: str, taken: Iterable[str]) -> str:
    """The name itself, or with the first number behind it that makes it one of its own."""
    known = set(taken)
    if name not in known:
        return name
    return next(numbered for number in range(2, len(known) + 3) if (numbered := f"{name}_{number}") not in known)
