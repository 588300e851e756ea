"""The public Python API of sigcat: generated, see python.md. Imports are omitted."""

class AttributeChange(NamedTuple):
    """One attribute of a node. None means that the attribute is absent."""
    name: str
    old: Any
    new: Any
    rule: str
    compatibility: Class
    rules: tuple[str, ...]

class Change(NamedTuple):
    """One change; equal changes of the instances of a branch are one."""
    kind: Kind
    compatibility: Class
    rule: str
    path: str
    type: str
    paths: tuple[str, ...]
    leaves: int
    former: str
    former_paths: tuple[str, ...]
    attributes: tuple[AttributeChange, ...]
    evidence: Evidence
    came: tuple[str, ...]
    went: tuple[str, ...]
    note: str
    effects: tuple[str, ...]

    @property
    def is_guess(self) -> bool:
        """Whether the move is only a guess."""

    @property
    def sort_key(self) -> tuple[list[str], int, list[str]]:
        """By the path that users of the old tree know."""

class Origin(NamedTuple):
    """Place of a value: file, line and column (from 1), and the overlay, if it is in one."""
    file: str
    line: int
    column: int
    overlay: str

    @property
    def position(self) -> tuple[str, int, int]:
        """File, line and column, in the order in which a finding takes them."""

class SigcatError(Exception):
    """Base of every error that sigcat raises on purpose; its text is written for users."""

class InputRefused(SigcatError):
    """An input cannot be used. `findings` has every reason, not the first one only; a traceback shows the first of them."""
    findings: tuple[Finding, ...]

    def __init__(self, message: str, findings: tuple[Finding, ...]=()) -> None:
        ...

class NotFound(SigcatError):
    """A catalogue, node, rule or file that was named does not exist. `nearest` are names that do."""
    nearest: tuple[str, ...]

    def __init__(self, message: str, nearest: tuple[str, ...]=()) -> None:
        ...

class UsageError(SigcatError):
    """A command or request asks for something that cannot be done."""

class Finding(NamedTuple):
    """One problem at one position.

    Lines and columns count from 1; 0 means that the finding concerns the file as a whole.
    """
    rule: str
    severity: Severity
    message: str
    file: str
    line: int
    column: int
    path: str
    pointer: str
    fix: str

    @property
    def sort_key(self) -> tuple[str, int, int, str, str]:
        """Findings are reported in the order in which a reader meets them."""

    @property
    def line_of_text(self) -> str:
        """One line for a terminal: `file:line:column: severity RULE message`, which editors and build logs make clickable."""

class NodeUse(NamedTuple):
    """Use of a node by a function."""
    function_id: str
    function: str
    path: str
    verb: str
    call: str
    name: str
    component: str

class Trial(NamedTuple):
    """The effect of an overlay. Nothing is stored."""
    catalogue: Catalogue
    nodes: tuple[Node, ...]
    findings: tuple[Finding, ...]
    changes: tuple[Change, ...]

