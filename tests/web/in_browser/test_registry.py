"""People sign in to the registry, publish and decide, with and without JavaScript."""

from pathlib import Path

import pytest
from axe_playwright_python.sync_playwright import Axe  # type: ignore[import-untyped]
from playwright.sync_api import Page, expect

from tests.reference_tools import checked_with
from tests.registry.served import function_file
from tests.web.in_browser.conftest import Opener

PAGES = ("/registry", "/registry/publish", "/registry/functions/Alpha", "/registry/deliveries")
"""Pages that show more to a person who is signed in."""


def sign_in(page: Page, folder: Path) -> None:
    page.get_by_label("Token").fill((folder / "token").read_text())
    page.get_by_role("button", name="Sign in").click()
    expect(page.get_by_text("Signed in as anna")).to_be_visible()


@pytest.mark.parametrize("has_scripts", [True, False])
def test_a_person_signs_in_publishes_and_signs_out(
    open_page: Opener, served_folder: Path, tmp_path: Path, *, has_scripts: bool
) -> None:
    page = open_page("/registry/publish", java_script_enabled=has_scripts)
    sign_in(page, served_folder)
    name = f"Zeta{has_scripts}"
    file = tmp_path / f"{name}.function.yaml"
    file.write_bytes(function_file(name, "{path: Vehicle.Speed, role: consumed}"))
    page.get_by_label("Functions or overlays").set_input_files(file)
    page.get_by_role("button", name="Publish").click()
    expect(page.get_by_role("region", name="Result")).to_contain_text(f"{name} 1.0.0: published")
    page.get_by_role("region", name="Result").get_by_role("link", name=name).click()
    page.get_by_label("Support ends on").fill("2040-12-31")
    page.get_by_role("button", name="Deprecate").click()
    expect(page.get_by_role("region", name="Versions")).to_contain_text("deprecated until 2040-12-31")
    page.get_by_role("button", name="Sign out").click()
    expect(page.get_by_role("link", name="Sign in")).to_be_visible()


def test_an_owner_rejects_a_pending_version(open_page: Opener, served_folder: Path) -> None:
    page = open_page("/registry/login")
    sign_in(page, served_folder)
    form = page.get_by_role("form", name="Decision about Beta 1.1.0")
    form.get_by_label("Reason to reject it").fill("Not before May.")
    form.get_by_role("button", name="Reject").click()
    expect(page.get_by_role("region", name="Pending versions")).to_contain_text(
        "Team Gamma rejected it: Not before May."
    )


@checked_with("axe", "No page has a violation, on a laptop and a phone, in light and in dark")
def test_pages_for_people_who_are_signed_in_are_accessible_and_fit(open_page: Opener, served_folder: Path) -> None:
    page = open_page("/registry/login")
    sign_in(page, served_folder)
    for address in PAGES:
        page.goto(page.url.partition("/registry")[0] + address)
        for width in (320, 390, 768, 1440):
            page.set_viewport_size({"width": width, "height": 800})
            assert page.evaluate("document.documentElement.scrollWidth") <= width, (address, width)
        result = Axe().run(page)
        assert not result.response["violations"], result.generate_report()


def test_a_page_of_another_site_cannot_send_a_form(open_page: Opener, served_folder: Path) -> None:
    page = open_page("/registry/login")
    sign_in(page, served_folder)
    own = page.url.partition("/registry")[0]
    form = page.locator("input[name=form]").first.get_attribute("value")
    other = page.context.new_page()
    other.route("http://evil.example/", lambda route: route.fulfill(content_type="text/html", body=(
        f'<form method="post" action="{own}/registry/end"><input name="form" value="{form}"><input name="group" '
        'value="functions"><input name="reference" value="Alpha@2.0.0"><button name="action" value="retire">Win</button></form>'
    )))  # fmt: skip
    other.goto("http://evil.example/")
    with other.expect_response("**/registry/end") as answer:
        other.get_by_role("button", name="Win").click()
    assert answer.value.status == 403
    other.close()
    assert ">retired<" not in page.request.get(f"{own}/registry/functions/Alpha").text()
