"""Forms as a browser posts them."""

import tracemalloc
from concurrent.futures import ThreadPoolExecutor

import pytest

from sigcat.api.answers.problems import BodyRefused
from sigcat.errors import UsageError
from sigcat.web import forms
from sigcat.web.forms import Form, PostedFile

TYPE = "multipart/form-data; boundary=----x1"


def read_form(body: bytes, content_type: str) -> Form:
    """Read in a separate thread: next to a browser, this one has an event loop already."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(forms.read_form, forms.posted_form(body, content_type)).result()


def multipart(*parts: tuple[str, bytes]) -> bytes:
    """The body of a form; each part with the text after `form-data` in its head."""
    pieces = [f"------x1\r\nContent-Disposition: form-data{head}\r\n\r\n".encode() + data for head, data in parts]
    return b"\r\n".join([*pieces, b"------x1--\r\n"])


def test_fields_keep_their_order_and_the_last_one_counts() -> None:
    form = read_form(b"f=a&f=b&text=one%0D%0Atwo", "application/x-www-form-urlencoded")
    assert form.every("f") == ("a", "b")
    assert (form.last("f"), form.last("g", "none"), form.text("text")) == ("b", "none", "one\ntwo")


def test_files_come_with_their_names_and_as_they_are() -> None:
    data = b"\xef\xbb\xbfa: 1\r\n\r\nb: \x00\xff\r\n"
    form = read_form(
        multipart(('; name="f"', b"core_acc"), ('; name="file"; filename="br\u00e4ke %22x%22.yaml"', data)), TYPE
    )
    assert form.fields == (("f", "core_acc"),)
    assert form.files == (PostedFile("bräke %22x%22.yaml", data),)


def test_bytes_that_are_no_utf8_stay_in_files_and_are_marked_in_texts() -> None:
    body = multipart(('; name="text"', b"a\xffb \xc3\xa4"), ('; name="file"; filename="br.yaml"', b"\xff\xfe"))
    form = read_form(body.replace(b"br.yaml", b"\xe4.yaml"), TYPE)
    assert form.fields == (("text", "a\ufffdb ä"),)
    assert form.files == (PostedFile("\ufffd.yaml", b"\xff\xfe"),)


def test_a_field_may_be_as_long_as_a_body() -> None:
    assert len(read_form(multipart(('; name="text"', b"x" * 2_000_000)), TYPE).text("text")) == 2_000_000


def test_a_field_for_files_in_which_none_was_chosen_is_no_file() -> None:
    assert read_form(multipart(('; name="file"; filename=""', b"")), TYPE).files == ()


def test_a_part_that_calls_itself_another_multipart_is_a_part() -> None:
    inner = '; name="a"\r\nContent-Type: multipart/mixed; boundary=----x2'
    assert read_form(multipart((inner, b"------x2\r\n\r\nb")), TYPE).fields == (("a", "------x2\r\n\r\nb"),)


@pytest.mark.parametrize(
    ("body", "content_type"),
    [
        (b"&".join(b"a=1" for _ in range(100)), "application/x-www-form-urlencoded"),
        (multipart(*(('; name="a"', b"1") for _ in range(100))), TYPE),
        (multipart(*(('; name="a"; filename="b"', b"1") for _ in range(100))), TYPE),
        (multipart(('; name="a"', b"1"))[:-6], TYPE),
        (multipart(("", b"1")), TYPE),
        (multipart(('; name="a"\r\nno header', b"1")), TYPE),
        (b"", TYPE),
        (b"------x1", TYPE),
    ],
)
def test_a_form_with_too_much_or_too_little_is_refused(body: bytes, content_type: str) -> None:
    with pytest.raises(UsageError):
        read_form(body, content_type)


OTHERS = ["", "application/json", "multipart/form-data", "multipart/form-data; boundary=", "text/plain", "="]


@pytest.mark.parametrize("content_type", OTHERS)
def test_what_is_no_form_is_refused_and_not_dropped(content_type: str) -> None:
    with pytest.raises(BodyRefused) as refused:
        read_form(b"kind=overlay&text=Vehicle", content_type)
    assert refused.value.status_code == 415
    assert "x-www-form-urlencoded" in refused.value.detail


@pytest.mark.parametrize("body", [b"", b"\xff\x00", b"=&&=", b"--\r\n--"])
def test_a_form_may_have_odd_fields_or_none(body: bytes) -> None:
    assert read_form(body, "application/x-www-form-urlencoded").files == ()


@pytest.mark.parametrize(("escape", "meant"), [("%41", "A"), ("%C3%A4", "ä"), ("%", "%"), ("%4", "%4"), ("+", " ")])
def test_many_escapes_are_read_in_little_memory(escape: str, meant: str) -> None:
    body = f"text={escape * 200_000}&kind=tree".encode()
    tracemalloc.start()
    form = read_form(body, "application/x-www-form-urlencoded")
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert form.fields == (("text", meant * 200_000), ("kind", "tree"))
    assert most < 20_000_000
