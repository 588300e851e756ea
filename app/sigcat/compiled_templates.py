"""Templates that were compiled before, kept the way Python keeps compiled modules."""

from pathlib import Path

import jinja2
from jinja2.bccache import Bucket, BytecodeCache

from sigcat.compiled_values import Stamp, read_values, stamp_of, write_values


class CompiledTemplates(BytecodeCache):
    """To compile the templates of one platform takes a second, and each process that generates would do it again."""

    def __init__(self, environment: Path) -> None:
        """`environment` is the module that sets the options of the templates: after a change of it they are compiled again."""
        self._environment = environment

    def load_bytecode(self, bucket: Bucket) -> None:
        """Take the code of the same source, if there is one."""
        bucket.code = read_values(self._environment.parent, _name(bucket), self._stamp(bucket))

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Keep the code, if the folder can be written."""
        write_values(self._environment.parent, _name(bucket), self._stamp(bucket), bucket.code)

    def _stamp(self, bucket: Bucket) -> Stamp:
        options = stamp_of((self._environment,))
        return options and (*options, (f"{jinja2.__version__} {bucket.checksum}", 0, 0))


def _name(bucket: Bucket) -> str:
    return f"template-{bucket.key}"
