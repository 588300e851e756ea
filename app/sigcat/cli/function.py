"""`sigcat function new`, `build`, `overlay` and `validate`."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from sigcat.cli.function_options import add_function, add_functions, functions_of, one_function, tree_for_functions
from sigcat.cli.output import print_findings, write_text
from sigcat.cli.output_options import add_output
from sigcat.cli.project_options import project_of
from sigcat.cli.tree_options import add_tree_options, read_tree, tree_options
from sigcat.errors import UsageError
from sigcat.findings import in_order

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from sigcat.catalogue.model.catalogue import Catalogue
    from sigcat.findings import Finding

Actions: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"  # noqa: SLF001 — argparse has no public name


def add_parser(commands: Actions) -> None:
    """Add the command with its sub-commands."""
    parser = commands.add_parser("function", help="start, build and check functions")
    actions = parser.add_subparsers(title="actions", metavar="ACTION")
    _add_new(actions)
    _add_build(actions)
    _add_update(actions)
    _add_overlay(actions)
    _add_validate(actions)


def _add_new(actions: Actions) -> None:
    starting = actions.add_parser(
        "new",
        help="a function to start from",
        description=(
            "Write a function.yaml that builds, its C code with the variables that it declares, and the JSON Schema that it "
            "names, by which editors complete it. With "
            "--from-c, it is made from C or C++ code, such as Simulink Coder generates: calls, inputs, outputs, parameters, "
            "and paths of the catalogue where they are certain."
        ),
    )
    starting.add_argument("name", metavar="NAME", help="name of the function, CamelCase")
    add_output(
        starting,
        "-o",
        "--output",
        metavar="FOLDER",
        help="folder to write into, or FILE.yaml (default: NAME, in the first folder of functions of the project, or the folder of --from-c)",
    )
    starting.add_argument(
        "--schema", metavar="ADDRESS", help="name this JSON Schema, such as that of a running service, and write none"
    )
    _add_code_options(starting)
    add_tree_options(starting)
    starting.set_defaults(run=new)


def _add_code_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("C and C++ code")
    group.add_argument(
        "--from-c",
        type=Path,
        metavar="FOLDER",
        help="read the code in this folder, which has its headers (needs the extra `c`)",
    )
    group.add_argument("--model", metavar="PREFIX", help="what the calls begin with, if the folder has several models")
    group.add_argument(
        "--define-under",
        metavar="PATH",
        help="define the signals that the catalogue does not have below this branch, such as Vehicle.Pump",
    )
    group.add_argument(
        "-D",
        "--define",
        action="append",
        default=[],
        metavar="NAME[=VALUE]",
        help="definition of the preprocessor; may be repeated",
    )


def _add_build(actions: Actions) -> None:
    building = actions.add_parser(
        "build",
        help="Function JSON of a function.yaml",
        description="Resolve a function.yaml against a catalogue and write its Function JSON.",
    )
    _add_file_and_output(building)
    add_tree_options(building)
    building.set_defaults(run=build)


def _add_update(actions: Actions) -> None:
    updating = actions.add_parser(
        "update",
        help="merge C code that was generated again into a function.yaml",
        description=(
            "List and apply what variables are new, gone and changed in C or C++ code since its function.yaml was made. "
            "What was written by hand stays, comments too; paths, units, ranges and times are kept."
        ),
    )
    add_function(updating)
    _add_code_options(updating)
    add_tree_options(updating)
    updating.set_defaults(run=update)


def _add_overlay(actions: Actions) -> None:
    making = actions.add_parser(
        "overlay",
        help="the overlay of the interfaces that a function.yaml defines",
        description="Write what a function.yaml has under `define` as an overlay, so that others can refer to it.",
    )
    _add_file_and_output(making)
    add_output(making, "--types-output", metavar="FILE", help="write the struct types here (for -t)")
    add_tree_options(making)
    making.set_defaults(run=overlay)


def _add_file_and_output(parser: argparse.ArgumentParser) -> None:
    add_function(parser)
    add_output(parser, "-o", "--output", metavar="FILE", help="write here instead of to standard output")


def _add_validate(actions: Actions) -> None:
    validating = actions.add_parser(
        "validate",
        help="check function files, Function JSON or function.yaml, alone and together",
        description=(
            "Check function files from anywhere against the model, the conventions and a catalogue. Several files are "
            "one set: who provides what to whom, and what does not fit."
        ),
    )
    add_functions(validating)
    validating.add_argument("--format", choices=("text", "json"), default="text", help="form of the report")
    validating.add_argument(
        "--vehicles",
        metavar="all|ID,...",
        help="check them against these vehicles of the project too, in each of their states; ID@STATE names one state",
    )
    add_tree_options(validating)
    validating.set_defaults(run=validate)


def build(arguments: argparse.Namespace) -> int:
    """Write the Function JSON; warnings go to standard error. Raises InputRefused if there are errors."""
    from sigcat.adapter.core.clashes import code_problems
    from sigcat.function.function_file import build_function
    from sigcat.function.function_json.model import to_json

    file = one_function(arguments)
    data, name = file.read_bytes(), str(file)
    tree = tree_for_functions(arguments, [(data, name)])
    function, findings = build_function(data, name, tree, check_code=code_problems)
    print_findings(findings)
    write_text(to_json(function).decode("utf-8"), arguments.output)
    return 0


def new(arguments: argparse.Namespace) -> int:
    """Write the scaffold, or what is made from code; a file that is there already is never written over."""
    from sigcat.function.declaration.scaffold import SCHEMA_FILE, code_scaffold, schema_text

    if not arguments.from_c and (arguments.model or arguments.define or arguments.define_under):
        raise UsageError("--model, --define and --define-under are about C code: name its folder with --from-c")
    schema = arguments.schema or SCHEMA_FILE
    file = _new_file(arguments.output or arguments.from_c or _own_folder(arguments))
    folder = file.parent
    code = {} if arguments.from_c else code_scaffold(arguments.name)
    for path in (file, *(folder / name for name in code)):
        if path.exists():
            raise UsageError(f"{path} is there already")
    text = _imported(arguments, folder, schema) if arguments.from_c else _scaffold(arguments, schema)
    if not arguments.schema:
        write_text(schema_text(), folder / SCHEMA_FILE)
    for name, source in code.items():
        write_text(source, folder / name)
    write_text(text, file)
    checked = folder if file.name == "function.yaml" else file
    advice = (
        f"check it with `sigcat lint {checked}`"
        if arguments.from_c
        else f"run it with `sigcat simulate {file} --duration 1`"
    )
    print(f"{file}: {advice}", file=sys.stderr)
    return 0


def _own_folder(arguments: argparse.Namespace) -> Path:
    """The folder of a new function: where the commands of the project find it, or below the current one."""
    folders = project_of(arguments).functions
    return folders[0] / arguments.name if folders else Path(arguments.name)


def _scaffold(arguments: argparse.Namespace, schema: str) -> str:
    """The text of a new function. Only a tree that is not the shipped one is read for it. Raises InputRefused."""
    from sigcat.function.declaration.scaffold import scaffold
    from sigcat.project.chosen_tree import named_tree

    is_shipped = named_tree(project_of(arguments), tree_options(arguments)) is None
    return scaffold(arguments.name, schema, None if is_shipped else read_tree(arguments))


def _new_file(output: Path) -> Path:
    """The file to write: one is named by its ending, anything else is a folder."""
    if output.suffix in (".yaml", ".yml") and not output.is_dir():
        return output
    if output.exists() and not output.is_dir():
        raise UsageError(f"{output} must be a folder, or a file to write that ends with .yaml")
    return output / "function.yaml"


def _imported(arguments: argparse.Namespace, folder: Path, schema: str) -> str:
    """The text that is made from code; what was found goes to standard error. Raises InputRefused."""
    from sigcat.function.importing.import_code import import_code

    catalogue = read_tree(arguments)
    made = import_code(
        arguments.name,
        arguments.from_c,
        folder,
        catalogue,
        schema,
        arguments.model or "",
        arguments.define,
        arguments.define_under or "",
    )
    print_findings(made.findings)
    print(f"{arguments.from_c}: {made.summary}", file=sys.stderr)
    for line in made.to_do:
        print(f"To do: {line}", file=sys.stderr)
    return made.text


def update(arguments: argparse.Namespace) -> int:
    """Merge the code into the file, and say what changed. Raises UsageError, InputRefused."""
    from sigcat.function.importing.merge_code import merge_code

    if not arguments.from_c:
        raise UsageError("name the folder of the C code with --from-c")
    file = one_function(arguments)
    data = file.read_bytes()
    merged = merge_code(
        data,
        file,
        arguments.from_c,
        read_tree(arguments),
        arguments.model or "",
        arguments.define,
        arguments.define_under or "",
    )
    print_findings(merged.findings)
    for line in merged.report:
        print(line)
    if merged.text.encode() != data.removeprefix(b"\xef\xbb\xbf"):
        write_text(merged.text, file)
    elif not merged.report:
        print("nothing changed")
    return 0


def overlay(arguments: argparse.Namespace) -> int:
    """Write the overlay; warnings go to standard error. Raises InputRefused if there are errors."""
    from sigcat.function.extension.overlay import overlay_of

    file = one_function(arguments)
    data, name = file.read_bytes(), str(file)
    made = overlay_of(data, name, tree_for_functions(arguments, [(data, name)]))
    if made.types and arguments.types_output is None:
        raise UsageError("struct types need a separate file: pass `--types-output FILE`")
    print_findings(made.findings)
    if made.types:
        write_text(made.types, arguments.types_output)
    if made.text:
        write_text(made.text, arguments.output)
    return 0


def validate(arguments: argparse.Namespace) -> int:
    """Report findings; 1 if one is worse than a note."""
    from sigcat.adapter.core.clashes import code_problems
    from sigcat.function.sets.check_set import check_functions

    files = [(file.read_bytes(), str(file)) for file in functions_of(arguments)]
    tree = tree_for_functions(arguments, files)
    findings = check_functions(files, tree, is_whole=len(files) > 1, check_code=code_problems)
    if arguments.vehicles is not None:
        findings = in_order((*findings, *_in_vehicles(files, tree, findings, arguments)))
    _print(findings, arguments.format)
    return int(any(finding.severity != "info" for finding in findings))


def _in_vehicles(
    files: "Sequence[tuple[bytes, str]]",
    tree: "Catalogue",
    known: "Sequence[Finding]",
    arguments: argparse.Namespace,
) -> "Iterator[Finding]":
    """Yield the findings that functions have in vehicles only. Raises NotFound, InputRefused."""
    from sigcat.function.sets.in_vehicles import findings_in_vehicles
    from sigcat.project.vehicles import chosen_vehicles, each_composed

    project = project_of(arguments)
    vehicles = chosen_vehicles(project, arguments.vehicles)
    return findings_in_vehicles(files, tree, known, each_composed(project, vehicles))


def _print(findings: "Sequence[Finding]", form: str) -> None:
    from sigcat.rules.report import report, sources_of

    sys.stdout.write(report(findings, form, sources_of(findings), colour=sys.stdout.isatty()))
