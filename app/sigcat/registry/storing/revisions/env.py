"""Alembic runs this module for each of its commands: all of a command is one transaction of the given connection."""

from alembic import context

from sigcat.registry.storing.tables import METADATA

context.configure(connection=context.config.attributes["connection"], target_metadata=METADATA)
context.run_migrations()
