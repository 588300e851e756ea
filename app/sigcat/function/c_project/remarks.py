"""Facts in the comment of a variable, a parameter or a call: port, unit, range, scale, cycle time, description."""

import re
from fractions import Fraction
from typing import NamedTuple

_NUMBER = r"[-+]?(?:\d+(?:\.(?!\.)\d*)?|\.\d+)(?:[eE][-+]?\d+)?"
_POWER = rf"(?:(?P<base>2)\s*(?:\^|\*\*)\s*\(?(?P<exponent>-?\d{{1,3}})\)?|1\s*/\s*(?P<divisor>\d+(?:\.\d+)?)|(?P<plain>{_NUMBER}))"
_PORT = re.compile(r"'<Root>/\s*(?P<name>[^']*?)\s*'")
_BLOCKS = re.compile(r"(?:Referenced by:\s*)?'<(?:S\d+|Root)>/[^']*'|Referenced by:")
_ORIGINS = re.compile(
    r"\b(?:Computed Parameter|Variable|Mask Parameter)\s*:\s*\w+|\bSimulink\.\w+ object\b[^\n]*"
    r"|\b(?:Pooled Parameter|Expression)\b[^\n]*"
)
"""Notes of Simulink on the origin of a value, which have neither range nor unit."""
_UNIT = re.compile(r"\bunits?\s*[:=]\s*[\[(\"']?(?P<unit>[^\s,;\])\"']+)", re.IGNORECASE)
_BRACKETS = re.compile(r"[\[(](?P<unit>[^\[\]()\d,;:][^\[\](),;:]{0,14})[\])]")
_SQUARE = re.compile(
    r"\[\s*(?P<unit>(?!(?:in|out|inout|in,\s*out|bool|boolean|enum|flag|bits?|bytes?|counts?|raw|none|unitless)\b)"
    r"(?:1/)?[A-Za-z°%][\w/^%°²*.-]{0,11})\s*\]",
    re.IGNORECASE,
)
"""A unit in square brackets, as `[K]`; `[in]` is the direction of an argument."""
_FIRST = re.compile(r"^\s*(?P<unit>[^\s,;:]{1,12})\s*[,;:]")
_LAST = re.compile(r"[,;]\s*(?P<unit>[^\s,;:]{1,12})\s*$")
_LIKE_A_UNIT = re.compile(r"(?<!\S)(?P<unit>[A-Za-z°%]{0,6}[/^%°²][\w/^%°²]{0,8})(?=[\s,;:.)\]]|$)")
_WORDS = re.compile(r"\bin (?P<unit>[%°A-Za-z][\w/^%°]{0,14})\b")
_BETWEEN = r"\s*(?:\.\.\.?|…|\bto\b|–|-|~)\s*"
_MAY_BE_UNIT = re.compile(
    r"(?!(?:min|max|range|units?|factor|slope|resolution|res|lsb|scal(?:e|ing)|offset|bias|step|note|todo)\b)"
    r"(?:1/)?[A-Za-z°%][\w/^%°²*.-]{0,11}",
    re.IGNORECASE,
)
_RANGE = re.compile(
    rf"\brange\b\s*(?:is|=|:)?\s*[\[(]?\s*(?P<min>{_NUMBER})(?:{_BETWEEN}|\s*[,;:]\s*)(?P<max>{_NUMBER})\s*[\])]?"
    rf"|\[\s*(?P<min_2>{_NUMBER})(?:{_BETWEEN}|\s*[,;:]\s*)(?P<max_2>{_NUMBER})\s*\]"
    rf"|\(\s*(?P<min_3>{_NUMBER}){_BETWEEN}(?P<max_3>{_NUMBER})\s*\)"
    rf"|(?<![\w.-])(?P<min_4>{_NUMBER})\s*(?:\.\.\.?|…|\bto\b)\s*(?P<max_4>{_NUMBER})(?![\w.-]*\w)",
    re.IGNORECASE,
)
_REFERENCE = re.compile(
    r"\b(?:chapters?|sections?|figures?|fig\.|pages?|equations?|eq\.|references?|ref\.|versions?)\s*"
    r"(?:[\[(][^\[\]()]*[\])]|\d[\d.]*(?:\s*(?:,|-|–|\.\.\.?|\bto\b|\band\b)\s*\d[\d.]*)*)",
    re.IGNORECASE,
)
"""A place in a document, as `chapter [3, 4]`: its numbers are no range."""
_HIDDEN = {ord("0") + digit: 0xE000 + digit for digit in range(10)}
_SHOWN = {hidden: shown for shown, hidden in _HIDDEN.items()}
_MIN = re.compile(rf"\bmin(?:imum)?\b\s*[:=]?\s*(?P<min>{_NUMBER})", re.IGNORECASE)
_MAX = re.compile(rf"\bmax(?:imum)?\b\s*[:=]?\s*(?P<max>{_NUMBER})", re.IGNORECASE)
_FACTOR = re.compile(
    rf"\b(?:factor|slope|resolution|res|lsb|scal(?:e|ing)|quantization)\b\s*(?:is|=|:)?\s*{_POWER}", re.IGNORECASE
)
_BINARY = re.compile(r"\b[su]?fix\d+_E(?P<sign>n?)(?P<digits>\d{1,3})\b|\bQ\d*\.(?P<fraction>\d{1,2})\b", re.IGNORECASE)
_BARE_POWER = re.compile(r"(?<![\w.^*])2\s*(?:\^|\*\*)\s*\(?(?P<exponent>-\d{1,3})\)?")
"""A negative power of two that stands alone: a resolution, as `m/s 2^-8`."""
_FIXDT = re.compile(
    rf"\bfixdt\(\s*[01]\s*,\s*\d+\s*(?:,\s*(?P<first>{_NUMBER}|2\^-?\d+)\s*)?(?:,\s*(?P<second>{_NUMBER})\s*)?\)"
)
_OFFSET = re.compile(rf"\b(?:offset|bias)\b\s*[:=]?\s*(?P<offset>{_NUMBER})", re.IGNORECASE)
_SAMPLE_TIME = re.compile(rf"\bSample time:\s*\[?\s*(?P<time>{_NUMBER})\s*s?\b", re.IGNORECASE)
_EVERY = re.compile(
    rf"\b(?:step(?: size)?|cycle(?: ?time)?|period|rate|task|sample time|every|each)\b\s*(?:of|is|=|:)?\s*"
    rf"(?P<time>{_NUMBER})\s*(?P<unit>ms|us|µs|s|sec|seconds?|milliseconds?)\b",
    re.IGNORECASE,
)
_MILLISECONDS = {"m": Fraction(1), "u": Fraction(1, 1000), "µ": Fraction(1, 1000), "s": Fraction(1000)}
_CHARACTERS = 2_000
"""Characters of a comment that are looked into."""


