"""No page has a violation that axe finds, in light and in dark, and none complains on the console."""

import pytest
from axe_playwright_python.sync_playwright import Axe  # type: ignore[import-untyped]
from playwright.sync_api import Page

from tests.web.conftest import Opener

PAGES = (
    "/tree/interfaces/Vehicle.Function.WheelSpeedCalculation.Scheduling.Step", "/tree/interfaces~folded",
    "/tree/small/Vehicle.Speed", "/tree/lost", "/tree/small/Vehicle.Sped", "/search/small?q=speed", "/search/small?q=sped",
    "/functions", "/functions/core_acc", "/functions/core_acc?view=source", "/functions/core_acc?view=ros2",
    "/functions/core_acc?catalogue=small", "/wiring", "/changes", "/changes?old=bare&new=small",
    "/try", "/try?kind=function", "/rules", "/rules/I201", "/units/interfaces", "/catalogues/interfaces",
    "/catalogues/broken", "/docs", "/problems/not-found",
)  # fmt: skip


@pytest.mark.parametrize("address", PAGES)
def test_axe_finds_nothing(open_page: Opener, address: str) -> None:
    page = open_page(address)
    found = _violations(page)
    page.emulate_media(color_scheme="dark")
    found += _violations(page, {"runOnly": ["color-contrast"], "resultTypes": ["violations"]})
    assert not found


def _violations(page: Page, options: dict[str, object] | None = None) -> list[str]:
    violations = Axe().run(page, options=options or {"resultTypes": ["violations"]}).response["violations"]
    return [f"{v['id']}: {n['html'][:200]} {n['failureSummary']}" for v in violations for n in v["nodes"]]
