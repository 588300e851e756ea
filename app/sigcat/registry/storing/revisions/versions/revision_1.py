"""The first schema."""

import sqlalchemy as sa
from alembic import op

revision = "1"
down_revision = None

_TEXT = sa.String().with_variant(sa.String(collation="C"), "postgresql")


def upgrade() -> None:
    """Create the tables."""
    op.create_table(
        "contents",
        sa.Column("digest", _TEXT, primary_key=True),
        sa.Column("data", sa.LargeBinary, nullable=False),
    )
    op.create_table(
        "names",
        sa.Column("id", sa.Integer, primary_key=True, autoincrement=False),
        *_texts("kind", "name", "folded", "rule"),
        sa.UniqueConstraint("kind", "folded"),
    )
    op.create_table(
        "versions",
        sa.Column("id", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("name_id", sa.Integer, sa.ForeignKey("names.id"), nullable=False),
        *_texts("version", "release", "state", "owner"),
        *(sa.Column(name, _TEXT, sa.ForeignKey("contents.digest"), nullable=False) for name in ("content", "resolved", "uses")),
        *_texts("at", "until", "successor"),
        sa.UniqueConstraint("name_id", "release"),
    )  # fmt: skip
    op.create_table(
        "uses",
        sa.Column("version_id", sa.Integer, sa.ForeignKey("versions.id"), primary_key=True),
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        *_texts("path", "element", "relied"),
    )
    op.create_index("uses_path", "uses", ["path", "relied"])
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
        "log",
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        *_texts("text", "previous", "hash", "signature"),
    )


def _texts(*names: str) -> tuple[sa.Column[str], ...]:
    return tuple(sa.Column(name, _TEXT, nullable=False) for name in names)