class Remark(NamedTuple):
    """Facts in a comment; empty if it has none."""

    port: str = ""
    """Name of the root port of the model."""
    units: tuple[str, ...] = ()
    """Texts that may be a unit, the most certain one first."""
    min: float | int | None = None
    max: float | int | None = None
    factor: float | int | None = None
    offset: float | int | None = None
    text: str = ""
    """The rest of the text: a description."""
    unit: str = ""
    """The unit, where the comment says that it is one: `Unit: km/h`, `[km/h]`."""


def remark_of(comment: str) -> Remark:
    """Facts in the comment of a variable or a parameter."""
    comment = comment[:_CHARACTERS]
    port = _PORT.search(comment)
    said = _ORIGINS.sub(" ", _BLOCKS.sub(" ", comment))
    said = _REFERENCE.sub(lambda found: found[0].translate(_HIDDEN), said)
    smallest, largest = _range(said)
    factor, offset = _scale(said)
    named = _UNIT.search(said) or _SQUARE.search(said)
    return Remark(
        port=port["name"] if port else "",
        units=_units(_BINARY.sub(" ", _FIXDT.sub(" ", said))),
        min=smallest,
        max=largest,
        factor=factor,
        offset=offset,
        text=_description(said),
        unit=named["unit"] if named else "",
    )


