"""Changes where a lock keeps the numbers of Protocol Buffers: positions have no effect on these."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from sigcat.catalogue.comparing.changes import Change
from sigcat.catalogue.exporting.field_numbers import Lock
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.names import parent_path

_Kept = Callable[[str], bool]
"""Whether the lock has all numbers of a branch, struct or signal of the old tree."""


def with_kept_numbers(changes: Iterable[Change], old: Catalogue, lock: Lock) -> Sequence[Change]:
    """Return the changes without effects of positions, where the lock has the numbers with which the old tree was exported."""

    def has_fields(path: str) -> bool:
        node = old.nodes.get(path)
        return node is not None and all(child.name in lock.messages.get(path, {}) for child in node.children)

    def has_labels(path: str) -> bool:
        node = old.nodes.get(path)
        known = lock.enumerations.get(path, ())
        return node is not None and all(str(label) in known for label in node.values.get("allowed") or ())

    return [_without_effects(change, has_fields, has_labels) for change in changes]


def _without_effects(change: Change, has_fields: _Kept, has_labels: _Kept) -> Change:
    before = change.former_paths or change.paths
    branches = {parent_path(path) for path in _new_paths(change)}
    is_kept: Mapping[str, bool] = {
        **dict.fromkeys(("added-before", "position-unknown"), all(map(has_fields, branches))),
        "fields-renumbered": all(map(has_fields, before)),
        "enumeration-renumbered": all(map(has_labels, before)),
    }
    return change._replace(effects=tuple(effect for effect in change.effects if not is_kept.get(effect, False)))


def _new_paths(change: Change) -> Iterator[str]:
    """Topmost paths that the change adds."""
    yield from change.paths if change.kind == "added" else ()
    yield from change.came
