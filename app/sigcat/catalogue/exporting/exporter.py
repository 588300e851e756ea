"""Exporters: one record each, with the name, the options and the functions that run it."""

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

if TYPE_CHECKING:
    from sigcat.catalogue.exporting.files import Export
    from sigcat.catalogue.model.catalogue import Catalogue

Kind = Literal[
    "flag", "switch", "text", "name", "identifier", "texts", "number", "choice", "input", "output", "folder", "state"
]
"""Kinds of options.

flag: given or not. switch: true or false. name: text that becomes part of a file name. identifier: a name in a language. input: a file to read.
output, folder: a file or folder to write beside the main one. state: a file that is read, if it exists, and written.
"""


class Option(NamedTuple):
    """An option of an exporter, with the name that it has on the command line, without the dashes."""

    name: str
    kind: Kind
    text: str
    default: str | int | bool | None = None
    choices: tuple[str, ...] = ()
    off: str = ""
    """Spelling of a switch that is off; empty: `no-` and the name."""
    own: bool = False
    """Whether sigcat implements it, because vss-tools has no such option."""
    kept_at: str = ""
    """File in the exported folder with the state of a former export, for the next one to continue."""
    also: tuple[str, ...] = ()
    """Other spellings on the command line, with their dashes: the short ones of vss-tools."""

    @property
    def spelled_off(self) -> str:
        """Name of the option that turns a switch off."""
        return self.off or f"no-{self.name}"


class Exporter(NamedTuple):
    """One exporter. Its functions import what they need when they are called, so that listing exporters costs nothing."""

    name: str
    """On the command line and in addresses: `csv`."""
    text: str
    """Content, in a few words."""
    suffix: str
    """Suffix of the file; empty if the exporter writes a folder."""
    media_type: str
    options: tuple[Option, ...]
    """Everything that can be asked for, besides the tree and the name of the output."""
    run: "Callable[[Job], Export]"
    """Raises InputRefused if the export fails."""
    stream: "Callable[[Catalogue, Mapping[str, Any]], Iterator[bytes] | None] | None" = None
    """The same bytes in parts, the first one at once. None: not at all, or not with these options."""
    same_as: str = ""
    """The command that writes the same bytes, such as `vspec export csv`."""
    needs_types: bool = False
    """Whether it exports struct types and nothing else."""
    refuses_types: bool = False
    """Whether it exports no signal whose datatype is a struct."""
    has_types_beside: bool = False
    """Whether it writes struct types into separate files, next to the main one."""
    unescaped: tuple[str, ...] = ()
    """Attributes that it writes as they are: as names, or between marks of comments or texts."""
    has_value_names: bool = False
    """Whether each allowed value is a name in the scope of its branch."""
    output_also: tuple[str, ...] = ()
    """Other spellings of `--output` on the command line, with their dashes: those of vss-tools."""

    refuses_ending: bool = False
    """Whether the name of its folder may not end like that of a file."""

    @property
    def is_folder(self) -> bool:
        """Whether the export is a folder."""
        return not self.suffix


class Job(NamedTuple):
    """One export to run: the catalogue can be exported, and the options are checked."""

    exporter: Exporter
    catalogue: "Catalogue"
    options: Mapping[str, Any]
    output_name: str
    """Name of the file or folder."""
    timeout: float
    """Seconds."""
    memory: int = 0
    """Bytes that vss-tools may take; 0: as many as there are."""


TIMEOUT = 600.0
"""Seconds after which an export is stopped: vss-tools takes minutes for trees of many ten thousand signals."""
