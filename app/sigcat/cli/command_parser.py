"""The parser of every command: it proposes what was probably meant, and lists the commands where one is missing."""

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from itertools import takewhile
from pathlib import Path
from typing import Any, TypeVar

Number = TypeVar("Number", int, float)
_COLUMNS = 80
"""Columns of output that is not a terminal."""
_LARGEST = 1_000_000_000
"""More than anybody waits or reads; no clock counts to much more."""


def positive(kind: type[Number]) -> Callable[[str], Number]:
    """The type of an option that takes a number greater than 0."""

    def read(text: str) -> Number:
        try:
            number = kind(text)
        except ValueError:
            number = kind(0)
        if not 0 < number <= _LARGEST:
            what = "a whole number" if kind is int else "a number"
            raise argparse.ArgumentTypeError(f"must be {what} greater than 0, at most {_LARGEST:,}, not {text[:80]!r}")
        return number

    return read


def _columns() -> int:
    """Columns of the terminal, or those that COLUMNS states."""
    stated = os.environ.get("COLUMNS", "")
    if stated.isdecimal() and int(stated):
        return int(stated)
    try:
        return os.get_terminal_size(sys.__stdout__.fileno()).columns or _COLUMNS if sys.__stdout__ else _COLUMNS
    except (OSError, ValueError):
        return _COLUMNS


class CommandParser(argparse.ArgumentParser):
    """A parser that says which option or choice is wrong, and which one is near to it.

    Abbreviated options are refused: a script with one would stop working, or do something else, after a new option.
    """

    def __init__(self, **named: Any) -> None:
        super().__init__(**{**named, "allow_abbrev": False})

    @property
    def actions(self) -> tuple[argparse.Action, ...]:
        """The arguments and options, in order."""
        return tuple(self._actions)

    def add_subparsers(self, **named: Any) -> Any:
        """Add the commands below this one. Without one of them, its help goes to standard error."""
        self.set_defaults(run=self._run_without_command)
        return super().add_subparsers(**named)

    def parse_known_args(self, *arguments: Any, **named: Any) -> Any:
        """Parse what belongs to this parser, and refuse the rest, which no other parser reads."""
        given, *_ = *arguments, named.get("args")
        if self._subparsers is None:  # first: without its option, a value is taken for another argument
            self._refuse_unknown(given or sys.argv[1:])
        parsed, unknown = super().parse_known_args(*arguments, **named)
        if unknown:
            self._refuse(unknown[0].partition("=")[0])
        return parsed, unknown

    def _get_formatter(self) -> argparse.HelpFormatter:
        """The formatter of help and errors, with the width of the terminal, for which argparse would load shutil."""
        formatter: Callable[..., argparse.HelpFormatter] = self.formatter_class
        return formatter(prog=self.prog, width=_columns() - 2)

    def _refuse_unknown(self, given: Sequence[str]) -> None:
        for argument in takewhile(lambda each: each != "--", given):
            name = argument.partition("=")[0]
            if name.startswith("--") and name not in self._option_string_actions:
                self._refuse(name)

    def _refuse(self, argument: str) -> None:
        from sigcat.names import did_you_mean, question

        if not argument.startswith("-"):
            self.error(f"unexpected argument {argument!r}")
        options = [option for action in self._actions for option in action.option_strings]
        begun = [option for option in options if len(argument) > len("--") and option.startswith(argument)]
        self.error(f"unknown option {argument}. {question(begun[:3]) or did_you_mean(argument, options)}".rstrip(". "))

    def _get_values(self, action: argparse.Action, strings: list[str]) -> Any:
        if action.type is Path and "" in strings:  # Path takes it for the current folder
            raise argparse.ArgumentError(action, "must be a path, and it is empty")
        return super()._get_values(action, strings)

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is None or value in action.choices:
            return
        from sigcat.names import did_you_mean

        choices = [str(choice) for choice in action.choices]
        is_option = f"--{value}" in self._option_string_actions
        meant = f"Did you mean --{value}?" if is_option else did_you_mean(str(value), choices)
        raise argparse.ArgumentError(
            action, f"must be one of {', '.join(choices)}, not {value!r}. {meant}".rstrip(". ")
        )

    def _print_message(self, message: str, file: Any = None) -> None:
        """Print at once, so that output that cannot be written is an error: argparse passes over it."""
        if message and file is not None and file is sys.stdout:
            file.write(message)
            file.flush()
        else:
            super()._print_message(message, file)

    def _run_without_command(self, _arguments: argparse.Namespace) -> int:
        self.print_help(sys.stderr)
        return 2
