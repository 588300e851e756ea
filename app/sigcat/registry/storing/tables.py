"""Tables of the registry. `contents` and `log` are the source, and the others follow from the log.

Only `subscriptions` and `deliveries` do not: they say to whom events are sent, and which are. A changed table needs a new
revision in `revisions/`. A row of a table that follows from the log has the next free number, so that the log makes the
same rows again.
"""

from collections.abc import Iterator

from sqlalchemy import Column, ForeignKey, Index, Integer, LargeBinary, MetaData, String, Table, UniqueConstraint

SCHEMA = 3
"""Number of the schema: a program refuses a database with a higher one."""
APPLICATION = 0x51676361
"""Number by which SQLite's header names the program: a database of another one is refused."""

_TEXT = String().with_variant(String(collation="C"), "postgresql")
"""Text in the order of its bytes, whatever the language of a server."""


def texts(*names: str, kind: String = _TEXT) -> Iterator["Column[str]"]:
    """Columns of texts that may be empty, and never absent."""
    return (Column(name, kind, nullable=False) for name in names)


METADATA = MetaData()
CONTENTS = Table(
    "contents", METADATA,
    Column("digest", _TEXT, primary_key=True),
    Column("data", LargeBinary, nullable=False),
)  # fmt: skip
NAMES = Table(
    "names", METADATA,
    Column("id", Integer, primary_key=True, autoincrement=False),
    *texts("kind", "name", "folded", "rule"),
    Column("newest", Integer),  # id of the newest version that may be deployed
    UniqueConstraint("kind", "folded"),
)  # fmt: skip
VERSIONS = Table(
    "versions", METADATA,
    Column("id", Integer, primary_key=True, autoincrement=False),
    Column("name_id", ForeignKey("names.id"), nullable=False),
    *texts("version", "release", "precedence", "state", "owner"),  # the precedence has the order of versions
    Column("content", ForeignKey("contents.digest"), nullable=False),
    Column("resolved", ForeignKey("contents.digest"), nullable=False),
    Column("uses", ForeignKey("contents.digest"), nullable=False),
    *texts("at", "until", "successor"),
    UniqueConstraint("name_id", "release"),
    Index("versions_precedence", "name_id", "precedence"),
)  # fmt: skip
RELIANCES = Table(  # nodes with the attributes that functions rely on, each once however many functions do
    "reliances", METADATA,
    Column("id", Integer, primary_key=True, autoincrement=False),
    *texts("path", "relied"),
    Index("reliances_path", "path"),
)  # fmt: skip
USES = Table(
    "uses", METADATA,
    Column("version_id", ForeignKey("versions.id"), primary_key=True),
    Column("number", Integer, primary_key=True, autoincrement=False),
    *texts("path", "element"),
    Column("reliance_id", ForeignKey("reliances.id")),
    Column("text", _TEXT, nullable=False),
    Index("uses_path", "path"),
    Index("uses_element", "element"),
)  # fmt: skip
DEPLOYMENTS = Table(
    "deployments", METADATA,
    Column("id", Integer, primary_key=True, autoincrement=False),
    Column("line_id", ForeignKey("names.id"), nullable=False),
    Column("version_id", ForeignKey("versions.id"), nullable=False),
    *texts("since", "until"),
    Index("deployments_line", "line_id"),
    Index("deployments_version", "version_id"),
)  # fmt: skip
APPROVALS = Table(
    "approvals", METADATA,
    Column("version_id", ForeignKey("versions.id"), primary_key=True),
    Column("content", _TEXT, primary_key=True),
    Column("uses", _TEXT, primary_key=True),
    Column("owner", _TEXT, primary_key=True),
    *texts("functions", "decision", "at", "until", "reason"),
)  # fmt: skip
ACKNOWLEDGEMENTS = Table(  # of deprecations
    "acknowledgements", METADATA,
    Column("version_id", ForeignKey("versions.id"), primary_key=True),
    Column("owner", _TEXT, primary_key=True),
    Column("at", _TEXT, nullable=False),
)  # fmt: skip
SUBSCRIPTIONS = Table(
    "subscriptions", METADATA,
    Column("id", _TEXT, primary_key=True),
    *texts("url", "types", "secret", "at"),
    Column("number", Integer, nullable=False),
)  # fmt: skip
DELIVERIES = Table(
    "deliveries", METADATA,
    Column("id", _TEXT, primary_key=True),
    Column("subscription_id", ForeignKey("subscriptions.id"), nullable=False),
    Column("number", ForeignKey("log.number"), nullable=False),
    Column("state", _TEXT, nullable=False),
    Column("attempts", Integer, nullable=False),
    *texts("due", "lease", "at", "answer"),
    Index("deliveries_due", "state", "due"),
    Index("deliveries_subscription", "subscription_id"),
)  # fmt: skip
LOG = Table(
    "log", METADATA,
    Column("number", Integer, primary_key=True, autoincrement=False),
    *texts("text", "previous", "hash", "signature"),
)  # fmt: skip
REVISION = Table(  # of Alembic
    "alembic_version", METADATA,
    Column("version_num", String(32), primary_key=True),
)  # fmt: skip
