"""Exports of these tests run as in a service: vss-tools is imported once, where a command would import it each time."""

from collections.abc import Iterator

import pytest

from sigcat.catalogue.exporting.vss_tools import processes


@pytest.fixture(scope="session")
def warm_exports() -> Iterator[object]:
    """The process that has imported vss-tools."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(processes, "_zygote", None)
        processes.keep_warm()
        assert processes._zygote is not None
        yield processes._zygote
        processes._zygote.close()


@pytest.fixture(autouse=True)
def _as_in_a_service(warm_exports: object, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(processes, "_zygote", warm_exports)


@pytest.fixture
def as_a_command(_as_in_a_service: None, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each export in a fresh process, as commands do it."""
    monkeypatch.setattr(processes, "_zygote", None)
