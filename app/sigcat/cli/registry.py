"""`sigcat registry`: list, show and change the registry, record deployments, verify, export and import."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.output import make_folder, write_bytes, write_lines, write_text
from sigcat.cli.output_options import add_output, refuse_overwriting
from sigcat.cli.registry_approvals import add_approvals
from sigcat.cli.registry_deprecations import add_deprecations
from sigcat.cli.registry_events import add_events
from sigcat.cli.registry_options import (
    KINDS,
    Actions,
    access_of,
    add_action,
    add_report,
    add_server,
    add_version,
    done,
    needing_extra,
    print_more,
    print_report,
    read_registry,
    registry_of,
)
from sigcat.cli.registry_tokens import add_tokens
from sigcat.cli.registry_webhooks import add_webhooks
from sigcat.errors import InputRefused, UsageError, existing_file
from sigcat.limits import REGISTRY_ROWS
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from sigcat.registry.access.access import Access
    from sigcat.registry.reference import Reference, State

_RULES = ("backward", "full", "approval", "none")


def add_parser(commands: Actions) -> None:
    """Add the command with its actions."""
    parser = commands.add_parser("registry", help="list, record, verify, export and import what is published")
    actions = parser.add_subparsers(title="actions", metavar="ACTION")
    _add_reading(actions)
    _add_states(actions)
    add_approvals(actions)
    add_deprecations(actions)
    _add_lines(actions)
    _add_transfer(actions)
    add_tokens(actions)
    add_events(actions)
    add_webhooks(actions)


def _add_reading(actions: Actions) -> None:
    listing = add_action(actions, "list", "list versions with their states, owners and vehicle lines", list_versions)
    listing.add_argument("--kind", choices=KINDS, help="only this kind")
    add_server(listing)
    listing.add_argument("--line", metavar="LINE", help="only what vehicles of this line run")
    showing = add_action(actions, "show", "print the published bytes of a version", show)
    add_version(showing)
    add_server(showing)
    showing.add_argument("--resolved", action="store_true", help="print its Function JSON, or its nodes")
    add_output(showing, "-o", "--output", metavar="FILE", help="write here instead of to standard output")
    verifying = add_action(actions, "verify", "check the log, its signatures and all content", verify)
    verifying.add_argument("--public-key", type=Path, metavar="FILE", help="Ed25519 key (default: that of the project)")
    verifying.add_argument("--head", metavar="HASH", default="", help="entry that must be in the log")
    add_report(verifying)


def _add_states(actions: Actions) -> None:
    deprecating = add_action(actions, "deprecate", "mark a version as deprecated", deprecate)
    add_version(deprecating)
    add_server(deprecating)
    deprecating.add_argument("--until", metavar="DATE", help="day on which its support may end")
    deprecating.add_argument("--successor", metavar="V", help="version that replaces it")
    retiring = add_action(actions, "retire", "mark a version as retired, which no vehicle runs", retire)
    add_version(retiring)
    add_server(retiring)
    ruling = add_action(actions, "rule", "set the rule that new versions of a name follow", rule)
    add_server(ruling)
    ruling.add_argument("name", metavar="NAME", help="published name")
    ruling.add_argument("rule", choices=_RULES, metavar="RULE", help=", ".join(_RULES))
    ruling.add_argument("--kind", choices=KINDS, default="function", help="default: %(default)s")


def _add_lines(actions: Actions) -> None:
    for name, text, action in (
        ("record-deployment", "record that all vehicles of a line run a version, in place of others", "deployment"),
        ("record-release", "record a version beside those that vehicles of a line keep", "release"),
        ("support-ended", "record that no vehicle of a line runs a version any more", "support ended"),
    ):
        parser = add_action(actions, name, text, record)
        parser.add_argument("line", metavar="LINE", help="vehicle line")
        parser.add_argument("version", metavar="FUNC@V", help="published version of a function")
        add_server(parser)
        parser.set_defaults(action=action)


def _add_transfer(actions: Actions) -> None:
    exporting = add_action(actions, "export", "write everything as lines of JSON", export)
    exporting.add_argument(
        "--backstage", action="store_true", help="write functions, owners and APIs as catalog-info.yaml of Backstage"
    )
    add_output(exporting, "-o", "--output", metavar="FILE", help="write here instead of to standard output")
    importing = add_action(actions, "import", "read an export into an empty registry", import_file)
    importing.add_argument("file", type=Path, metavar="FILE", help="export")
    making = add_action(actions, "new-key", "make a key that signs the log", new_key)
    making.add_argument(
        "file", type=Path, metavar="FILE", help="file of the private key; the public one ends with .pub"
    )


def list_versions(arguments: argparse.Namespace) -> int:
    """Print a line for each version."""
    found = access_of(arguments).all_versions(arguments.kind)
    listed = [each for each in found if arguments.line is None or arguments.line in each.lines]
    print_more(len(listed))
    for published, lines in listed[:REGISTRY_ROWS]:
        owner = f", owner {published.owner}" if published.owner else ""
        where = f", in line {', '.join(lines)}" if lines else ""
        named = f"{published.kind} {published.reference}"
        print(printable(f"{named}: {published.state}{published.end}{owner}{where}"))
    return 0


def show(arguments: argparse.Namespace) -> int:
    """Write the bytes of a version."""
    access = access_of(arguments)
    from sigcat.registry.reference import reference_of

    reference = reference_of(arguments.version)
    write_bytes(access.content(arguments.kind, reference, is_resolved=arguments.resolved), arguments.output)
    return 0


def verify(arguments: argparse.Namespace) -> int:
    """Report what was changed; 1 if anything was."""
    registry = registry_of(arguments)
    with read_registry(arguments) as connection:
        from sigcat.registry.storing.verify import verify as verify_all

        checked = verify_all(connection, arguments.public_key or registry.key, arguments.head)
    print_report(checked.findings, arguments.format, arguments.output)
    if not checked.findings:
        entries = f"{checked.entries} {'entry' if checked.entries == 1 else 'entries'}"
        print(f"verified: {entries}, head {checked.head or 'none'}", file=sys.stderr)
    return int(bool(checked.findings))


def deprecate(arguments: argparse.Namespace) -> int:
    """Deprecate a version."""
    for option in ("until", "successor"):
        if getattr(arguments, option) == "":
            raise UsageError(f"--{option} must not be empty; without it, the version has none")
    return _set_state(arguments, "deprecated", arguments.until or "", arguments.successor or "")


def retire(arguments: argparse.Namespace) -> int:
    """Retire a version."""
    return _set_state(arguments, "retired")


def _set_state(arguments: argparse.Namespace, state: "State", until: str = "", successor: str = "") -> int:
    access = access_of(arguments)
    from sigcat.registry.reference import reference_of

    reference = reference_of(arguments.version)
    change = access.set_state(arguments.kind, reference, state, until, successor)
    return done(f"{arguments.kind} {reference}: {state}", change)


def rule(arguments: argparse.Namespace) -> int:
    """Set the rule of a name."""
    change = access_of(arguments).set_rule(arguments.kind, arguments.name, arguments.rule)
    return done(f"{arguments.kind} {arguments.name}: rule {arguments.rule}", change)


def record(arguments: argparse.Namespace) -> int:
    """Record a deployment, a release or the end of support."""
    access = access_of(arguments)
    from sigcat.registry.reference import reference_of

    reference = reference_of(arguments.version)
    doubts = () if arguments.action == "support ended" else _doubts(access, arguments.line, reference)
    change = access.record(arguments.action, arguments.line, reference)
    for doubt in doubts:
        print(printable(f"warning: {doubt}"), file=sys.stderr)
    return done(f"line {arguments.line}: {arguments.action} of {reference}", change)


def _doubts(access: "Access", line: str, reference: "Reference") -> tuple[str, ...]:
    """Return why a record may be a mistake: the line is new, or the version does not fit it. A record says what is so."""
    from sigcat.registry.reference import name_problem

    if name_problem(line, "line") is not None:
        return ()  # it is refused
    try:
        answer = access.can_deploy([reference], line)
    except (InputRefused, UsageError):
        return ()  # the record is refused too, or the token is for changes only
    if answer.decision == "unknown":
        near = answer.finding.fix if answer.finding and answer.finding.fix.startswith("Did you mean") else ""
        return (f"line {line} is new. {near}".rstrip(),)
    if answer.decision == "no":
        advice = f"see `sigcat can-i-deploy {reference.name}@{reference.version} --to {line}`"
        return (f"{reference} does not fit what line {line} runs: {advice}",)
    return ()


def export(arguments: argparse.Namespace) -> int:
    """Write the export."""
    registry = registry_of(arguments)
    refuse_overwriting(arguments, (each for each in registry if isinstance(each, Path)))
    with read_registry(arguments) as connection:
        if arguments.backstage:
            from sigcat.registry.backstage import backstage_entities, written

            write_text(written(backstage_entities(connection)), arguments.output)
            return 0
        from sigcat.registry.storing.transfer import exported

        write_lines(exported(connection), arguments.output)
    return 0


def import_file(arguments: argparse.Namespace) -> int:
    """Read the export."""
    registry = registry_of(arguments)
    from sigcat.registry.access.access import Change
    from sigcat.registry.storing.transfer import import_lines

    with existing_file(arguments.file).open("rb") as lines:
        head = import_lines(registry.database, lines, str(arguments.file))
    return done(f"{arguments.file}: imported", Change(head, is_signed=registry.key is not None))


def new_key(arguments: argparse.Namespace) -> int:
    """Write a new pair of keys; a file that exists is never replaced."""
    with needing_extra():
        from sigcat.registry.storing.signing import new_key as make_key
    public = arguments.file.with_name(f"{arguments.file.name}.pub")
    for file in (arguments.file, public):
        if file.exists() or file.is_symlink():  # a link may lead to no file
            raise UsageError(f"{file} is there already")
    private_text, public_text = make_key()
    make_folder(arguments.file.parent)
    arguments.file.touch(mode=0o600)
    write_bytes(private_text, arguments.file)
    write_bytes(public_text, public)
    print(f"{public}: pass it to everyone that verifies the log", file=sys.stderr)
    return 0
