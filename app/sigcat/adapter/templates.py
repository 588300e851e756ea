"""Templates of generated files. Each has the suffix of its file and `.j2`, and is next to the module that gives it its names.

A template gets every name and number as it is written. Free text reaches a file through a filter, which knows the place; `Text` refuses to be
written without one, and a name that the template is not given is an error.
"""

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import sigcat
from sigcat.adapter.origins import origin
from sigcat.function.document import text_filters
from sigcat.function.document.text import composed

if TYPE_CHECKING:
    from jinja2 import Environment

_FILTERS = (
    "comment", "block_comment", "comment_rows", "ros_comment_rows", "ros_string", "ros_number", "c_string", "c_strings", "c_header", "c_format",
    "cmake_argument", "cmake_word", "python_string", "python_strings", "docstring_text", "xml_text", "markdown", "markdown_code",
    "mermaid_text", "milliseconds",
)  # fmt: skip


def rendered(template: str, /, **names: Any) -> str:
    """Text of a generated file. `template` is the path of its template in the package."""
    return _environment().get_template(template).render(names)


@cache
def _environment() -> "Environment":
    from jinja2 import Environment, FileSystemLoader, StrictUndefined  # only where files are generated

    from sigcat.compiled_templates import CompiledTemplates

    environment = Environment(
        loader=FileSystemLoader(Path(sigcat.__file__).parent),
        autoescape=False,  # noqa: S701 -- files of C, C++, CMake and Python: HTML has a filter
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        bytecode_cache=CompiledTemplates(Path(__file__)),
    )
    environment.filters.update({name: getattr(text_filters, name) for name in _FILTERS})
    environment.globals["sigcat_version"] = sigcat.__version__
    environment.filters["origin"] = origin
    environment.filters["composed"] = lambda parts: composed(*parts)
    return environment
