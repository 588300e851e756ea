"""Rooms that write files of other languages put values into comments and strings through `text_filters` alone.

The test reads their source: in each text that is put together, it looks where the values stand.
"""

import ast
import inspect
import re
import string
import sys
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from jinja2 import Environment, nodes

import sigcat
from sigcat.adapter import templates
from sigcat.function.document import text_filters
from sigcat.platforms.table import PLATFORMS

SOURCE = Path(sigcat.__file__).parent
ROOMS = ("adapter", "comparison", "players", "runs")
SHIPPED = re.compile(r"/support(_of_humble)?/")
"""Files that are copied as they are."""
FILTERS = {
    *(
        name
        for name, value in vars(text_filters).items()
        if callable(value) and value.__module__ == text_filters.__name__
    ),
    "commented",  # each wraps rows of comments as its language is laid out
    "dumps",
    "escape",
}
NUMBERS = re.compile(r"[\d.,]*[dgfeXx]|,")
"""Format specifications of numbers."""
PICTURES = {"comparison/report/drawing.py", "runs/recording/svg_file.py"}
"""Files whose attributes are positions, which they have computed."""
AS_THEY_ARE = {
    "setting": "a name of CMake, made of a function's",
    "base": "the same in ${}",
    "swc.core.code_setting": "the same",
    "component.core.code_setting": "the same",
    "_anchor(each)": "made of a heading of ours",
    "_anchor(section)": "the same",
    "cell.tone": "one of three words",
    "doubled": "a cell, with its quotation marks doubled",
    "symbol": "in a message to the user",
    "values": "behind `/**:`, which is a key of YAML",
    "body": "the same",
}
"""Values that are in comments and strings without a filter, and why that is safe."""


class Part(NamedTuple):
    """A piece of a text that is put together: its text, or the value in its place."""

    text: str
    value: Any = None
    """An expression of Python or Jinja."""
    is_number: bool = False


def files() -> list[Path]:
    found = [path for room in ROOMS for path in (SOURCE / room).rglob("*.py")]
    return sorted(path for path in found if not SHIPPED.search(path.as_posix()) and path.name != "text_filters.py")


def texts(tree: ast.AST) -> Iterator[list[Part]]:
    """Texts that a module puts together: f-strings, sums and templates that are formatted."""
    constants = {
        target.id: node.value.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
        for target in node.targets
        if isinstance(target, ast.Name)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            yield list(_joined(node))
        elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            yield [part for each in _added(node) for part in each]
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "format":
            template = node.func.value
            text = template.value if isinstance(template, ast.Constant) else constants.get(getattr(template, "id", ""))
            if isinstance(text, str):
                yield list(_formatted(text, {each.arg: each.value for each in node.keywords if each.arg}))


def _joined(node: ast.JoinedStr) -> Iterator[Part]:
    for each in node.values:
        if isinstance(each, ast.FormattedValue):
            spec = "".join(
                str(part.value) for part in getattr(each.format_spec, "values", ()) if isinstance(part, ast.Constant)
            )
            yield Part("", each.value, bool(NUMBERS.fullmatch(spec)))
        elif isinstance(each, ast.Constant):
            yield Part(str(each.value))


def _added(node: ast.expr) -> Iterator[list[Part]]:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        yield from _added(node.left)
        yield from _added(node.right)
    elif isinstance(node, ast.JoinedStr):
        yield list(_joined(node))
    else:
        is_text = isinstance(node, ast.Constant) and isinstance(node.value, str)
        yield [Part(node.value) if is_text else Part("", node)]  # type: ignore[attr-defined]


def _formatted(text: str, given: Mapping[str, ast.expr]) -> Iterator[Part]:
    for before, name, spec, _ in string.Formatter().parse(text):
        yield Part(before)
        if name is not None:
            yield Part("", given.get(name), bool(NUMBERS.fullmatch(spec or "")))


_OPENS = re.compile(r"""/\*|(?<!:)//|(?:^|(?<=\n)|(?<=  ))\#(?=\ )|"|(?<![\w.\])])'""", re.VERBOSE)
_CLOSES = {"/*": r"\*/", "//": r"\n", "#": r"\n", '"': r'(?<!\\)"|\n', "'": r"(?<!\\)'|\n"}


def inside(parts: Iterable[Part]) -> Iterator[Any]:
    """Values in a comment or in a string."""
    opened: str | None = None
    for part in parts:
        if part.value is not None:
            if opened and not part.is_number:
                yield part.value
            continue
        text = part.text
        while match := re.search(_CLOSES[opened] if opened else _OPENS, text):
            opened = None if opened else match[0]
            text = text[match.end() :]


def is_filtered(value: ast.expr, known: Mapping[str, list[ast.expr]]) -> bool:
    """Whether a filter has made it, or it is a literal of the source. `known` are the values of variables of the module."""
    if isinstance(value, ast.Constant) or ast.unparse(value) in {*FILTERS, *AS_THEY_ARE}:
        return True
    if isinstance(value, ast.Call):
        name = value.func.attr if isinstance(value.func, ast.Attribute) else getattr(value.func, "id", "")
        return name in FILTERS or (name in ("join", "map") and is_filtered(value.args[0], known))
    if isinstance(value, ast.Name):
        return value.id in known and all(is_filtered(each, {}) for each in known[value.id])
    parts = _values_of(value)
    return bool(parts) and all(is_filtered(each, known) for each in parts)


def _values_of(value: ast.expr) -> list[ast.expr]:
    if isinstance(value, ast.IfExp):
        return [value.body, value.orelse]
    if isinstance(value, ast.JoinedStr):
        return [part.value for part in _joined(value) if part.value]
    return [value.elt] if isinstance(value, ast.GeneratorExp) else []


def variables(tree: ast.AST) -> Mapping[str, list[ast.expr]]:
    found: dict[str, list[ast.expr]] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            found.setdefault(node.targets[0].id, []).append(node.value)
    return {name: values for name, values in found.items() if name not in AS_THEY_ARE}


def bypasses(source: str) -> list[str]:
    """Values of a module that are in a comment or a string without a filter."""
    tree = ast.parse(source)
    known = variables(tree)
    found = [value for parts in texts(tree) for value in inside(parts) if not is_filtered(value, known)]
    return sorted({f"{value.lineno}: {ast.unparse(value)}" for value in found})


@pytest.mark.parametrize(
    "source",
    [
        'f"/* {name} */"', 'f"int a; // {name}"', """f'x = "{name}";'""", 'f"# {name}\\n"', """'"' + name + '"'""",
        """'set(A "{x}")'.format(x=name)""", """TEMPLATE = '/* {x} */'\nTEMPLATE.format(x=name)""", """f"a = '{name}'\"""",
        'text = name.upper()\nf"/* {text} */"',
    ],
)  # fmt: skip
def test_a_value_that_bypasses_the_filters_is_found(source: str) -> None:
    assert len(bypasses(source)) == 1


@pytest.mark.parametrize(
    "source",
    [
        'f"{name} x; /* known */"', 'f"/* {comment(name)} */ {name}"', 'f"{c_string(name)}, {name}"', 'f"\\"{number:d}\\""',
        'text = comment(name)\nf"/* {text} */"', 'f"{name}://{name}"',
    ],
)  # fmt: skip
def test_a_value_that_goes_through_a_filter_is_not_found(source: str) -> None:
    assert bypasses(source) == []


def test_values_stand_in_comments_and_strings_through_filters_alone() -> None:
    sources = {path.relative_to(SOURCE).as_posix(): path.read_text() for path in files()}
    found = {name: bypasses(source) for name, source in sources.items() if name not in PICTURES}
    assert {name: values for name, values in found.items() if values} == {}


def test_nobody_else_takes_the_characters_of_a_text() -> None:
    sources = {str(path): path.read_text() for path in files()}
    assert [
        f"{name}:{node.lineno}"
        for name, source in sources.items()
        if ".raw" in source
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.Attribute) and node.attr == "raw"
    ] == []


