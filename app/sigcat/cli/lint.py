"""`sigcat lint [PATH...]`."""

import argparse
import gc
import os
import sys
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.closed_streams import input_bytes, is_closed_output
from sigcat.cli.output import could_not_run, discard_output, write_text
from sigcat.cli.output_options import FORMATS, add_output, refuse_overwriting
from sigcat.cli.project_options import add_project_options, project_of
from sigcat.cli.tree_options import add_dbc, add_many, tree_options
from sigcat.errors import InputRefused, UsageError, existing_file

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from sigcat.catalogue.hosting.source import Source
    from sigcat.catalogue.model.catalogue import Catalogue
    from sigcat.findings import Finding
    from sigcat.project.linting import ChosenLint
    from sigcat.project.project import Project
    from sigcat.rules.linting.options import CheckedFunctions, LintOptions, LintResult

_SERVICE = "service"
"""Table of the settings of the service."""
_INPUT, _INPUT_NAME = Path("-"), "standard input"


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "lint",
        help="check trees, overlays, function files and rule files",
        description=(
            "Check files and folders: trees, overlays (over the tree near them, or the shipped one), function files and "
            "rule files. Settings are in [lint] of the project file."
        ),
    )
    parser.add_argument(
        "paths",
        nargs="*",
        type=Path,
        metavar="PATH",
        help="files and folders; - for standard input (default: the folder of the project, else this one)",
    )
    _add_selection(parser)
    _add_context(parser)
    _add_result(parser)
    parser.set_defaults(run=lint)


