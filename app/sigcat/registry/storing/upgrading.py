"""Upgrade the schema of a database by the revisions of Alembic. The tables that follow from the log are made again."""

from pathlib import Path

from alembic import command
from alembic.config import Config
from sqlalchemy import Connection, delete, select

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.registry.reference import refused
from sigcat.registry.storing.entry import Link
from sigcat.registry.storing.replay import DERIVED, apply
from sigcat.registry.storing.tables import LOG

_REVISIONS = Path(__file__).with_name("revisions")


def upgrade(connection: Connection, schema: int) -> None:
    """Upgrade from a schema, in the transaction of the connection. Raises InputRefused; then nothing may be kept."""
    config = config_of(connection)
    command.stamp(config, str(schema))  # a file of schema 1 has its number in the header alone
    command.upgrade(config, "head")
    for table in reversed(DERIVED):
        connection.execute(delete(table))
    for row in connection.execute(select(LOG).order_by(LOG.c.number)).all():
        _apply(connection, Link(*row))


def config_of(connection: Connection) -> Config:
    """The configuration of Alembic for a connection."""
    config = Config(attributes={"connection": connection})
    config.set_main_option("script_location", str(_REVISIONS).replace("%", "%%"))
    return config


def _apply(connection: Connection, link: Link) -> None:
    try:
        apply(connection, link.entry)
    except InputRefused:
        raise
    except Exception as error:
        message = (
            f"The schema cannot be upgraded: entry {link.number} of the log was changed, or what it needs is missing."
        )
        fix = "Restore the database from a backup or an export."
        raise refused(codes.LOG_CHANGED.finding(message, path=f"log/{link.number}", fix=fix)) from error
