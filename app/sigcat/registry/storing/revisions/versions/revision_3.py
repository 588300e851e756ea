"""Acknowledgements of deprecations."""

import sqlalchemy as sa
from alembic import op

revision = "3"
down_revision = "2"

_TEXT = sa.String().with_variant(sa.String(collation="C"), "postgresql")


def upgrade() -> None:
    """Add the table."""
    op.create_table(
        "acknowledgements",
        sa.Column("version_id", sa.Integer, sa.ForeignKey("versions.id"), primary_key=True),
        sa.Column("owner", _TEXT, primary_key=True),
        sa.Column("at", _TEXT, nullable=False),
    )
