"""Which rules run, and how severe their findings are."""

from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatchcase
from pathlib import Path, PurePath
from typing import Any

from sigcat.errors import UsageError
from sigcat.findings import SEVERITIES, Finding, Severity
from sigcat.names import did_you_mean
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.linting.options import LintOptions, PerFile
from sigcat.rules.record import Rule, load_rule_files

OFF = "off"


def rules_for(options: LintOptions) -> tuple[Rule, ...]:
    """Every rule that sigcat ships and the configuration names, with the options of the configuration.

    Raises InputRefused if a rule file cannot be used, UsageError if the options name what does not exist.
    """
    shipped = compiled_rules(options.rule_folder)
    own = load_rule_files(options.rule_files, trusted=False) if options.rule_files else ()
    rules = {rule.id: rule for rule in (*shipped, *own)}
    for code, given in options.rule_options.items():
        if code not in rules:
            raise UsageError(f"There is no rule {code!r}. {did_you_mean(code, rules)}".strip())
        rules[code] = _with_options(rules[code], given)
    return tuple(rules.values())


def _with_options(rule: Rule, given: Mapping[str, Any]) -> Rule:
    """The rule with the options that a configuration gives it. Raises UsageError."""
    from sigcat.rules.checks import CHECKS
    from sigcat.rules.checks.kind import BadOption, check_options

    changed = rule._replace(options={**rule.options, **given}, trusted=False)
    check = CHECKS.get(rule.check)
    if check is None:
        raise UsageError(f"Rule {rule.id} has no options.")
    try:
        check_options(changed, check)
    except BadOption as error:
        raise UsageError(f"{error} {error.fix}".strip()) from None
    return changed


def chosen(rules: Sequence[Rule], options: LintOptions) -> tuple[Rule, ...]:
    """The rules that run, with the severities that hold everywhere. Raises UsageError for a code that matches none."""
    _refuse_unknown(rules, options)
    active = []
    for rule in rules:
        severity = most_specific(rule.id, options.severities)
        if runs(rule, options, severity):
            active.append(rule._replace(severity=severity) if severity in SEVERITIES else rule)
    return tuple(active)


def runs(rule: Rule, options: LintOptions, severity: str | None) -> bool:
    """Whether a rule runs. What cannot be read is told whatever was selected, unless it is ignored by its code."""
    by_selection = any(rule.id.startswith(code) for code in options.select) if options.select else rule.default
    if options.select and rule.check == "composition" and rule.id.startswith("R"):
        by_selection = True
    if any(rule.id.startswith(code) for code in options.extend_select):
        by_selection = True
    elif not options.select and severity is not None:
        by_selection = severity != OFF
    if any(rule.id.startswith(code) for code in options.ignore):
        return rule.id in options.select or rule.id in options.extend_select
    return by_selection


def graded(finding: Finding, per_file: Iterable[PerFile], root: Path) -> Finding | None:
    """The finding with the severity that its file gives its rule; None where the rule is off."""
    for entry in per_file:
        if matches(finding.file, entry.glob, root):
            severity = most_specific(finding.rule, entry.severities)
            if severity == OFF:
                return None
            if severity is not None:
                finding = finding._replace(severity=as_severity(severity))
    return finding


def matches(file: str, glob: str, root: Path) -> bool:
    """Whether a file matches a glob relative to `root`; a folder stands for all below it."""
    path = Path(file)
    try:
        name = path.resolve().relative_to(root.resolve()).as_posix()
    except ValueError:
        name = PurePath(file).as_posix()
    plain = glob.rstrip("/")
    return fnmatchcase(name, plain) or fnmatchcase(name, f"{plain}/*") or PurePath(name).match(plain)


def most_specific(code: str, severities: Mapping[str, Any]) -> str | None:
    """The severity of the longest key that `code` starts with."""
    keys = [key for key in severities if code.startswith(key)]
    return str(severities[max(keys, key=len)]) if keys else None


def as_severity(text: str) -> Severity:
    """A severity from a configuration. Raises UsageError."""
    for severity in SEVERITIES:
        if severity == text:
            return severity
    hint = did_you_mean(text, (*SEVERITIES, OFF))
    raise UsageError(f"{text!r} is no severity: use {', '.join(SEVERITIES)} or {OFF}. {hint}".strip())


def _refuse_unknown(rules: Sequence[Rule], options: LintOptions) -> None:
    codes = [rule.id for rule in rules]
    by_file = [code for entry in options.per_file for code in entry.severities]
    for named in (*options.select, *options.ignore, *options.extend_select, *options.severities, *by_file):
        if not named or not any(code.startswith(named) for code in codes):
            raise UsageError(f"No rule has the code {named!r}. {did_you_mean(named, codes)}".strip())
    for severity in options.severities.values():
        if severity != OFF:
            as_severity(str(severity))