def test_every_generator_is_in_these_rooms() -> None:
    """The platforms name generators, whose modules import what writes their files."""
    modules = {
        module.__name__
        for platform in PLATFORMS.values()
        for generator in platform.generators
        for module in [inspect.getmodule(generator.generate)]
        if module is not None
    }
    imported = {
        node.module
        for module in modules
        for node in ast.walk(ast.parse(inspect.getsource(sys.modules[module])))
        if isinstance(node, ast.ImportFrom) and node.module and any(each.name == "generate" for each in node.names)
    }
    assert len(imported) >= len(PLATFORMS)
    assert {module.split(".")[1] for module in imported} <= set(ROOMS)


# -- templates ------------------------------------------------------------------------------------------------------

TEMPLATES = [path for room in ROOMS for path in sorted((SOURCE / room).rglob("*.j2"))]
ENVIRONMENT = Environment(trim_blocks=True, lstrip_blocks=True)


def parts_of(node: nodes.Node) -> Iterator[Part]:
    """Texts and values of a template, in their order."""
    for each in node.iter_child_nodes():
        if isinstance(each, nodes.TemplateData):
            yield Part(each.data)
        elif isinstance(each, nodes.Expr):
            if isinstance(node, nodes.Output):
                yield Part("", each)
        else:
            yield from parts_of(each)


def is_harmless(value: nodes.Node) -> bool:
    """Whether a filter has made it, or it is a literal of the template."""
    if isinstance(value, nodes.CondExpr):
        return is_harmless(value.expr1) and (value.expr2 is None or is_harmless(value.expr2))
    if isinstance(value, nodes.Filter) and value.name == "join" and value.node is not None:
        return is_harmless(value.node)
    return isinstance(value, nodes.Const) or (isinstance(value, nodes.Filter) and value.name in FILTERS)


def bypasses_of_template(source: str) -> list[int]:
    """Lines of a template with a value in a comment or a string without a filter."""
    return [value.lineno for value in inside(parts_of(ENVIRONMENT.parse(source))) if not is_harmless(value)]


@pytest.mark.parametrize(
    "source",
    [
        "/* {{ name }} */",
        '"{{ name }}"',
        "int a; // {% if a %}{{ name }}{% endif %}",
        "# {{ name | upper }}\n",
        "# {{ a ~ b }}\n",
    ],
)
def test_a_value_of_a_template_that_bypasses_the_filters_is_found(source: str) -> None:
    assert bypasses_of_template(source) == [1]


@pytest.mark.parametrize("source", ["/* {{ name | comment }} */ {{ name }}", '"{{ "a" if b else "c" }}"'])
def test_a_value_of_a_template_that_goes_through_a_filter_is_not_found(source: str) -> None:
    assert bypasses_of_template(source) == []


def test_values_of_templates_stand_in_comments_and_strings_through_filters_alone() -> None:
    found = {str(path): bypasses_of_template(path.read_text()) for path in TEMPLATES}
    assert {path: lines for path, lines in found.items() if lines} == {}


@pytest.mark.parametrize("name", templates._FILTERS)
def test_a_filter_of_templates_is_used(name: str) -> None:
    assert any(re.search(rf"(\||map\()\s*[\"']?{name}\b", path.read_text()) for path in TEMPLATES)
