"""Every string of a document has a type, and no type but free text takes what could become code."""

from collections.abc import Iterator
from typing import Any, Literal, get_args, get_origin

import pytest
from pydantic import BaseModel
from pydantic.fields import FieldInfo

from sigcat.function.document import field_types
from sigcat.function.document.field_types import FREE, Grammar
from sigcat.function.document.unfit_texts import annotation_of
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.autosar_adaptive.model import IntegrationModel
from sigcat.integration.autosar_classic.model import ClassicIntegration
from sigcat.integration.ros2.model import Ros2Integration
from sigcat.platforms.deployment_file import DEPLOYMENT_FILE

ROOTS = (FunctionJson, IntegrationModel, ClassicIntegration, Ros2Integration, DEPLOYMENT_FILE)


def models(annotation: Any, found: dict[type[BaseModel], None]) -> dict[type[BaseModel], None]:
    """All models that an annotation leads to."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        if annotation not in found:
            found[annotation] = None
            for info in annotation.model_fields.values():
                models(info.annotation, found)
    else:
        for part in get_args(annotation):
            models(part, found)
    return found


MODELS = list({found: None for root in ROOTS for found in models(root, {})})


def without_type(annotation: Any) -> Iterator[Any]:
    """Strings, and values of any kind, that have no grammar."""
    parts = get_args(annotation)
    if annotation in (str, Any):
        yield annotation
    elif get_origin(annotation) is not Literal and not any(isinstance(part, Grammar) for part in parts):
        for part in parts:
            yield from without_type(part)


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.__name__)
def test_each_string_has_a_type(model):
    plain = [name for name, info in model.model_fields.items() if list(without_type(annotation_of(info)))]
    assert plain == []


def test_a_plain_string_is_found():
    info = FieldInfo.from_annotation(dict[str, list[str] | None])
    assert list(without_type(annotation_of(info))) == [str, str]


GRAMMARS = {
    name: value for name, value in vars(field_types).items() if isinstance(value, Grammar) and value is not FREE
}
PAYLOADS = (
    "*/ int evil; /*", '"; evil(); "', "'; evil(); '", "x\\", "x\nevil();", "x\revil();", "]]><evil/>", "${evil}", "$(evil)", "#) evil(",
    '"""\nevil\n"""', "??/\nevil", "x\0evil", "x\u202eevil", "x\u2066evil", "x\u2028evil", "x\u2029evil", "x\x85evil", "`evil`",
    "<script>evil</script>", "&evil;", "x;evil", "$<EVIL:x>", "@evil@", "{{ evil }}", "//evil\n", "x\u200bevil", "\ud800", "x" * 10_001,
)  # fmt: skip


@pytest.mark.parametrize("grammar", GRAMMARS.values(), ids=GRAMMARS)
def test_no_type_takes_what_a_language_interprets(grammar):
    assert [payload for payload in PAYLOADS if grammar.accepts(payload)] == []
