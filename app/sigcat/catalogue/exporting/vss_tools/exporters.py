"""The exporters of vss-tools 6.1 that write a file or a folder, with their options.

Written down here so that help, API and checks need no vss-tools code; a test compares the table with vss-tools.
"""

from typing import TYPE_CHECKING, Any

from sigcat.catalogue.exporting.exporter import Exporter, Job, Option
from sigcat.catalogue.exporting.shared_options import (
    ALL_ATTRIBUTES,
    EXPAND,
    KEEP_INSTANCES,
    OWN_STRICT,
    PRETTY,
    STRICTNESS,
    TYPES_OUTPUT,
)

if TYPE_CHECKING:
    from sigcat.catalogue.exporting.files import Export


_COMMENTS = ("description", "comment")
_CODE = (*_COMMENTS, "allowed", "instances")
"""Attributes that vss-tools writes unescaped."""
_ATTRIBUTES = Option("attr", "texts", "attribute to show at each node; may be repeated")
_JSON_SCHEMA = (
    EXPAND,
    PRETTY,
    ALL_ATTRIBUTES,
    Option("no-additional-properties", "flag", "allow no properties that the tree does not have"),
    Option("require-all-properties", "flag", "require every property of the tree"),
)
_CSV = (
    EXPAND,
    TYPES_OUTPUT,
    Option("stats-sankey", "output", "write counts for a Sankey diagram to this file too; nothing is expanded then"),
    Option("stats-piechart", "output", "write counts for a pie chart to this file too; nothing is expanded then"),
    Option("stats-old-piechart", "input", "earlier counts that --stats-piechart continues"),
)
_ID = (
    EXPAND,
    TYPES_OUTPUT,
    Option("validate-static-uid", "input", "earlier export of ids that the new one is compared with"),
    Option("case-sensitive", "flag", "let ids depend on the case of names"),
)
KEEP_NUMBERS = "keep-numbers-of"
_PROTOBUF = (
    Option(
        KEEP_NUMBERS,
        "state",
        "JSON file with the numbers of fields: they stay from export to export; the file is read, if it exists, and written",
        own=True,
    ),
    Option("types-out-dir", "folder", "folder for the struct types"),
    Option("static-uid", "flag", "number fields by the attribute `staticUID`"),
    Option("add-optional", "flag", "make every field optional"),
    Option("include-comments", "flag", "write descriptions and metadata as comments"),
)
_GO = (
    Option("package", "identifier", "name of the Go package", "vss"),
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
    Option("target-namespace", "name", "namespace, and name of the folder", "com.covesa.vss.spec", also=("-tns",)),
    Option("split", "switch", "write an aspect model for each branch", True, also=("-spl",)),
    Option("split-depth", "number", "down to which level branches become aspect models", 1, also=("-spld",)),
    Option("signals-file", "input", "file with the paths to export, one a line", also=("-sigf",)),
    TYPES_OUTPUT,
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
    OWN_STRICT,
)  # fmt: skip
_S2DM = (
    Option("modular", "switch", "write a file for each component", False),
    Option("flat-domains", "switch", "put all domains into one folder, with --modular", True, off="nested-domains"),
    Option("fqn-type-names", "switch", "name types by their whole path", False, off="short-type-names"),
)
VHAL_MAP = "device/generic/car/emulator/vhalmap/value_map.json"
"""File with the numbers of Android properties, in the folder that the exporter writes."""
_VHAL = (
    Option(
        "vhal-map",
        "state",
        f"numbers of the properties, kept from export to export (default: {VHAL_MAP})",
        kept_at=VHAL_MAP,
    ),
    Option("continuous-change-mode", "input", "JSON file with the paths that change continuously"),
    Option("property-group", "number", "1 system, 2 vendor, 3 backported, 4 OEM", 4),
    Option("min-property-id", "number", "first number of new properties", 1),
    Option("extend-new", "switch", "add nodes that the map does not have", True),
    Option("override-vhal-units", "switch", "replace units of earlier exports", False),
    Option("override-vhal-datatype", "switch", "replace datatypes of earlier exports", False),
    Option("property-version", "number", "version of the AIDL interface", 4),
    OWN_STRICT,
)


def _run(job: Job) -> "Export":
    from sigcat.catalogue.exporting.vss_tools.running import run

    return run(job)


