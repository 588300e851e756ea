"""Free text of documents is not a string of Python: code that writes it must choose a filter."""

import json
import pickle
from collections.abc import Callable

import pytest
from pydantic import BaseModel, ConfigDict, ValidationError

from sigcat.function.document.text import Text, composed, optional, sentence

TEXT = Text("<b> */")


class Document(BaseModel):
    model_config = ConfigDict(strict=True, frozen=True)

    text: Text
    other: Text | None = None


@pytest.mark.parametrize(
    "written",
    [
        lambda: f"{TEXT}",
        lambda: f"{TEXT:>5}",
        lambda: "%s" % TEXT,  # noqa: UP031
        lambda: "{}".format(TEXT),  # noqa: UP032
        lambda: str(TEXT),
        lambda: " ".join(["a", TEXT]),  # type: ignore[list-item]  # noqa: FLY002
        lambda: "a" + TEXT,  # type: ignore[operator]
        lambda: json.dumps(TEXT),
    ],
)
def test_it_cannot_be_put_into_a_string(written: Callable[[], str]):
    with pytest.raises(TypeError):
        written()


def test_the_error_says_what_writes_it():
    with pytest.raises(TypeError, match=r"sigcat\.function\.document\.text_filters"):
        str(TEXT)


def test_its_form_for_developers_tells_none_of_it():
    assert f"{TEXT!r}" == "<Text of 6 characters>"


def test_pages_show_it_escaped():
    assert TEXT.__html__() == "&lt;b&gt; */"


def test_documents_have_it_as_a_string():
    document = Document.model_validate_json('{"text": "<b> */"}')
    assert document == Document(text=TEXT)
    assert document.model_dump() == {"text": "<b> */", "other": None}
    assert document.model_dump_json() == '{"text":"<b> */","other":null}'
    assert Document.model_json_schema()["properties"]["text"] == {"title": "Text", "type": "string"}


def test_documents_are_refused_as_with_a_string():
    with pytest.raises(ValidationError) as refused:
        Document.model_validate({"text": 1})
    (error,) = refused.value.errors()
    assert (error["type"], error["loc"], error["msg"]) == ("string_type", ("text",), "Input should be a valid string")


def test_it_is_a_value():
    assert pickle.loads(pickle.dumps(TEXT)) == TEXT
    assert len({TEXT, Text("<b> */")}) == 1
    assert sorted([Text("b"), Text("a")]) == [Text("a"), Text("b")]
    assert not Text("")
    with pytest.raises(AttributeError):
        TEXT.raw = ""  # type: ignore[misc]


def test_texts_are_put_together():
    assert composed("a ", Text("b"), ".") == Text("a b.")
    assert optional(None) is None
    assert sentence(Text(" Speed. "), None, "km/h", Text("")) == Text("Speed; km/h.")
    assert sentence("Is it?") == Text("Is it?")
    assert sentence(None) == Text("")
