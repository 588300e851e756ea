"""The options that name the two sides of a comparison, and the sides read."""

import argparse
import os
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.output_options import refuse_overwriting
from sigcat.cli.project_options import add_project_options, project_of
from sigcat.cli.tree_options import add_many, add_vocabulary_options, tree_options
from sigcat.errors import NotFound, UsageError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from sigcat.catalogue.comparing.changes import Change
    from sigcat.catalogue.comparing.sides import Options, Side
    from sigcat.project.project import Project

SIDES = """A side is
  a catalogue               of the project, by its id
  vehicle:ID[@STATE]        a vehicle of the project, in its last state or in STATE
  a folder                  the project in it, or the tree in or below it
  a .vspec file             the tree of which it is the root
  a .json file              an exported tree
  git:REVISION[:PATH]       a revision of the repository around the current folder: the catalogue of the sigcat.toml
                            that it has, or the catalogue, folder or file that PATH names in it
  a name                    a release, pulled or shipped (`sigcat releases`), else a revision of git
each with its own overlays, if any: TREE+OVERLAY+OVERLAY. git:A..B names two revisions, git:A...B the commit where
B left A, and B.
"""
HERE = "."


def add_sides(parser: argparse.ArgumentParser) -> None:
    """Add OLD, NEW, --merge-base and the options of both sides."""
    parser.add_argument(
        "old", metavar="OLD", nargs="?", help="side that software was written against, or a range of git"
    )
    parser.add_argument(
        "new", metavar="NEW", nargs="?", help="side that it is to run with (default: the current folder)"
    )
    parser.add_argument(
        "--merge-base", metavar="REVISION",
        help="take for OLD the commit where the current branch left this one, as a pull request does; name NEW alone",
    )  # fmt: skip
    add_options_of_sides(parser)


def add_options_of_sides(parser: argparse.ArgumentParser) -> None:
    """Add the options that concern both sides."""
    group = parser.add_argument_group("for both sides")
    add_many(group, "-l", "--overlays", "overlay, applied in the order given, after those of the side")
    add_vocabulary_options(group)
    add_project_options(group)


def names_of_sides(arguments: argparse.Namespace) -> tuple[str, str]:
    """Return the names of both sides. Raises UsageError if they are not two."""
    from sigcat.catalogue.comparing.sides import GIT
    from sigcat.catalogue.reading.git_revision import is_revision

    old, new = arguments.old, arguments.new
    if arguments.merge_base is not None:
        return _since_merge_base(arguments)
    if old is None:
        raise UsageError("name the sides: `sigcat diff OLD NEW`, such as `sigcat diff git:main .`")
    revision, _, path = old.removeprefix(GIT).partition(":")
    is_named = not Path(old).exists() and is_revision(revision.partition("..")[0])
    if ".." in revision and (old.startswith(GIT) or is_named):
        if new is not None:
            raise UsageError(f"{old} names both sides; remove {new}")
        return _range(revision, f":{path}" if path else "")
    return old, HERE if new is None else new


def _since_merge_base(arguments: argparse.Namespace) -> tuple[str, str]:
    from sigcat.catalogue.comparing.sides import GIT
    from sigcat.catalogue.reading.git_revision import merge_base

    if arguments.new is not None:
        raise UsageError("--merge-base is the old side: name the new one alone, or none for the current folder")
    new = arguments.old or HERE
    revision = new.removeprefix(GIT).partition(":")[0] if new.startswith(GIT) else "HEAD"
    return f"{GIT}{merge_base(arguments.merge_base.removeprefix(GIT), revision)}", new


def _range(revisions: str, path: str) -> tuple[str, str]:
    from sigcat.catalogue.comparing.sides import GIT
    from sigcat.catalogue.reading.git_revision import merge_base

    dots = "..." if "..." in revisions else ".."
    first, _, second = revisions.partition(dots)
    old, new = first or "HEAD", second or "HEAD"
    return f"{GIT}{merge_base(old, new) if dots == '...' else old}{path}", f"{GIT}{new}{path}"


def read_compared(arguments: argparse.Namespace, old: str, new: str) -> "tuple[Side, Side]":
    """Read both sides. No output is written over their files. Raises what `read_sides` raises."""
    from sigcat.catalogue.comparing.sides import read_sides
    from sigcat.catalogue.hosting.sources import release_source

    project = project_of(arguments)
    old, new = _or_revision(old, project), _or_revision(new, project)
    sides = read_sides(old, new, release_source, _options(arguments, project))
    refuse_overwriting(arguments, (*project.files, *_files(old, sides[0]), *_files(new, sides[1])))
    return sides


def changes_between(old: "Side", new: "Side") -> "tuple[Change, ...]":
    """Compare two sides."""
    from sigcat.catalogue.comparing.diff import compare

    return compare(old.catalogue, new.catalogue, old.unknown | new.unknown)


def _or_revision(name: str, project: "Project") -> str:
    """Return the name; that of a revision gets its prefix where nothing else has it. Raises NotFound for unknown vehicles."""
    from sigcat.catalogue.comparing.sides import GIT
    from sigcat.catalogue.hosting.sources import release_source
    from sigcat.catalogue.model.vehicle import VEHICLE
    from sigcat.catalogue.reading.git_revision import is_revision, near_revisions
    from sigcat.catalogue.reading.joined_paths import split_paths
    from sigcat.names import question
    from sigcat.project.chosen_tree import vehicle_source

    if name.startswith(VEHICLE):
        vehicle_source(project, split_paths(name, "+")[0])
        return name
    if name.startswith(GIT) or "+" in name or Path(name).exists() or any(s.id == name for s in project.catalogues):
        return name
    try:
        release_source(name)
    except (NotFound, UsageError):
        if is_revision(name):
            return f"{GIT}{name}"
        if near := near_revisions(name):
            raise NotFound(f"no file, folder, release or revision is named {name!r}. {question(near)}", near) from None
    return name


def _options(arguments: argparse.Namespace, project: "Project") -> "Options":
    from sigcat.catalogue.comparing.sides import NO_OPTIONS
    from sigcat.project.compared_projects import compared_projects, side_project
    from sigcat.project.find_project import VARIABLE

    given = tree_options(arguments)
    options = NO_OPTIONS._replace(
        overlays=given.overlays,
        include_dirs=given.include_dirs,
        units=given.units,
        quantities=given.quantities,
        types=given.types,
    )
    if arguments.isolated:
        return options
    named = arguments.config or os.environ.get(VARIABLE)
    return options._replace(project=side_project(project), projects=compared_projects(Path(named) if named else None))


def _files(name: str, side: "Side") -> "Iterator[str]":
    """The files that a side was read from."""
    from sigcat.catalogue.reading.joined_paths import split_paths

    yield from split_paths(name, "+")
    yield from (file.name for file in side.catalogue.files)