def _run_numbered(job: Job) -> "Export":
    """Export with the numbers of a lock, and return the lock with those of new fields."""
    path = job.options.get(KEEP_NUMBERS)
    if path is None:
        return _run(job)
    from sigcat.catalogue.exporting.field_numbers import (
        ATTRIBUTE,
        EMPTY,
        continued,
        lock_bytes,
        read_lock,
        with_numbers,
    )
    from sigcat.catalogue.exporting.files import ExportedFile
    from sigcat.errors import UsageError

    if job.options.get("static-uid"):
        raise UsageError(f"Pass either --{KEEP_NUMBERS} or --static-uid: each numbers all fields.")
    lock = continued(read_lock(path) if path.is_file() else EMPTY, job.catalogue)
    attributes = (*job.options.get("extended-attributes", ()), ATTRIBUTE)
    options = {name: value for name, value in job.options.items() if name != KEEP_NUMBERS}
    options |= {"static-uid": True, "extended-attributes": attributes}
    made = _run(job._replace(catalogue=with_numbers(job.catalogue, lock), options=options))
    return made._replace(files=(*made.files, ExportedFile(path.name, lock_bytes(lock), KEEP_NUMBERS)))


def _exporter(name: str, text: str, suffix: str, media_type: str, options: tuple[Option, ...], **rest: Any) -> Exporter:
    return Exporter(name, text, suffix, media_type, options, _run, same_as=f"vspec export {name}", **rest)


def _file(name: str, text: str, suffix: str, media_type: str, *options: Option, **rest: Any) -> Exporter:
    return _exporter(name, text, suffix, media_type, (*options, *STRICTNESS), **rest)


def _folder(name: str, text: str, *options: Option, **rest: Any) -> Exporter:
    return _exporter(name, text, "", "application/zip", options, **rest)


VSS_TOOLS = (
    _file("yaml", "YAML, one entry for each node", ".yaml", "application/yaml", EXPAND, TYPES_OUTPUT, ALL_ATTRIBUTES, KEEP_INSTANCES),
    _file("csv", "table of all nodes", ".csv", "text/csv", *_CSV),
    _file("jsonschema", "JSON Schema of the values", ".json", "application/schema+json", *_JSON_SCHEMA),
    _file("id", "static ids of all nodes", ".yaml", "application/yaml", *_ID, has_types_beside=True),
    _file("tree", "tree as text", ".txt", "text/plain", EXPAND, _ATTRIBUTES, unescaped=_COMMENTS),
    _file("protobuf", "Protocol Buffers messages", ".proto", "text/plain", *_PROTOBUF, has_types_beside=True, has_value_names=True, unescaped=("allowed", "instances"))._replace(run=_run_numbered),
    _file("ddsidl", "DDS IDL", ".idl", "text/plain", Option("all-idl-features", "flag", "use all of IDL 4.2"), unescaped=_CODE),
    _file("franca", "Franca IDL", ".fidl", "text/plain", Option("franca-vss-version", "text", "version to write into the file"), unescaped=_CODE),
    _file("plantuml", "PlantUML class diagram", ".puml", "text/plain", EXPAND, _ATTRIBUTES, unescaped=("description", "allowed", "instances")),
    _file("go", "Go structs", ".go", "text/plain", *_GO, unescaped=("instances",)),
    _file("binary", "compact binary form for small targets", ".bin", "application/octet-stream", TYPES_OUTPUT),
    _folder("s2dm", "GraphQL schema (S2DM)", *_S2DM, *STRICTNESS, refuses_ending=True),
    _folder("ros2interface", "ROS 2 messages and services", *_ROS2, unescaped=_CODE, refuses_types=True),
    _folder("samm", "SAMM aspect models", *_SAMM, *STRICTNESS, output_also=("--target-folder", "-tf")),
    _folder("apigear", "ApiGear module and solution", *_APIGEAR, *STRICTNESS, output_also=("--output-dir",)),
    _folder("avro", "Avro IDL of the struct types", *_AVRO, *STRICTNESS, needs_types=True),
    _folder("vhal", "Android vehicle properties", *_VHAL, output_also=("--aosp-workspace-path",), unescaped=_COMMENTS, refuses_types=True),
)  # fmt: skip
