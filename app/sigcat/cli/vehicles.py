"""`sigcat vehicles`: the vehicles of the project, and which of them have a node."""

import argparse
import json
import sys
from typing import TYPE_CHECKING

from sigcat.cli.output import write_text
from sigcat.cli.output_options import add_output
from sigcat.cli.project_options import add_project_options, project_of
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import has_errors
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from sigcat.catalogue.hosting.vehicle_matrix import Matrix
    from sigcat.catalogue.hosting.vehicles import Composed

_EPILOG = """`-s vehicle:ID` names a vehicle in every other command. Exit status: 1 if a vehicle has errors.
"""


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "vehicles",
        help="list the vehicles of the project, and which of them have a node",
        description="List the vehicles of sigcat.toml with their facts and their numbers of signals. With --matrix, list the nodes that "
        "not all of them have; of a branch that is missing as a whole, only the branch.",
        epilog=_EPILOG,
    )
    parser.add_argument("words", nargs="*", metavar="WORD", help="with --matrix: only paths that have all of the words")
    parser.add_argument("--matrix", action="store_true", help="nodes in rows, vehicles in columns")
    parser.add_argument("--all", action="store_true", help="with --matrix: also the nodes that all vehicles have")
    parser.add_argument(
        "--vehicles", default="all", metavar="all|ID,...", help="only these vehicles (default: %(default)s)"
    )
    parser.add_argument("--format", choices=("text", "csv", "json"), default="text", help="default: %(default)s")
    add_output(parser, "-o", "--output", metavar="FILE", help="write here instead of to standard output")
    add_project_options(parser)
    parser.set_defaults(run=vehicles)


def vehicles(arguments: argparse.Namespace) -> int:
    """Write the list or the matrix. Raises NotFound, and InputRefused for a vehicle with errors."""
    from sigcat.project.vehicles import chosen_vehicles, each_composed

    if (arguments.words or arguments.all) and not arguments.matrix:
        raise UsageError("words and --all choose nodes: pass --matrix, too")
    project = project_of(arguments)
    composed = list(each_composed(project, chosen_vehicles(project, arguments.vehicles)))
    for each in composed:
        if has_errors(each.catalogue.findings):
            raise InputRefused(f"{each.vehicle.label} has errors; nothing was listed", each.catalogue.findings)
    text = _matrix(composed, arguments) if arguments.matrix else _list(composed, arguments.format)
    write_text(text, arguments.output)
    return 0


def _list(composed: "Sequence[Composed]", form: str) -> str:
    rows = [
        {
            "name": each.vehicle.name,
            "title": each.vehicle.title,
            "catalogue": each.vehicle.catalogue,
            "signals": sum(node.is_leaf for root in each.catalogue.roots[:1] for node in root.walk()),
            "attributes": dict(each.vehicle.labels),
        }
        for each in composed
    ]
    if form == "json":
        return json.dumps(rows, indent=2, ensure_ascii=False) + "\n"
    if form == "csv":
        return _csv(rows)
    width = max(len(str(row["name"])) for row in rows)
    return "".join(f"{printable(line)}\n" for line in _lines(rows, width))


def _csv(rows: "Sequence[dict[str, object]]") -> str:
    import csv
    from io import StringIO

    text = StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(rows[0])
    table.writerows([_facts(value) if isinstance(value, dict) else value for value in row.values()] for row in rows)
    return text.getvalue()


def _lines(rows: "Sequence[dict[str, object]]", width: int) -> "Iterator[str]":
    for row in rows:
        facts = f"  {_facts(row['attributes'])}" if row["attributes"] else ""
        yield f"{row['name']!s:{width}}  {row['signals']} signals of {row['catalogue']}  {row['title']}{facts}"


def _facts(attributes: object) -> str:
    assert isinstance(attributes, dict)
    return ", ".join(f"{name}: {value}" for name, value in attributes.items())


def _matrix(composed: "Sequence[Composed]", arguments: argparse.Namespace) -> str:
    from sigcat.catalogue.hosting.vehicle_matrix import Filters, filtered, matrix_csv, matrix_of

    filters = Filters(" ".join(arguments.words), arguments.all)
    matrix = filtered(matrix_of(composed), filters)
    if arguments.format == "csv":
        return matrix_csv(matrix)
    if arguments.format == "json":
        return json.dumps(_data(matrix), indent=2, ensure_ascii=False) + "\n"
    if not matrix.rows:
        print("The vehicles do not differ in any node. `--all` lists all nodes.", file=sys.stderr)
    return "".join(f"{printable(line)}\n" for line in _table(matrix))


def _data(matrix: "Matrix") -> object:
    names = [vehicle.name for vehicle in matrix.vehicles]
    return [
        {"path": row.path, "type": row.type, "signals": row.signals,
         "vehicles": [name for name, has in zip(names, row.has, strict=True) if has]}
        for row in matrix.rows
    ]  # fmt: skip


def _table(matrix: "Matrix") -> "Iterator[str]":
    """Yield a line for each node: its path, and the vehicles that have it."""
    names = [vehicle.name for vehicle in matrix.vehicles]
    width = max((len(row.path) for row in matrix.rows), default=0) + 1
    for row in matrix.rows:
        having = [name for name, has in zip(names, row.has, strict=True) if has]
        path = f"{row.path}." if row.type == "branch" else row.path
        yield f"{path:{width}}  {', '.join(having) or 'no vehicle'}"