class Catalogue:
    """A tree with its overlays, composed. Frozen; open it again to read changed files."""

    @property
    def name(self) -> str:
        """Id of the catalogue in its project, else the name of the tree."""

    @property
    def title(self) -> str:
        """Title for readers."""

    @property
    def roots(self) -> tuple[Node, ...]:
        """The root of the signal tree, and that of the struct types if there is one."""

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Warnings and notes of reading the files. Errors raise InputRefused when the catalogue is opened."""

    @property
    def digest(self) -> str:
        """SHA-256 of the content: equal for equal trees, however they are split into files."""

    def __len__(self) -> int:
        ...

    def __iter__(self) -> Iterator[Node]:
        ...

    def __contains__(self, path: object) -> bool:
        ...

    def __getitem__(self, path: str) -> Node:
        """Return the node at a path; without the names of instances, the definition. Raises NotFound with near paths."""

    def get(self, path: str) -> Node | None:
        """Return the node at a path, or None."""

    def instances(self, path: str) -> tuple[Node, ...]:
        """Return the nodes that share the definition at a path. Raises NotFound."""

    def search(self, text: str='', *, type: str | None=None, datatype: str | None=None, unit: str | None=None, category: str | None=None, asil: str | None=None, overlay: str | None=None, deprecated: str | None=None, limit: int=50, each_instance: bool=False) -> tuple[Node, ...]:
        """Return nodes by words of their names, descriptions and units, or by a generated name, the best first.

        The filters are exact values; `deprecated` is yes or no. Instances of one definition are one hit, unless
        `each_instance`. Raises UsageError for a value that no node can have.
        """

    def lint(self, text: str, name: str='text') -> tuple[Finding, ...]:
        """Return the findings of a text: an overlay over this catalogue, another tree, or a function.yaml.

        `name` is the name of the text in findings. Rules and severities are those of the project.
        """

    def try_overlay(self, text: str, name: str='overlay.vspec') -> Trial:
        """Apply an overlay that is given as text; it cannot include files."""

    def diff(self, new: Catalogue) -> tuple[Change, ...]:
        """Return the changes from this catalogue to `new`, each with its class from breaking to text only."""

    def resolve(self, *files: PathLike) -> tuple[Function, ...]:
        """Resolve function files, `function.yaml` or Function JSON; together, if one uses what another defines.

        Raises InputRefused with every finding if there are errors.
        """

def open_catalogue(tree: PathLike='interfaces', *, overlays: Iterable[PathLike]=(), units: Iterable[PathLike]=(), quantities: Iterable[PathLike]=(), types: Iterable[PathLike]=(), include_dirs: Iterable[PathLike]=()) -> Catalogue:
    """Open a tree: a pulled release such as `v6.0`, what sigcat ships (`interfaces`, `vss`), a .vspec file or a folder.

    The arguments are those of `sigcat show -s TREE -l OVERLAY …`. Raises InputRefused with every finding if there are errors,
    UsageError, or NotFound with near names.
    """

def diff(old: PathLike, new: PathLike) -> tuple[Change, ...]:
    """Return the changes between two trees that are named as for `sigcat diff`: `v5.0`, a folder, `git:main`, an export."""

@dataclass(frozen=True, eq=False)
class Function:
    """A function of a `function.yaml` or Function JSON: every datatype, unit and range is that of the catalogue."""
    findings: tuple[Finding, ...] = field(repr=False)

    @property
    def name(self) -> str:
        """Name of the function."""

    @property
    def file(self) -> str:
        """The file that it was read from."""

    @cached_property
    def json(self) -> dict[str, Any]:
        """Function JSON."""

    @cached_property
    def uses(self) -> tuple[NodeUse, ...]:
        """The nodes that the function uses: path, verb (consumes, provides, reports, …), call and own name."""

class Attribute(NamedTuple):
    """An attribute of a node."""
    name: str
    value: Any
    origin: Origin
    history: tuple[tuple[Any, Origin], ...]

@dataclass(frozen=True)
class Node:
    """A branch, signal, struct or property of a catalogue. Frozen."""
    path: str

    @property
    def name(self) -> str:
        """Last name of the path."""

    @property
    def type(self) -> str:
        """branch, sensor, actuator, attribute, struct or property."""

    @property
    def datatype(self) -> str:
        """VSS datatype; empty for branches."""

    @property
    def unit(self) -> str:
        """Unit as it is written; empty without one."""

    @property
    def description(self) -> str:
        """Description as it is written."""

    @property
    def values(self) -> Mapping[str, Any]:
        """Values of all attributes by name, such as `min`, `max`, `allowed` and extended attributes."""

    @property
    def attributes(self) -> Mapping[str, Attribute]:
        """All attributes by name, with their origin."""

    @property
    def origin(self) -> Origin:
        """Place where the node was written first."""

    @property
    def definition_path(self) -> str:
        """Path without the names of instances; the path itself for other nodes."""

    @property
    def parent(self) -> Node | None:
        """The branch above; None above a root."""

    @property
    def children(self) -> tuple[Node, ...]:
        """Nodes directly below, in the order of the files."""

    def walk(self) -> Iterator[Node]:
        """Iterate over this node and all nodes below it, parents first."""

class Project:
    """The catalogues and functions of a project. Files are read when they are needed, and again by `reload`."""

    @property
    def catalogues(self) -> tuple[str, ...]:
        """Ids of the catalogues, the default one first."""

    @property
    def vehicles(self) -> tuple[str, ...]:
        """Names of the vehicles, for `catalogue` and `diff`: `vehicle:ID`, or `vehicle:ID@STATE`."""

    @property
    def root(self) -> Path:
        """Folder of the `sigcat.toml`, else the folder that was opened."""

    @property
    def functions(self) -> tuple[Path, ...]:
        """The function files of the project, for `Catalogue.resolve`."""

    def catalogue(self, name: str='') -> Catalogue:
        """Return a catalogue by its id, or the default one; `vehicle:ID` is that of a vehicle.

        Raises NotFound with near ids, InputRefused with every finding if its files have errors.
        """

    def users(self, path: str, catalogue: str='') -> tuple[NodeUse, ...]:
        """Return the uses of a node, or of any node below a branch, by the functions of the project.

        Files that `function_errors` reports are not among them. Raises NotFound with near paths.
        """

    def function_errors(self, catalogue: str='') -> tuple[Finding, ...]:
        """Return the errors of function files that cannot be used with a catalogue."""

    def diff(self, old: str, new: str) -> tuple[Change, ...]:
        """Return the changes between two sides: ids of catalogues, or names as for `sigcat diff`."""

    def reload(self) -> None:
        """Read files that changed again."""

def open_project(folder: PathLike='.') -> Project:
    """Open the project of a folder: the nearest `sigcat.toml` in it or above it, else what sigcat ships.

    Raises InputRefused with everything that is wrong with the file, UsageError if there is no such folder.
    """

class Row(NamedTuple):
    """Values that were sent at a time."""
    time: int
    call: str
    values: Mapping[str, Any]

class Run:
    """A run of functions. Each iteration builds and runs them again, with the same rows."""

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of everything that the functions send."""

    @property
    def units(self) -> Mapping[str, str]:
        """Units by name; names without a unit are omitted."""

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Warnings about the functions and the trace."""

    def __iter__(self) -> Iterator[Row]:
        """Build and run the functions. Raises InputRefused, after the rows so far, if the run stops before its end."""

    def table(self) -> pa.Table:
        """Run the functions and return an Arrow table: time (duration in ns), call, and a column for each thing sent.

        A cell without a new value is null. Raises UsageError without the package pyarrow.
        """

def simulate(functions: Sequence[Function], trace: PathLike | None=None, *, duration: float | None=None, ignition_cycle: int=1, step_limit: float=10.0, sandbox: bool=False) -> Run:
    """Prepare a run of functions with a trace in CSV or MCAP; iterate over it, or ask for its table.

    `duration` is in seconds, by default to the end of the trace. The other arguments are the options of
    `sigcat simulate`. What the functions print is discarded. Raises InputRefused with findings, or UsageError.
    """
