"""Interfaces that lead back to themselves."""

from collections.abc import Iterable, Mapping

from sigcat.function.document.problem import Kind, Subject

Circle = tuple[Subject, ...]


def circles(following: Mapping[str, Iterable[str]], kind: Kind, attribute: str) -> Mapping[str, Circle]:
    """The members of each circle, by the name of each of them. `attribute` is the one that leads on.

    Each name is visited twice at most, however long the chains are (Kosaraju).
    """
    seen: set[str] = set()
    finished = [name for start in following if start not in seen for name in _visited(start, following, seen)]
    before: dict[str, list[str]] = {}
    for name, targets in following.items():
        for target in targets:
            before.setdefault(target, []).append(name)
    seen = set()
    groups = [_visited(start, before, seen) for start in reversed(finished) if start not in seen]
    closed = (group for group in groups if len(group) > 1 or group[0] in following.get(group[0], ()))
    found = [tuple(Subject(kind, name, (attribute,)) for name in group) for group in closed]
    return {subject.name: circle for circle in found for subject in circle}


def _visited(start: str, following: Mapping[str, Iterable[str]], seen: set[str]) -> list[str]:
    """Return the names reached from a name and not seen before, each after all that it leads to."""
    seen.add(start)
    done: list[str] = []
    waiting = [(start, iter(following.get(start, ())))]
    while waiting:
        name, rest = waiting[-1]
        step = next((each for each in rest if each not in seen), None)
        if step is None:
            done.append(name)
            waiting.pop()
        else:
            seen.add(step)
            waiting.append((step, iter(following.get(step, ()))))
    return done
