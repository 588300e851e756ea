"""The exporters of vss-tools 6.1 that write a file or a folder, with their options.

Written down here so that help, API and checks need no vss-tools code; a test holds the table against vss-tools.
"""

from collections.abc import Mapping
from typing import Literal, NamedTuple

from sigcat.errors import NotFound
from sigcat.names import did_you_mean, nearest

Kind = Literal["flag", "switch", "text", "name", "texts", "number", "choice", "input", "output", "folder", "state"]
"""What an option takes.

flag: given or not. switch: true or false. name: a text that becomes part of a file name. input: a file to read.
output, folder: a file or folder to write beside the main one. state: a file that is read, if it exists, and written.
"""


class Option(NamedTuple):
    """An option of an exporter, spelled as `vspec export` spells it, without the dashes."""

    name: str
    kind: Kind
    text: str
    default: str | int | bool | None = None
    choices: tuple[str, ...] = ()
    off: str = ""
    """Spelling of a switch that is off; empty: `no-` and the name."""
    own: bool = False
    """Whether sigcat acts on it itself, because vss-tools has no such option."""

    @property
    def spelled_off(self) -> str:
        """Name of the option that turns a switch off."""
        return self.off or f"no-{self.name}"


class Format(NamedTuple):
    """An exporter: what it writes and which options it has beside those that name the tree."""

    name: str
    text: str
    suffix: str
    """Suffix of the file; empty if the exporter writes a folder."""
    media_type: str
    options: tuple[Option, ...] = ()
    output: str = "output"
    """Name of the option that names the file or folder."""
    takes_tree_options: bool = True
    """False where the exporter reads the units beside the tree and knows no overlays, types or strictness."""
    output_exists: bool = False
    """Whether the folder to write has to be there already."""
    needs_types: bool = False
    copies_unit_files: bool = False
    """Whether the files of units and quantities themselves become part of the export."""

    @property
    def is_folder(self) -> bool:
        """Whether the export is a folder."""
        return not self.suffix


EXPAND = Option("expand", "switch", "expand instances", True)
KEEP_INSTANCES = Option(
    "keep-instances",
    "flag",
    "keep `instances` at the branches that were expanded, beside what they expand to",
    own=True,
)
_TYPES_OUTPUT = Option("types-output", "output", "write the struct types to a file of their own")
_ALL_ATTRIBUTES = Option("extend-all-attributes", "switch", "keep all extended attributes", False)
_PRETTY = Option("pretty", "switch", "indent the output", False)
_ATTRIBUTES = Option("attr", "texts", "attribute to show at each node; may be repeated")
STRICTNESS = (
    Option("extended-attributes", "texts", "extended attribute to keep and to accept; may be repeated"),
    Option("strict", "switch", "refuse whatever --aborts can refuse", False),
    Option(
        "aborts", "texts", "kind of flaw that ends the export; may be repeated",
        choices=("name-style", "unknown-attribute", "default-matches-first-allowed"),
    ),
    Option("strict-exceptions", "input", "YAML file with the paths that --strict and --aborts leave alone"),
)  # fmt: skip
"""Options of every exporter that takes the options of a tree."""

