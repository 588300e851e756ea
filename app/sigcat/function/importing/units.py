"""The unit of the catalogue that a text in a comment means."""

from collections.abc import Iterable, Mapping

from sigcat.catalogue.model.vocabulary import Vocabulary

_SPELLED: Mapping[str, str] = {
    "%": "percent",
    "1/min": "rpm",
    "°": "degrees",
    "°/s": "degrees/s",
    "°c": "celsius",
    "amp": "a",
    "ampere": "a",
    "c": "celsius",
    "deg": "degrees",
    "deg/s": "degrees/s",
    "degc": "celsius",
    "deg_c": "celsius",
    "km_h": "km/h",
    "kmh": "km/h",
    "kmph": "km/h",
    "kph": "km/h",
    "km/hr": "km/h",
    "m/s2": "m/s^2",
    "m/s/s": "m/s^2",
    "m/s**2": "m/s^2",
    "m/s²": "m/s^2",
    "m_s": "m/s",
    "meter": "m",
    "meters": "m",
    "mps": "m/s",
    "mps2": "m/s^2",
    "msec": "ms",
    "n.m": "nm",
    "n*m": "nm",
    "n-m": "nm",
    "newton": "n",
    "pct": "percent",
    "sec": "s",
    "seconds": "s",
    "u/min": "rpm",
    "volt": "v",
    "volts": "v",
    "watt": "w",
}
"""Keys of units by their spellings in code, in small letters."""


def unit_of(texts: Iterable[str], vocabulary: Vocabulary) -> str:
    """The key of the first text that is a unit; empty if none is."""
    for text in texts:
        unit = vocabulary.unit(text) or vocabulary.unit(_SPELLED.get(text.lower(), ""))
        if unit is not None:
            return unit.key
    return ""


def without_unit(text: str, texts: Iterable[str], vocabulary: Vocabulary) -> str:
    """A description without the unit that it begins with, or has in brackets: of `m/s: speed` and `speed [m/s]` `speed`."""
    for each in texts:
        if f"[{each}]" in text and unit_of([each], vocabulary):
            return " ".join(text.replace(f"[{each}]", " ").split()).strip(" ,;:")
        rest = text.removeprefix(each)
        if rest != text and not rest[:1].isalnum() and unit_of([each], vocabulary):
            return rest.lstrip(" ,;:")
    return text
