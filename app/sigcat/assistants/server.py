"""The tools that a coding assistant may call, on standard input and output."""

from collections.abc import Callable
from functools import wraps
from pathlib import Path
from threading import Lock
from typing import Annotated, ParamSpec

from mcp.server import MCPServer
from mcp.server.mcpserver.exceptions import ToolError
from mcp_types import ToolAnnotations
from pydantic import Field

from sigcat import __version__
from sigcat.assistants.answers import (
    Answer,
    change_data,
    finding_data,
    listed,
    node_detail,
    node_summary,
    use_data,
)
from sigcat.catalogue.reading.joined_paths import split_paths
from sigcat.errors import InputRefused, SigcatError, UsageError
from sigcat.python_api.project import Project
from sigcat.real_path import real_path

Parameters = ParamSpec("Parameters")
CatalogueId = Annotated[str, Field(description="Id of a catalogue; empty for the default one.")]
_READ_ONLY = ToolAnnotations(read_only_hint=True, open_world_hint=False)
_INSTRUCTIONS = """\
Look up vehicle signals (COVESA VSS), check overlays and function files, and see who uses a signal before you change it.
Paths have dots, such as Vehicle.Speed. Nothing is written. Catalogues: {catalogues}. The first one is the default.
"""


def serve(project: Project, root: Path) -> None:
    """Answer on standard input and output until it is closed. `root` is the folder whose files may be read."""
    server_of(project, root).run("stdio")


def server_of(project: Project, root: Path) -> "MCPServer[None]":
    """Return the server with its tools."""
    instructions = _INSTRUCTIONS.format(catalogues=", ".join(project.catalogues))
    server: MCPServer[None] = MCPServer("sigcat", instructions=instructions, version=__version__, log_level="WARNING")
    for tool in _Tools(project, root).all:
        server.tool(annotations=_READ_ONLY)(tool)
    return server


class _Tools:
    """Look-ups in one project, one at a time; files that changed are read again before each."""

    def __init__(self, project: Project, root: Path) -> None:
        self._project, self._root, self._lock = project, real_path(root), Lock()

    @property
    def all(self) -> list[Callable[..., Answer]]:
        tools = (self.search, self.show, self.lint, self.try_overlay, self.diff, self.who_uses)
        return [self._answering(tool) for tool in tools]

    def search(
        self,
        words: Annotated[str, Field(description="Words of names, descriptions and units, or a generated name.")],
        type: Annotated[str, Field(description="Only nodes of this type, such as sensor.")] = "",  # noqa: A002
        catalogue: CatalogueId = "",
    ) -> Answer:
        """Find nodes by words, the best first. Instances of one definition are one hit."""
        opened = self._project.catalogue(catalogue)
        found = opened.search(words, type=type or None, limit=len(opened))
        return listed("nodes", map(node_summary, found), len(found))

    def show(self, path: str, catalogue: CatalogueId = "") -> Answer:
        """Show a node: every attribute, the file and line where it was written, and the nodes below it."""
        opened = self._project.catalogue(catalogue)
        return node_detail(opened[path], opened.instances(path))

    def lint(
        self,
        text: Annotated[str, Field(description="Text of an overlay, a tree or a function.yaml.")],
        name: Annotated[str, Field(description="Name of the text in findings.")] = "text",
        catalogue: CatalogueId = "",
    ) -> Answer:
        """Check a text with the rules of the project, without writing a file."""
        return finding_data(self._project.catalogue(catalogue).lint(text, name))

    def try_overlay(
        self, text: Annotated[str, Field(description="Text of an overlay.")], catalogue: CatalogueId = ""
    ) -> Answer:
        """Show what an overlay would change, by compatibility class, and its findings."""
        trial = self._project.catalogue(catalogue).try_overlay(text)
        return {**finding_data(trial.findings), **change_data(trial.changes)}

    def diff(
        self,
        old: Annotated[str, Field(description="Id of a catalogue, a release, git:REVISION[:PATH], or a file.")],
        new: Annotated[str, Field(description="The same, for the new side.")],
    ) -> Answer:
        """Compare two catalogues: every change with its class from breaking to text only, the worst first."""
        self._check_side(old)
        self._check_side(new)
        return change_data(self._project.diff(old, new))

    def who_uses(self, path: str, catalogue: CatalogueId = "") -> Answer:
        """List the functions of the project that use a node, or a node below a branch."""
        unread = self._project.function_errors(catalogue)
        return use_data(self._project.users(path, catalogue), unread)

    def _check_side(self, name: str) -> None:
        """Raise UsageError for a file outside of the project: what an assistant asks for may come from anywhere."""
        for part in split_paths(name, "+"):
            path = Path(part)
            if path.exists() and not real_path(path).is_relative_to(self._root):
                raise UsageError(f"{part}: only files in {self._root} can be compared")

    def _answering(self, tool: Callable[Parameters, Answer]) -> Callable[Parameters, Answer]:
        """Return the tool on the files as they are now; the reason of a refusal is its answer."""

        @wraps(tool)
        def answer(*arguments: Parameters.args, **named: Parameters.kwargs) -> Answer:
            with self._lock:
                try:
                    self._project.reload()
                    return tool(*arguments, **named)
                except (SigcatError, OSError) as error:
                    raise ToolError(_reason(error)) from None

        return answer


def _reason(error: SigcatError | OSError) -> str:
    findings = error.findings if isinstance(error, InputRefused) else ()
    answer = finding_data(findings) if findings else {}
    return "\n".join([str(error), *map(str, answer.values())])
