"""Messages and fixes that rules write themselves: templates in, texts and their faults out."""

import re
from collections.abc import Iterator, Mapping
from typing import Any

from sigcat.names import did_you_mean

_PLACEHOLDER = r"\{(\w+)(!r)?\}"
_NEARLY_PLACEHOLDER = r"\{([^{}\s]*)\}"
"""Braces around text without a space, as other languages fill them; `{min: 0}` stays as it is."""
OF_EVERY_CHECK = ("path", "name")
"""Facts of every problem."""
_OF_CHECKS: Mapping[str, tuple[str, ...]] = {
    "name": ("proposal", "prefixes"),
    "instance-name": ("proposal",),
    "text": ("attribute", "value"),
    "required": ("attribute",),
    "filled": ("attribute",),
    "forbidden": ("attribute",),
    "implied": ("attribute", "value", "missing"),
    "known-attributes": ("attribute",),
    "required-fields": ("attribute",),
    "field-values": ("attribute", "value"),
    "overlay-changes": ("attribute",),
    "reference": ("attribute",),
    "deprecated-unit": ("unit",),
    "unique-path": ("other",),
    "reserved-word": ("converted",),
    "converted-name": ("converted",),
    "collision": ("converted",),
}
"""Facts of the problems that a check yields."""


def placeholders(check: str) -> tuple[str, ...]:
    """The placeholders of a rule with this check."""
    return (*OF_EVERY_CHECK, *_OF_CHECKS.get(check, ()))


def filled(template: str, facts: Mapping[str, Any]) -> str:
    """A template with its facts. Plain names only: a template cannot reach into objects."""

    def fact(match: re.Match[str]) -> str:
        if match[1] not in facts:
            return match[0]
        value = facts[match[1]]
        return repr(value) if match[2] else str(value)

    return re.sub(_PLACEHOLDER, fact, template)


def template_faults(template: str, check: str) -> Iterator[tuple[str, str]]:
    """Each fault of a template: the end of a sentence about it, and a fix."""
    if not _is_balanced(template):
        yield "has a brace without its other half", "Write placeholders such as {name} or {name!r}."
        return
    known = placeholders(check)
    for match in re.finditer(_NEARLY_PLACEHOLDER, template):
        name = re.fullmatch(_PLACEHOLDER, match[0])
        if name is None or name[1] not in known:
            meant = did_you_mean(name[1], known) if name else ""
            fix = f"{meant} Use one of {', '.join(f'{{{each}}}' for each in known)}, with !r for quotation marks."
            yield f"has the unknown placeholder {match[0][:60]}", fix.lstrip()


def _is_balanced(template: str) -> bool:
    depth = 0
    for brace in re.findall(r"[{}]", template):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            return False
    return depth == 0
