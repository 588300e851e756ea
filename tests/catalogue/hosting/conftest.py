"""The misbehaving server, and an empty data folder."""

import pytest

from tests.catalogue.hosting.server import serving


@pytest.fixture(scope="session")
def server():
    with serving() as address:
        yield address


@pytest.fixture
def data(tmp_path, monkeypatch):
    folder = tmp_path / "data"
    monkeypatch.setenv("SIGCAT_DATA", str(folder))
    for name in ("http_proxy", "https_proxy", "HTTP_PROXY", "HTTPS_PROXY", "all_proxy", "ALL_PROXY"):
        monkeypatch.delenv(name, raising=False)
    return folder
