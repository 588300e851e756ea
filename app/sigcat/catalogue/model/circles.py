"""Names that lead back to themselves."""

from collections.abc import Iterable, Mapping


def circles(following: Mapping[str, Iterable[str]]) -> list[list[str]]:
    """Return the members of each circle.

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
    return [group for group in groups if len(group) > 1 or group[0] in following.get(group[0], ())]


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