def cycle_time_of(comment: str) -> float | int | None:
    """The time between two calls in ms, as a comment says it."""
    comment = comment[:_CHARACTERS]
    if found := _SAMPLE_TIME.search(comment):
        time = Fraction(found["time"]) * 1000
    elif found := _EVERY.search(comment):
        time = Fraction(found["time"]) * _MILLISECONDS[found["unit"][0].lower()]
    else:
        return None
    return _plain(time) if time > 0 else None


def number(text: str) -> float | int:
    """A number as it is written: `0.50` is 0.5, `100` and `100.0` differ."""
    return float(text) if re.search(r"[.eE]", text) else int(text)


def _plain(value: Fraction) -> float | int:
    return int(value) if value.denominator == 1 else float(value)


def _units(said: str) -> tuple[str, ...]:
    patterns = (_UNIT, _BRACKETS, _FIRST, _LAST, _WORDS, _LIKE_A_UNIT)
    found = [match["unit"].strip() for pattern in patterns for match in pattern.finditer(said)]
    return tuple(dict.fromkeys(each for each in (*found, _rest(said)) if _MAY_BE_UNIT.fullmatch(each)))


def _range(said: str) -> tuple[float | int | None, float | int | None]:
    for match in _RANGE.finditer(_FIXDT.sub(" ", said)):
        smallest, largest = map(number, filter(None, match.groups()))
        if smallest < largest:
            return smallest, largest
    low, high = _MIN.search(said), _MAX.search(said)
    return number(low["min"]) if low else None, number(high["max"]) if high else None


def _scale(said: str) -> tuple[float | int | None, float | int | None]:
    offset = _OFFSET.search(said)
    shift = number(offset["offset"]) if offset else None
    if found := _FIXDT.search(said):
        return _fixdt(found["first"], found["second"])
    if found := _BINARY.search(said):
        digits = int(found["digits"] or found["fraction"])
        return _power(digits if found["sign"] == "" and found["digits"] else -digits), shift
    if found := _FACTOR.search(said):
        return _written(found), shift
    if found := _BARE_POWER.search(_RANGE.sub(" ", said)):
        return _power(int(found["exponent"])), shift
    return None, shift


def _fixdt(first: str | None, second: str | None) -> tuple[float | int | None, float | int | None]:
    """`fixdt(1, 16, 8)` has 8 binary digits behind the point; `fixdt(1, 16, 0.01, -40)` a slope and a bias."""
    if first is None:
        return None, None
    slope = _power(int(first[2:])) if first.startswith("2^") else number(first)
    if second is not None:
        return slope, number(second)
    return _power(-int(slope)) if float(slope).is_integer() and abs(slope) < 100 else slope, None


def _power(exponent: int) -> float | int:
    return _plain(Fraction(2) ** exponent) if abs(exponent) <= 128 else 1


def _written(found: "re.Match[str]") -> float | int:
    if found["exponent"]:
        return _power(int(found["exponent"]))
    if found["divisor"]:
        return _plain(1 / Fraction(found["divisor"])) if Fraction(found["divisor"]) else 1
    return number(found["plain"])


_SAID = (_FIXDT, _UNIT, _RANGE, _MIN, _MAX, _FACTOR, _BARE_POWER, _BINARY, _OFFSET)


def _description(said: str) -> str:
    """Return the rest of a comment without the parts that are understood, if it has a word."""
    rest = _rest(said)
    return rest.translate(_SHOWN) if re.search(r"[^\W\d_]{2}", rest) else ""


def _rest(said: str) -> str:
    for pattern in _SAID:
        said = pattern.sub(" ", said)
    said = " ".join(re.sub(r"\(\s*\)|\[\s*\]", " ", said).split())
    return said.strip(" ,;:.-*")
