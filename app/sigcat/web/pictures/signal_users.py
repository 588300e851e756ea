"""A signal between the functions that provide it and those that use it. Units are pixels."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat.registry.use import PROVIDING
from sigcat.registry.users import User

_MOST = 12
"""Boxes on each side."""
_LONGEST = 30
_LETTER, _AROUND = 7.3, 24
_ROW, _HEIGHT, _GAP, _MARGIN = 38, 28, 70, 10


class UserBox(NamedTuple):
    """A function, or the signal in the middle."""

    x: float
    y: float
    width: float
    label: str
    title: str
    function: str
    """Name of the function; empty for the signal, and for functions that are not shown."""


class UserPicture(NamedTuple):
    """Positions of all elements."""

    boxes: tuple[UserBox, ...]
    middle: UserBox
    arrows: tuple[str, ...]
    """Path data of SVG."""
    width: float
    height: float
    summary: str


def user_picture(path: str, users: Sequence[User]) -> UserPicture | None:
    """Return the picture of the direct users of a signal; None without any."""
    direct = [user for user in users if not user.through]
    left = _labels(user for user in direct if user.use.verb in PROVIDING)
    right = _labels(user for user in direct if user.use.verb not in PROVIDING)
    if not direct:
        return None
    rows = max(len(left), len(right), 1)
    height = rows * _ROW + 2 * _MARGIN
    left_width, right_width = _width(left), _width(right)
    name = _cut(path.rpartition(".")[2])
    at = _MARGIN + (left_width + _GAP if left else 0)
    middle = UserBox(at, (height - _HEIGHT) / 2, len(name) * _LETTER + _AROUND, name, path, "")
    after = at + middle.width + _GAP
    providers = _column(left, _MARGIN, left_width, height)
    consumers = _column(right, after, right_width, height)
    centre = middle.y + _HEIGHT / 2
    arrows = (
        *(_curve(box.x + box.width, box.y + _HEIGHT / 2, middle.x, centre) for box in providers),
        *(_curve(middle.x + middle.width, centre, box.x, box.y + _HEIGHT / 2) for box in consumers),
    )
    width = (after + right_width if right else at + middle.width) + _MARGIN
    return UserPicture((*providers, *consumers), middle, arrows, width, height, _summary(path, left, right))


def _labels(users: Iterable[User]) -> list[tuple[str, str]]:
    """Name and label of each version, each once; the last one says how many are not shown."""
    found = list(dict.fromkeys((user.published.name, str(user.published.reference)) for user in users))
    rest = len(found) - _MOST
    return found if rest <= 0 else [*found[:_MOST], ("", f"{rest} more")]


def _column(labels: Sequence[tuple[str, str]], x: float, width: float, height: float) -> list[UserBox]:
    top = (height - len(labels) * _ROW) / 2 + (_ROW - _HEIGHT) / 2
    return [UserBox(x, top + i * _ROW, width, _cut(label), label, name) for i, (name, label) in enumerate(labels)]


def _width(labels: Iterable[tuple[str, str]]) -> float:
    return max((len(_cut(label)) for _, label in labels), default=0) * _LETTER + _AROUND


def _cut(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def _curve(x1: float, y1: float, x2: float, y2: float) -> str:
    middle = (x1 + x2) / 2
    return f"M{x1:g} {y1:g} C{middle:g} {y1:g} {middle:g} {y2:g} {x2:g} {y2:g}"


def _summary(path: str, left: Sequence[tuple[str, str]], right: Sequence[tuple[str, str]]) -> str:
    providers = ", ".join(label for _, label in left) or "no published function"
    consumers = ", ".join(label for _, label in right) or "no published function"
    return f"{path}: provided by {providers}; used by {consumers}"
