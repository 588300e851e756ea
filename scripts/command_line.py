"""The page of the command line, docs/reference/command-line.md, made from the parsers."""

import argparse
from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby

from sigcat.cli import parser_of

PAGE = "docs/reference/command-line.md"
_HEAD = """\
# Command line

Made from the parsers by `make generate`. `sigcat COMMAND --help` prints the same.

A command ends with status 0 where it is done, or finds nothing worse than a note (`info`); 1 with findings, also those of a tree,
a function or a document of which nothing is made then; with changes that `diff --fail-on` names, or where `search` finds nothing; 2 where
it could not run: an option, a path, an archive or the configuration cannot be used. With `SIGCAT_DEBUG=1` an internal error shows its traceback."""
_TREE = "the tree"
"""The group of options that most commands share: it is shown once."""
_UNNAMED = ("positional arguments", "options")


def files() -> Mapping[str, str]:
    """The page."""
    parsers = command_parsers()
    tree = next(group for parser in parsers for group in _groups(parser) if group.title == _TREE)
    shared = f"## The tree\n\nOptions of every command that reads a tree.\n\n{_table(_options(tree))}"
    return {PAGE: "\n\n".join([_HEAD, _index(parsers), shared, *map(_section, parsers)]) + "\n"}


def command_parsers() -> list[argparse.ArgumentParser]:
    """The parser of every command that can be run, such as `sigcat export json`."""
    return list(_leaves(parser_of("")))


def _leaves(parser: argparse.ArgumentParser) -> Iterator[argparse.ArgumentParser]:
    """The parsers of commands that can be run: those without commands below them."""
    below = [
        option.choices for group in _groups(parser) for option in _options(group) if isinstance(option.choices, dict)
    ]
    if not below:
        if fill := getattr(parser, "fill", None):  # an export, which gets its options when it is used
            fill()
        yield parser
    for commands in below:
        for command in commands.values():
            yield from _leaves(command)


def _index(parsers: Sequence[argparse.ArgumentParser]) -> str:
    lines = []
    for command, group in groupby(parsers, lambda parser: parser.prog.split()[1]):
        links = (f"[{p.prog.partition(command)[2].strip() or command}](#{p.prog.replace(' ', '-')})" for p in group)
        line = ", ".join(links)
        lines.append(f"- {line}" if line.startswith(f"[{command}]") else f"- {command}: {line}")
    return "\n".join(lines)


def _section(parser: argparse.ArgumentParser) -> str:
    parts = [f"## {parser.prog}", parser.description or ""]
    unnamed = [option for group in _groups(parser) if group.title in _UNNAMED for option in _options(group)]
    parts.append(_table(unnamed) if unnamed else "")
    for group in _groups(parser):
        if group.title == _TREE:
            parts.append("Takes the options of [the tree](#the-tree), too.")
        elif group.title not in _UNNAMED and (options := _options(group)):
            title = group.title or ""
            parts.extend([f"{title[:1].upper()}{title[1:]}:", _table(options)])
    parts.append(f"```text\n{parser.epilog.strip()}\n```" if parser.epilog else "")
    return "\n\n".join(filter(None, parts))


def _groups(parser: argparse.ArgumentParser) -> Sequence[argparse._ArgumentGroup]:
    return parser._action_groups  # noqa: SLF001 — argparse has no public way to look into a parser


def _options(group: argparse._ArgumentGroup) -> list[argparse.Action]:
    return [action for action in group._group_actions if action.dest != "help"]  # noqa: SLF001 — as above


def _table(options: Sequence[argparse.Action]) -> str:
    """One row for each option; `--no-…`, which follows its option, shares the row."""
    lines = ["| option | meaning |", "|---|---|"]
    for _, group in groupby(options, lambda option: option.dest):
        same = list(group)
        lines.append(f"| {'<br>'.join(map(_spelling, same))} | {_meaning(same[0])} |")
    return "\n".join(lines)


def _spelling(option: argparse.Action) -> str:
    value = str(option.metavar or "|".join(map(str, option.choices or ())) or option.dest.upper())
    names = option.option_strings or [""]
    texts = (f"{name} {value}".strip() if option.nargs != 0 else name for name in names)
    return "<br>".join(f"`{text}`".replace("|", "\\|") for text in texts)


def _meaning(option: argparse.Action) -> str:
    text = (option.help or "") % {"default": option.default}
    if option.default and option.default != argparse.SUPPRESS and "default" not in text:
        text += f" (default: {option.default})"
    return text.replace("|", "\\|").replace("\n", " ")
