"""Options that several exporters have."""

from sigcat.catalogue.exporting.exporter import Option

EXPAND = Option("expand", "switch", "expand instances", True)
KEEP_INSTANCES = Option(
    "keep-instances",
    "flag",
    "keep `instances` at the branches that were expanded, beside what they expand to",
    own=True,
)
TYPES_OUTPUT = Option("types-output", "output", "write the struct types to a separate file")
ALL_ATTRIBUTES = Option("extend-all-attributes", "switch", "keep all extended attributes", False)
PRETTY = Option("pretty", "switch", "indent the output", False)
STRICT = Option("strict", "switch", "refuse every tree with errors, and whatever --aborts can refuse", False)
OWN_STRICT = Option("strict", "flag", "refuse every tree with errors", own=True)
"""The same for exporters for which vss-tools has no such option."""
STRICTNESS = (
    Option("extended-attributes", "texts", "extended attribute to keep and to accept; may be repeated", also=("-e",)),
    STRICT,
    Option(
        "aborts", "texts", "kind of problem that ends the export; may be repeated",
        choices=("name-style", "unknown-attribute", "default-matches-first-allowed"), also=("-a",),
    ),
    Option("strict-exceptions", "input", "YAML file with the paths that --strict and --aborts leave alone"),
)  # fmt: skip
"""Checks of vss-tools during an export."""
