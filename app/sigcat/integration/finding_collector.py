"""What `derive` finds on its way, gathered while it builds a document."""

from dataclasses import dataclass, field

from sigcat.findings import Finding, RuleCode


@dataclass
class FindingCollector:
    """Findings in the order in which they were reported, each once."""

    _found: dict[Finding, None] = field(default_factory=dict)

    def report(self, rule: RuleCode, message: str, path: str = "", fix: str = "") -> None:
        """Report one about an interface, or whatever else `path` names."""
        self._found[rule.finding(message, path=path, fix=fix)] = None

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All of them."""
        return tuple(self._found)
