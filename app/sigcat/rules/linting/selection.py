"""Rules that run: those that sigcat ships and those of a company, as the options select them."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from sigcat import codes
from sigcat.catalogue.reading.toml_lines import Lines
from sigcat.errors import InputRefused, SigcatError, UsageError
from sigcat.findings import SEVERITIES, Finding
from sigcat.names import did_you_mean
from sigcat.real_path import real_path
from sigcat.rules.checks import CHECKS
from sigcat.rules.checks.kind import BadOption, check_options
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.linting.options import LintOptions
from sigcat.rules.linting.severity import OFF, as_severity, most_specific
from sigcat.rules.record import Rule, load_rule_files
from sigcat.rules.rule_set import RuleSet


def rules_for(options: LintOptions) -> tuple[Rule, ...]:
    """Every rule that sigcat ships and the configuration names, with the options of the configuration.

    Raises InputRefused if a rule file cannot be used, UsageError if the options name what does not exist.
    """
    shipped = compiled_rules(options.rule_folder)
    own = load_rule_files(options.rule_files, trusted=False, tried=_findings_about) if options.rule_files else ()
    if findings := tuple(taken(own, shipped)):
        raise InputRefused("The rules cannot be used.", findings)
    rules = {rule.id: rule for rule in (*shipped, *own)}
    for code, given in options.rule_options.items():
        if code not in rules:
            raise _refused_option(options, code, "", f"Unknown rule {code!r}.", did_you_mean(code, rules))
        rules[code] = _with_options(rules[code], given, options)
    return tuple(rules.values())


def taken(own: Iterable[Rule], shipped: Iterable[Rule]) -> Iterator[Finding]:
    """A finding for each rule with the code or name of another one that sigcat ships, which it would replace."""
    codes_of = {rule.id: rule for rule in shipped}
    names_of = {rule.name: rule for rule in codes_of.values()}
    for rule in own:
        other = codes_of.get(rule.id) or names_of.get(rule.name)
        if other is not None and real_path(Path(other.file)) != real_path(Path(rule.file)):
            what = f"code {rule.id}" if rule.id == other.id else f"name {rule.name!r}"
            message = f"sigcat has a rule with the {what} already: {other.title}"
            fix = "Choose another one, such as ACME001." if rule.id == other.id else "Choose another one."
            yield codes.RULE_UNUSABLE.finding(message, rule.file, rule.line, 1, rule.id, fix=fix)


def _findings_about(rules: Iterable[Rule]) -> tuple[Finding, ...]:
    return RuleSet(rules).findings


def _with_options(rule: Rule, given: Mapping[str, Any], options: LintOptions) -> Rule:
    """The rule with the options that a configuration gives it. Raises InputRefused, or UsageError without a file."""
    check = CHECKS.get(rule.check)
    if check is None:
        raise _refused_option(options, rule.id, "", f"Rule {rule.id} has no options.")
    changed = rule._replace(options={**rule.options, **given}, trusted=False)
    try:
        check_options(changed, check)
    except BadOption as error:
        raise _refused_option(options, rule.id, error.option, str(error), error.fix) from None
    return changed


def _refused_option(options: LintOptions, code: str, name: str, message: str, fix: str = "") -> SigcatError:
    """The error to raise for an option of `[lint.options]`: a finding at its line, where there is a file."""
    if options.file is None:
        return UsageError(f"{message} {fix}".strip())
    key = ".".join(filter(None, ("options", code, name)))
    at = Lines(options.file.read_text(encoding="utf-8")).position_below(_table_of(options.file), key)
    finding = codes.CONFIGURATION_UNUSABLE.finding(message, str(options.file), *at, path=key, fix=fix)
    return InputRefused(f"The configuration {str(options.file)!r} cannot be used.", (finding,))


def _table_of(file: Path) -> str:
    return "tool.sigcat.lint" if file.name == "pyproject.toml" else "lint"


def selected(rules: Sequence[Rule], options: LintOptions) -> tuple[Rule, ...]:
    """The rules that run, with the severities that hold everywhere. Raises UsageError for a code that matches none."""
    _refuse_unknown(rules, options)
    active = []
    for rule in rules:
        severity = most_specific(rule.id, options.severities)
        if _runs(rule, options, severity):
            active.append(rule._replace(severity=severity) if severity in SEVERITIES else rule)
    return tuple(active)


def _runs(rule: Rule, options: LintOptions, severity: str | None) -> bool:
    """Whether a rule runs. One that is selected by its whole code runs even where `ignore` has the start of it."""
    if _starts(rule, options.ignore):
        return rule.id in options.select or rule.id in options.extend_select
    if _starts(rule, options.extend_select):
        return True
    if options.select:
        return _starts(rule, options.select) or _is_always_told(rule)
    return rule.default if severity is None else severity != OFF


def _starts(rule: Rule, beginnings: Sequence[str]) -> bool:
    return any(rule.id.startswith(beginning) for beginning in beginnings)


def _is_always_told(rule: Rule) -> bool:
    """A file that cannot be read, or a rule that cannot be used, is reported whatever was selected: it checks nothing."""
    is_about_reading = rule.check == "composition" and rule.category == "reading"
    return is_about_reading or rule.id in (codes.RULE_UNUSABLE.id, codes.RULE_TOO_SLOW.id)


def _refuse_unknown(rules: Sequence[Rule], options: LintOptions) -> None:
    known = [rule.id for rule in rules]
    _refuse_unknown_in_file(known, options)
    by_file = [code for entry in options.per_file for code in entry.severities]
    for named in (*options.select, *options.ignore, *options.extend_select, *options.severities, *by_file):
        if not _is_known(named, known):
            raise UsageError(f"No rule has the code {named!r}. {did_you_mean(named, known)}".strip())
    for severity in options.severities.values():
        if severity != OFF:
            as_severity(str(severity))


def _refuse_unknown_in_file(known: Sequence[str], options: LintOptions) -> None:
    """Raise InputRefused for codes that match no rule in the tables of severities, which only a file has."""
    tables = {"severity": options.severities, **{f"per-file.{each.glob}": each.severities for each in options.per_file}}
    unknown = [(f"{key}.{code}", code) for key, table in tables.items() for code in table if not _is_known(code, known)]
    lists = {"select": options.select, "ignore": options.ignore, "extend-select": options.extend_select}
    listed = [(key, code) for key, codes_of in lists.items() for code in codes_of if not _is_known(code, known)]
    if options.file is None or not (unknown or listed):
        return
    lines = Lines(options.file.read_text(encoding="utf-8"))
    table = _table_of(options.file)
    unknown += [(key, code) for key, code in listed if lines.has_value(table, key, code)]  # others are of the command
    if not unknown:
        return
    findings = [
        codes.CONFIGURATION_UNUSABLE.finding(
            f"No rule has the code {code!r}.",
            str(options.file),
            *(lines.position(table, 0, key, code) if key in lists else lines.position_below(table, key)),
            path=key,
            fix=did_you_mean(code, known),
        )
        for key, code in unknown
    ]
    raise InputRefused(f"The configuration {str(options.file)!r} cannot be used.", tuple(findings))


def _is_known(named: str, known: Sequence[str]) -> bool:
    return bool(named) and any(code.startswith(named) for code in known)
