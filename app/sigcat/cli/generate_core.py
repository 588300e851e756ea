"""`sigcat generate core FUNCTION... -o DIR`."""

import argparse

from sigcat.cli.function_options import add_functions, functions_of, tree_for_functions
from sigcat.cli.generated_folder import add_folder, paths_in, write_generated
from sigcat.cli.output import print_findings
from sigcat.cli.output_options import refuse_overwriting
from sigcat.cli.tree_options import add_tree_options


def add_kind(kinds: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the sub-command."""
    one = kinds.add_parser(
        "core",
        help="the core of adapters, for every platform",
        description=(
            "Write the core of the adapter of each function in C: what is received, checked, converted, supervised and "
            "sent, independent of any platform."
        ),
    )
    add_functions(one)
    add_folder(one)
    one.add_argument(
        "--arithmetic",
        choices=("double", "float"),
        default="double",
        help=(
            "type in which values are converted; float for controllers without doubles, with times in 32 bits if the declared "
            "ones allow it (default: %(default)s)"
        ),
    )
    add_tree_options(one)
    one.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Write the files; findings go to standard error. Raises InputRefused if a function cannot be used."""
    from sigcat.adapter.core.cores import cores
    from sigcat.adapter.core.numbers import DOUBLE, FLOAT
    from sigcat.integration.reading import read_functions

    sources = [(path.read_bytes(), str(path)) for path in functions_of(arguments)]
    functions, findings = read_functions(sources, tree_for_functions(arguments, sources))
    files, warnings = cores(functions, FLOAT if arguments.arithmetic == "float" else DOUBLE)
    print_findings((*findings, *warnings))
    refuse_overwriting(arguments, written=paths_in(arguments.output, files))
    write_generated(files, arguments.output, "core", is_whole=False, force=arguments.force)
    return 0
