"""Uses with everything that answers show, versions in their order: a question reads only the rows of its answer."""

import sqlalchemy as sa
from alembic import op

revision = "2"
down_revision = "1"

_TEXT = sa.String().with_variant(sa.String(collation="C"), "postgresql")


def upgrade() -> None:
    """Make the tables that follow from the log again, with more columns; their rows are made of the log afterwards."""
    for table in ("deployments", "uses", "versions", "names"):
        op.drop_table(table)
    op.create_table(
        "names",
        sa.Column("id", sa.Integer, primary_key=True, autoincrement=False),
        *_texts("kind", "name", "folded", "rule"),
        sa.Column("newest", sa.Integer),
        sa.UniqueConstraint("kind", "folded"),
    )
    op.create_table(
        "versions",
        sa.Column("id", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("name_id", sa.Integer, sa.ForeignKey("names.id"), nullable=False),
        *_texts("version", "release", "precedence", "state", "owner"),
        *(sa.Column(name, _TEXT, sa.ForeignKey("contents.digest"), nullable=False) for name in ("content", "resolved", "uses")),
        *_texts("at", "until", "successor"),
        sa.UniqueConstraint("name_id", "release"),
    )  # fmt: skip
    op.create_index("versions_precedence", "versions", ["name_id", "precedence"])
    op.create_table(
        "reliances",
        sa.Column("id", sa.Integer, primary_key=True, autoincrement=False),
        *_texts("path", "relied"),
    )
    op.create_index("reliances_path", "reliances", ["path"])
    op.create_table(
        "uses",
        sa.Column("version_id", sa.Integer, sa.ForeignKey("versions.id"), primary_key=True),
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        *_texts("path", "element"),
        sa.Column("reliance_id", sa.Integer, sa.ForeignKey("reliances.id")),
        *_texts("text"),
    )
    op.create_index("uses_path", "uses", ["path"])
    op.create_index("uses_element", "uses", ["element"])
    op.create_table(
        "deployments",
        sa.Column("id", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("line_id", sa.Integer, sa.ForeignKey("names.id"), nullable=False),
        sa.Column("version_id", sa.Integer, sa.ForeignKey("versions.id"), nullable=False),
        *_texts("since", "until"),
    )
    op.create_index("deployments_line", "deployments", ["line_id"])
    op.create_index("deployments_version", "deployments", ["version_id"])
    op.create_table(
        "approvals",
        sa.Column("version_id", sa.Integer, sa.ForeignKey("versions.id"), primary_key=True),
        *(sa.Column(name, _TEXT, primary_key=True) for name in ("content", "uses", "owner")),
        *_texts("functions", "decision", "at", "until", "reason"),
    )
    op.create_table(
        "subscriptions",
        sa.Column("id", _TEXT, primary_key=True),
        *_texts("url", "types", "secret", "at"),
        sa.Column("number", sa.Integer, nullable=False),
    )
    op.create_table(
        "deliveries",
        sa.Column("id", _TEXT, primary_key=True),
        sa.Column("subscription_id", _TEXT, sa.ForeignKey("subscriptions.id"), nullable=False),
        sa.Column("number", sa.Integer, sa.ForeignKey("log.number"), nullable=False),
        *_texts("state"),
        sa.Column("attempts", sa.Integer, nullable=False),
        *_texts("due", "lease", "at", "answer"),
    )
    op.create_index("deliveries_due", "deliveries", ["state", "due"])
    op.create_index("deliveries_subscription", "deliveries", ["subscription_id"])


def _texts(*names: str) -> tuple[sa.Column[str], ...]:
    return tuple(sa.Column(name, _TEXT, nullable=False) for name in names)
