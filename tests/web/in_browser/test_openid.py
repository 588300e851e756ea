"""A person signs in by OpenID Connect in a browser, at a provider that asks the person."""

import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.waiting import DEADLINE
from tests.web.in_browser.conftest import ROOT
from tests.web.test_openid import SECRET, Provider

_SERVE = """
import sys
from pathlib import Path
from sigcat.catalogue.hosting.library import Library
from sigcat.api.server import run
from sigcat.api.settings import Settings
from sigcat.web.site import create_site
from tests.api.conftest import SOURCES
from tests.web.published import published
folder, port, issuer = Path(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
settings = Settings(
    port=port, log="none", openid_issuer=issuer, openid_client="sigcat", openid_secret_file=str(folder / "openid.secret"),
    openid_address=f"http://127.0.0.1:{port}", openid_groups="cockpit:publish+approve:Team Gamma,staff:read",
)
run(create_site(Library(SOURCES[:1]), settings, registry=published(folder)), settings)
"""


@pytest.fixture
def provider() -> Iterator[Provider]:
    running = Provider()
    yield running
    running.close()


@pytest.fixture
def address(provider: Provider, tmp_path: Path) -> Iterator[str]:
    """Address of a service whose people sign in at the provider."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    provider.client = f"http://127.0.0.1:{port}"
    (tmp_path / "openid.secret").write_text(SECRET)
    command = [sys.executable, "-c", _SERVE, str(tmp_path), str(port), provider.issuer]
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "app")}
    with subprocess.Popen(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert provider.client in process.stdout.readline()
        yield provider.client
        process.terminate()
        assert process.wait(DEADLINE) in (0, -15)


@pytest.mark.parametrize("has_scripts", [True, False])
def test_a_person_signs_in_at_the_provider_and_decides(browser: Browser, address: str, *, has_scripts: bool) -> None:
    context = browser.new_context(java_script_enabled=has_scripts)
    page = context.new_page()
    page.goto(f"{address}/registry/login")
    page.get_by_role("link", name="Sign in with OpenID Connect").click()
    page.get_by_role("link", name="Agree").click()
    expect(page.get_by_text("Signed in as eva@example.org for Team Gamma")).to_be_visible()
    form = page.get_by_role("form", name="Decision about Beta 1.1.0")
    form.get_by_role("button", name="Approve").click()
    expect(page.get_by_role("region", name="Pending versions")).to_contain_text("Team Gamma approved it until")
    page.get_by_role("button", name="Sign out").click()
    expect(page.get_by_role("link", name="Sign in", exact=True)).to_be_visible()
    context.close()


def test_a_person_in_no_group_is_refused(browser: Browser, provider: Provider, address: str) -> None:
    provider.claims = {"email": "eva@example.org", "groups": ["visitors"]}
    context = browser.new_context()
    page = context.new_page()
    page.goto(f"{address}/registry/login")
    page.get_by_role("link", name="Sign in with OpenID Connect").click()
    page.get_by_role("link", name="Agree").click()
    expect(page.get_by_text("Signed in as")).to_have_count(0)
    page.goto(f"{address}/registry")
    expect(page.get_by_role("link", name="Sign in", exact=True)).to_be_visible()
    context.close()