def _add_selection(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("which rules run; a code may be cut short: V1 means all that start with it")
    for name, text in (
        ("--select", "only these"),
        ("--ignore", "not these"),
        ("--extend-select", "these beside the default set"),
    ):
        group.add_argument(name, metavar="CODE", action="append", default=[], help=f"{text}; several with commas")


def _add_context(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("what the files are checked against")
    group.add_argument(
        "-s", "--vspec", type=Path, metavar="TREE",
        help="tree that overlays and functions are made for: catalogue of the project, root .vspec file, a folder with one, "
        "or a pulled release (default: the first catalogue of the project; without one, of overlays the tree near them or "
        "the shipped one, of functions the shipped one)",
    )  # fmt: skip
    add_many(group, "-l", "--overlays", "overlay that applies below those that are checked, and below functions")
    add_many(group, "-I", "--include-dirs", "folder in which included files are looked for too", "FOLDER")
    add_many(group, "-u", "--units", "units, added to those of the tree")
    add_many(group, "-q", "--quantities", "quantities, added to those of the tree")
    add_many(group, "-t", "--types", "struct types")
    add_dbc(group, "CAN database (DBC) that mappings are checked against")
    add_project_options(group)


def _add_result(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("the result")
    group.add_argument("--format", choices=FORMATS, default="text", help="form of the report (default: %(default)s)")
    add_output(group, "-o", "--output", metavar="FILE", help="write the report here")
    group.add_argument("--fix", action="store_true", help="repair what is safe, changing no other byte")
    group.add_argument(
        "--unsafe-fixes", action="store_true", help="with --fix or --diff: repairs that change a meaning"
    )
    group.add_argument("--diff", action="store_true", help="show what --fix would change, and change nothing")
    group.add_argument("--baseline", type=Path, metavar="FILE", help="report only what this file does not list")
    add_output(group, "--write-baseline", metavar="FILE", help="write the present findings as known, and stop")
    group.add_argument(
        "--color",
        "--colour",
        choices=("auto", "always", "never"),
        default="auto",
        help="of text (default: %(default)s)",
    )


def lint(arguments: argparse.Namespace) -> int:
    """Report findings; 1 if any is more than a note. Raises UsageError where nothing could be linted."""
    was_enabled = gc.isenabled()
    gc.disable()  # loading and linting make no garbage worth the search for it
    try:
        return _lint(arguments)
    except InputRefused as error:  # the configuration, the rules or the baseline: nothing was linted
        raise could_not_run(error) from None
    finally:
        if was_enabled:
            gc.enable()


def _lint(arguments: argparse.Namespace) -> int:
    from sigcat.rules.linting.lint import lint_paths

    if arguments.unsafe_fixes and not (arguments.fix or arguments.diff):
        raise UsageError("--unsafe-fixes belongs to --fix or --diff: add one of them")
    start = arguments.paths[0] if arguments.paths else Path()
    project = project_of(arguments, start if start.is_dir() else start.parent, {_SERVICE: lambda table, _file: table})
    paths = arguments.paths or [_folder_of(project, arguments)]
    options = _chosen(arguments, project).options
    result = _lint_input(paths, project, arguments) if _INPUT in paths else lint_paths(paths, options)
    refuse_overwriting(arguments, (*result.files, *result.beside, *project.files, *_configured(options)))
    if arguments.write_baseline is not None:
        return _write_baseline(result, options, paths, arguments.write_baseline)
    if arguments.diff or arguments.fix:
        result = _repaired(result, arguments)
        if arguments.diff:
            return int(result.fails)
        result = lint_paths(paths, options)
    try:
        _report(result, options, arguments)
        sys.stdout.flush()
    except OSError as error:
        if not isinstance(error, BrokenPipeError) and not (is_closed_output(error) and result.fails):
            raise
        discard_output()  # the exit status is right even if the output is not read
    return int(result.fails)


def _folder_of(project: "Project", arguments: argparse.Namespace) -> Path:
    """The folder to lint where none is named: that of the project around the current one, else the current one."""
    if project.file is None or arguments.config is not None:
        return Path()
    return Path(os.path.relpath(project.file.parent))


def _lint_input(paths: "Sequence[Path]", project: "Project", arguments: argparse.Namespace) -> "LintResult":
    """Lint standard input: functions, a separate tree, or an overlay as it would be in this folder."""
    from sigcat.catalogue.hosting.source import load
    from sigcat.file_kind import holds_function, root_branch, root_name
    from sigcat.rules.linting.context import tree_near
    from sigcat.rules.linting.discovery import is_other_root
    from sigcat.rules.linting.options import LintResult
    from sigcat.rules.linting.posted import lint_text
    from sigcat.rules.linting.selection import rules_for, selected
    from sigcat.rules.rule_set import RuleSet

    options, tree = _chosen(arguments, project)
    needs_files = arguments.fix or arguments.diff or options.baseline or arguments.write_baseline
    if len(paths) > 1 or needs_files:
        raise UsageError("- is linted by itself, without --fix, --diff and baselines: name a file for these")
    text = input_bytes()
    if holds_function(text):
        checked = _check_functions(tree, project.functions, [(text, _INPUT_NAME)], is_whole=False, is_on_disk=False)
        findings, beside = tuple(checked.findings), checked.beside
    else:
        every_rule = rules_for(options)
        rules, known = RuleSet(selected(every_rule, options)), frozenset(rule.id for rule in every_rule)
        if options.base is None:
            options, tree = _chosen(arguments, project, tree_near(root_name(text), _INPUT.absolute()))
        is_tree = bool(own := root_branch(text)) and is_other_root(own, options.base)
        catalogue = load(tree)
        findings = lint_text(text, _INPUT_NAME, catalogue, rules, is_tree=is_tree, options=options, known=known)
        beside = _names(catalogue)
    return LintResult(tuple(findings), (), beside)


def _chosen(arguments: argparse.Namespace, project: "Project", near: Path | None = None) -> "ChosenLint":
    """Return the options with the command line laid over the project; `near` is the tree where neither names one."""
    from sigcat.project.linting import ChosenLint, chosen_lint

    given = tree_options(arguments)
    chosen = chosen_lint(project, given._replace(tree=str(near)) if near is not None else given)
    options = chosen.options
    options = options._replace(
        select=_codes(arguments.select) or options.select,
        ignore=options.ignore + _codes(arguments.ignore),
        extend_select=options.extend_select + _codes(arguments.extend_select),
        dbc=tuple(map(existing_file, arguments.dbc)) or options.dbc,
        baseline=arguments.baseline or (None if arguments.write_baseline else options.baseline),
        check_functions=partial(_check_functions, chosen.tree, project.functions),
        check_project=partial(_check_project, project) if project.vehicles or project.tables.get(_SERVICE) else None,
    )
    return ChosenLint(options, chosen.tree)


def _configured(options: "LintOptions") -> "Iterator[Path]":
    """The configuration and the files that it names."""
    yield from (path for path in (options.file, options.baseline, options.base) if path is not None)
    yield from (
        *options.rule_files,
        *options.overlays,
        *options.units,
        *options.quantities,
        *options.types,
        *options.dbc,
    )


def _codes(given: list[str]) -> tuple[str, ...]:
    return tuple(code.strip() for part in given for code in part.split(",") if code.strip())


def _check_functions(
    tree: "Source",
    folders: "Sequence[Path]",
    files: "Sequence[tuple[bytes, str]]",
    is_whole: bool,
    *,
    is_on_disk: bool = True,
) -> "CheckedFunctions":
    """Check function files against a tree; loaded only when there are any."""
    from sigcat.adapter.core.clashes import code_problems
    from sigcat.catalogue.hosting.source import load
    from sigcat.function.linting import checked_functions

    check_code = code_problems if is_on_disk else None
    return checked_functions(tree, files, is_whole, load_tree=load, check_code=check_code, folders=folders)


def _check_project(project: "Project") -> "Iterator[Finding]":
    """Yield the findings of the settings of the service and of vehicles; loaded only when there are any."""
    from sigcat.project.vehicles import vehicle_findings

    if project.file is not None and project.tables.get(_SERVICE):
        from sigcat.api.read_settings import read_settings
        from sigcat.project.read_project import read_project

        try:
            read_project(project.file, {_SERVICE: lambda table, file: read_settings(table, {}, file)})
        except InputRefused as error:
            yield from error.findings
    yield from vehicle_findings(project)


def _names(tree: "Catalogue") -> tuple[str, ...]:
    return tuple(file.name for file in tree.files)


def _write_baseline(result: "LintResult", options: "LintOptions", paths: "Sequence[Path]", file: Path) -> int:
    from sigcat.rules.linting.baseline import baseline_text

    write_text(baseline_text(result.findings, options.root, paths), file)
    print(f"{file}: {len(result.findings)} findings are known now", file=sys.stderr)
    return 0


def _repaired(result: "LintResult", arguments: argparse.Namespace) -> "LintResult":
    """Repair files, or show how; the caller reports the result."""
    from sigcat.rules.linting.fixes import fixed_files

    fixed = fixed_files(result.findings, result.repairs, _texts_of(result.findings), unsafe=arguments.unsafe_fixes)
    for file in fixed:
        if arguments.diff:
            sys.stdout.write(file.diff)
        else:
            write_text(file.after, Path(file.file))
    count = sum(len(file.settled) for file in fixed)
    verb = "could be" if arguments.diff else "were"
    print(f"sigcat: {count} of {len(result.findings)} findings {verb} repaired", file=sys.stderr)
    return result


def _texts_of(findings: "Sequence[Finding]") -> dict[str, str]:
    """Texts of the files that findings are about, byte for byte; a file that is not UTF-8 has nothing to repair."""
    texts = {}
    for name in filter(os.path.isfile, dict.fromkeys(finding.file for finding in findings)):  # a pipe would wait
        with suppress(OSError, ValueError):
            texts[name] = Path(name).read_bytes().decode("utf-8")
    return texts


def _report(result: "LintResult", options: "LintOptions", arguments: argparse.Namespace) -> None:
    from sigcat.rules.linting.counted import counted
    from sigcat.rules.linting.selection import rules_for
    from sigcat.rules.report import report, sources_of

    findings = tuple(counted(result.findings, result.counted))
    sources = sources_of(findings)
    rules = rules_for(options) if arguments.format == "sarif" else ()
    text = report(findings, arguments.format, sources, rules, colour=_is_coloured(arguments))
    write_text(text, arguments.output)


def _is_coloured(arguments: argparse.Namespace) -> bool:
    if arguments.color != "auto":
        return bool(arguments.color == "always")
    is_terminal = arguments.output is None and sys.stdout.isatty() and os.environ.get("TERM") != "dumb"
    return is_terminal and not os.environ.get("NO_COLOR")
