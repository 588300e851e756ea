"""Tables of the registry. `contents` and `log` are the source, and the others follow from the log.

Only `subscriptions` and `deliveries` do not: they say to whom events are sent, and which are.
"""

from sqlalchemy import Column, ForeignKey, Index, Integer, LargeBinary, MetaData, String, Table, UniqueConstraint

SCHEMA = 1
"""Number of the schema: a program refuses a database with a higher one."""
APPLICATION = 0x51676361
"""Number by which SQLite's header names the program: a database of another one is refused."""

METADATA = MetaData()
CONTENTS = Table(
    "contents", METADATA,
    Column("digest", String, primary_key=True),
    Column("data", LargeBinary, nullable=False),
)  # fmt: skip
NAMES = Table(
    "names", METADATA,
    Column("id", Integer, primary_key=True),
    Column("kind", String, nullable=False),
    Column("name", String, nullable=False),
    Column("folded", String, nullable=False),
    Column("rule", String, nullable=False),
    UniqueConstraint("kind", "folded"),
)  # fmt: skip
VERSIONS = Table(
    "versions", METADATA,
    Column("id", Integer, primary_key=True),
    Column("name_id", ForeignKey("names.id"), nullable=False),
    Column("version", String, nullable=False),
    Column("release", String, nullable=False),
    Column("state", String, nullable=False),
    Column("owner", String, nullable=False),
    Column("content", ForeignKey("contents.digest"), nullable=False),
    Column("resolved", ForeignKey("contents.digest"), nullable=False),
    Column("uses", ForeignKey("contents.digest"), nullable=False),
    Column("at", String, nullable=False),
    Column("until", String, nullable=False),
    Column("successor", String, nullable=False),
    UniqueConstraint("name_id", "release"),
)  # fmt: skip
USES = Table(
    "uses", METADATA,
    Column("version_id", ForeignKey("versions.id"), primary_key=True),
    Column("number", Integer, primary_key=True),
    Column("path", String, nullable=False),
    Column("element", String, nullable=False),
    Column("relied", String, nullable=False),
    Index("uses_path", "path", "relied"),
    Index("uses_element", "element"),
)  # fmt: skip
DEPLOYMENTS = Table(
    "deployments", METADATA,
    Column("id", Integer, primary_key=True),
    Column("line_id", ForeignKey("names.id"), nullable=False),
    Column("version_id", ForeignKey("versions.id"), nullable=False),
    Column("since", String, nullable=False),
    Column("until", String, nullable=False),
    Index("deployments_line", "line_id"),
    Index("deployments_version", "version_id"),
)  # fmt: skip
APPROVALS = Table(
    "approvals", METADATA,
    Column("version_id", ForeignKey("versions.id"), primary_key=True),
    Column("content", String, primary_key=True),
    Column("uses", String, primary_key=True),
    Column("owner", String, primary_key=True),
    Column("functions", String, nullable=False),
    Column("decision", String, nullable=False),
    Column("at", String, nullable=False),
    Column("until", String, nullable=False),
    Column("reason", String, nullable=False),
)  # fmt: skip
SUBSCRIPTIONS = Table(
    "subscriptions", METADATA,
    Column("id", String, primary_key=True),
    Column("url", String, nullable=False),
    Column("types", String, nullable=False),
    Column("secret", String, nullable=False),
    Column("at", String, nullable=False),
    Column("number", Integer, nullable=False),
)  # fmt: skip
DELIVERIES = Table(
    "deliveries", METADATA,
    Column("id", String, primary_key=True),
    Column("subscription_id", ForeignKey("subscriptions.id"), nullable=False),
    Column("number", ForeignKey("log.number"), nullable=False),
    Column("state", String, nullable=False),
    Column("attempts", Integer, nullable=False),
    Column("due", String, nullable=False),
    Column("lease", String, nullable=False),
    Column("at", String, nullable=False),
    Column("answer", String, nullable=False),
    Index("deliveries_due", "state", "due"),
    Index("deliveries_subscription", "subscription_id"),
)  # fmt: skip
LOG = Table(
    "log", METADATA,
    Column("number", Integer, primary_key=True),
    Column("text", String, nullable=False),
    Column("previous", String, nullable=False),
    Column("hash", String, nullable=False),
    Column("signature", String, nullable=False),
)  # fmt: skip