_JSON = (
    EXPAND,
    _TYPES_OUTPUT,
    _PRETTY,
    _ALL_ATTRIBUTES,
    KEEP_INSTANCES,
    Option("stats-radial", "output", "write counts for a radial chart to this file too"),
)
_JSON_SCHEMA = (
    EXPAND,
    _ALL_ATTRIBUTES,
    _PRETTY,
    Option("no-additional-properties", "flag", "allow no properties that the tree does not have"),
    Option("require-all-properties", "flag", "require every property of the tree"),
)
_CSV = (
    EXPAND,
    _TYPES_OUTPUT,
    Option("stats-sankey", "output", "write counts for a Sankey diagram to this file too; nothing is expanded then"),
    Option("stats-piechart", "output", "write counts for a pie chart to this file too; nothing is expanded then"),
    Option("stats-old-piechart", "input", "earlier counts that --stats-piechart continues"),
)
_ID = (
    EXPAND,
    _TYPES_OUTPUT,
    Option("validate-static-uid", "input", "earlier export of ids that the new one is compared with"),
    Option("case-sensitive", "flag", "let ids depend on the case of names"),
)
_PROTOBUF = (
    Option("types-out-dir", "folder", "folder for the struct types"),
    Option("static-uid", "flag", "number fields by the attribute `staticUID`"),
    Option("add-optional", "flag", "make every field optional"),
    Option("include-comments", "flag", "write descriptions and metadata as comments"),
)
_GO = (
    Option("package", "text", "name of the Go package", "vss"),
    Option("short-names", "switch", "shorten the names of structs", True),
)
_AVRO = (
    Option("namespace", "text", "prefix of the Avro namespace", "vss.struct"),
    Option("file-prefix", "name", "prefix of the file names", ""),
    Option("include-array-record", "switch", "add an array record for each struct", False),
)
_APIGEAR = tuple(
    Option(f"apigear-template-{layer}-path", "text", f"add the layer {title} with this output folder")
    for layer, title in (("unreal", "Unreal"), ("cpp", "C++14"), ("qt5", "Qt 5"), ("qt6", "Qt 6"))
)
_SAMM = (
    Option("target-namespace", "name", "namespace, and name of the folder", "com.covesa.vss.spec"),
    Option("split", "switch", "write an aspect model for each branch", True),
    Option("split-depth", "number", "down to which level branches become aspect models", 1),
    Option("signals-file", "input", "file with the paths to export, one a line"),
    _TYPES_OUTPUT,
)
_ACCESS = ("get", "set", "both")
_ROS2 = (
    EXPAND,
    Option("package-name", "name", "name of the ROS 2 package", "vss_interfaces"),
    Option("mode", "choice", "a message for each branch or for each signal", "aggregate", ("aggregate", "leaf")),
    Option("srv", "choice", "services for the latest value", choices=_ACCESS),
    Option("srv-use-msg", "switch", "let services hold the message instead of its fields", True),
    Option("timestamp-struct-fqn", "text", "struct type for time stamps; needs struct types", ""),
    Option("topics", "texts", "signals to export: a path, a name or a pattern; may be repeated"),
    Option("exclude-topics", "texts", "signals to leave out; may be repeated"),
    Option("topics-file", "input", "file with patterns, one a line"),
    Option(
        "topics-case-insensitive", "switch", "let patterns match in any case", False, off="topics-case-sensitive"
    ),
    Option("output-vspec", "output", "write the selected signals as structs with time and value to this file too"),
    Option("timeseries", "choice", "services for a range of time", choices=_ACCESS),
    Option("timeseries-delete", "flag", "services that delete stored samples"),
)  # fmt: skip
_S2DM = (
    Option("modular", "switch", "write a file for each component", False),
    Option("flat-domains", "switch", "put all domains into one folder, with --modular", True, off="nested-domains"),
    Option("fqn-type-names", "switch", "name types by their whole path", False, off="short-type-names"),
)
VHAL_MAP = "device/generic/car/emulator/vhalmap/value_map.json"
"""Where the exporter of Android properties keeps their numbers, in the folder that it writes."""
_VHAL = (
    Option("vhal-map", "state", f"numbers of the properties, kept from export to export (default: {VHAL_MAP})"),
    Option("continuous-change-mode", "input", "JSON file with the paths that change continuously"),
    Option("property-group", "number", "1 system, 2 vendor, 3 backported, 4 OEM", 4),
    Option("min-property-id", "number", "first number of new properties", 1),
    Option("extend-new", "switch", "add nodes that the map does not have", True),
    Option("override-vhal-units", "switch", "replace units of earlier exports", False),
    Option("override-vhal-datatype", "switch", "replace datatypes of earlier exports", False),
    Option("property-version", "number", "version of the AIDL interface", 4),
)

_ALL = (
    Format("json", "JSON, nested", ".json", "application/json", _JSON),
    Format("yaml", "YAML, one entry for each node", ".yaml", "application/yaml", (EXPAND, _TYPES_OUTPUT, _ALL_ATTRIBUTES, KEEP_INSTANCES)),
    Format("csv", "table of all nodes", ".csv", "text/csv", _CSV),
    Format("jsonschema", "JSON Schema of the values", ".json", "application/schema+json", _JSON_SCHEMA),
    Format("id", "static ids of all nodes", ".yaml", "application/yaml", _ID),
    Format("tree", "tree as text", ".txt", "text/plain", (EXPAND, _ATTRIBUTES)),
    Format("protobuf", "Protocol Buffers messages", ".proto", "text/plain", _PROTOBUF),
    Format("ddsidl", "DDS IDL", ".idl", "text/plain", (Option("all-idl-features", "flag", "use all of IDL 4.2"),)),
    Format("franca", "Franca IDL", ".fidl", "text/plain", (Option("franca-vss-version", "text", "version to write into the file"),)),
    Format("plantuml", "PlantUML class diagram", ".puml", "text/plain", (EXPAND, _ATTRIBUTES)),
    Format("go", "Go structs", ".go", "text/plain", _GO),
    Format("binary", "compact binary form for small targets", ".bin", "application/octet-stream", (_TYPES_OUTPUT,)),
    Format("s2dm", "GraphQL schema (S2DM)", "", "application/zip", _S2DM, copies_unit_files=True),
    Format("ros2interface", "ROS 2 messages and services", "", "application/zip", _ROS2),
    Format("samm", "SAMM aspect models", "", "application/zip", _SAMM, "target-folder"),
    Format("apigear", "ApiGear module and solution", "", "application/zip", _APIGEAR, "output-dir"),
    Format("avro", "Avro IDL of the struct types", "", "application/zip", _AVRO, needs_types=True),
    Format("vhal", "Android vehicle properties", "", "application/zip", _VHAL, "aosp-workspace-path", takes_tree_options=False, output_exists=True),
)  # fmt: skip

FORMATS: Mapping[str, Format] = {format_.name: format_ for format_ in _ALL}
_WITHOUT_STRICTNESS = ("ros2interface", "vhal")


def format_named(name: str) -> Format:
    """The format with this name. Raises NotFound with the nearest names."""
    if name not in FORMATS:
        hint = did_you_mean(name, FORMATS) or f"There are {', '.join(FORMATS)}."
        raise NotFound(f"There is no export format {name!r}. {hint}", nearest(name, FORMATS))
    return FORMATS[name]


def options_of(format_: Format) -> tuple[Option, ...]:
    """Every option of a format beside those that name the tree and the output."""
    return format_.options if format_.name in _WITHOUT_STRICTNESS else (*format_.options, *STRICTNESS)
