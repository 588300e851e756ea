"""Whatever is not a lookup by key runs outside the event loop: no request, however much it asks for, keeps others waiting.

Each route has here its most expensive legal requests. A new route fails until it has some.
"""

import subprocess
import sys
from collections.abc import Iterator, Mapping
from functools import partial
from types import MappingProxyType
from typing import NamedTuple

import httpx
import pytest

from sigcat.api.settings import DEFAULT_SETTINGS
from sigcat.api.tokens import new_token
from sigcat.catalogue.exporting.exporters import EXPORTERS
from sigcat.data import EXAMPLES
from sigcat.digest import digest_of
from sigcat.limits import SEARCH_WORDS
from sigcat.platforms.table import PLATFORMS
from tests.api.loop_lag import ADDRESS
from tests.api.served_routes import served_routes
from tests.clients.generating import ROOT
from tests.waiting import DEADLINE

MOST = 0.05
"""Seconds of the processor for which the loop may stand still."""
TRIES = 3
"""A process looks for garbage now and then; a request that blocks the loop does so each time."""
SECRET, TOKEN = new_token("operator", ["read", "reload"])
WIDE = "/api/v1/catalogues/wide"
SMALL = "/api/v1/catalogues/small"
REGISTRY = "/api/v1/registry"
WORDS = "+".join(chr(ord("a") + number % 26) for number in range(SEARCH_WORDS))
METADATA = "%7B%22type%22%3A%22static-metadata%22%2C%22parameter%22%3A%22%22%7D"
MISSPELLED = "Vehicle.Part.Row1.Place1.Spee" + "d" * 400
FORM = {"Content-Type": "application/x-www-form-urlencoded"}
MULTIPART = {"Content-Type": "multipart/form-data; boundary=x"}
COOKIE = {"Cookie": f"sigcat_session={SECRET}"}
FORM_VALUE = digest_of(f"form {SECRET}".encode())
"""Those of a session whose secret is the token, as `loop_lag` stores it."""
YAML, CSV = {"Accept": "application/yaml"}, {"Accept": "text/csv"}
BODY = DEFAULT_SETTINGS.body_bytes
FORMS = (
    (FORM, b"text=" + b"%" * (BODY - 5)),
    (FORM, b"text=" + b"%41" * (BODY // 3 - 2)),
    (MULTIPART, b'--x\r\nContent-Disposition: form-data; name="text"\r\n\r\n' + b"\r\n--y" * (BODY // 6) + b"\r\n--x--\r\n"),
)  # fmt: skip
LINES = b"a: b\n" * (BODY // 5)
FUNCTION = (EXAMPLES / "core_acc/function.yaml").read_bytes()
SIGNAL = "Vehicle.S{0}: {{type: sensor, datatype: float, description: Signal number {0} of a wide tree.}}\n"
TREE = (
    "Vehicle: {type: branch, description: A vehicle.}\n"
    "Vehicle.Part: {type: branch, instances: ['Row[1,60]', 'Place[1,80]'], description: A part.}\n"
    "Vehicle.Part.Speed: {type: sensor, datatype: float, description: Speed of a part.}\n"
)
"""With the signals below: as many nodes as one answer may have, most of them below one branch."""


class Costly(NamedTuple):
    """A request."""

    address: str
    headers: Mapping[str, str] = MappingProxyType({})
    body: bytes = b""


def post(address: str, *bodies: bytes) -> list[Costly]:
    return [Costly(address, {}, body) for body in bodies]


def get(*addresses: str) -> list[Costly]:
    return [Costly(address) for address in addresses]


def forms(address: str) -> list[Costly]:
    return [Costly(address, headers, body) for headers, body in FORMS]


def signed(address: str, fields: str) -> Costly:
    """A form of the person who is signed in."""
    return Costly(address, {**FORM, **COOKIE}, f"form={FORM_VALUE}&{fields}".encode())


def posted_file(data: bytes) -> Costly:
    """A file that this person publishes over the wide tree."""
    fields = "".join(
        f'--x\r\nContent-Disposition: form-data; name="{name}"\r\n\r\n{value}\r\n'
        for name, value in (("form", FORM_VALUE), ("catalogue", "wide"), ("version", "1.0.0"))
    )
    file = b'--x\r\nContent-Disposition: form-data; name="file"; filename="a.yaml"\r\n\r\n'
    body = fields.encode() + file + data[: BODY - 1000] + b"\r\n--x--\r\n"
    return Costly("/registry/publish", {**MULTIPART, **COOKIE}, body)


_DOCUMENT = b"[" * 60 + b"0," * (BODY // 2 - 100)
COSTLY: dict[str, list[Costly]] = {
    "GET /": get("/"),
    "GET /api/v1/catalogues": [*get("/api/v1/catalogues"), Costly("/api/v1/catalogues", YAML)],
    "GET /api/v1/catalogues/{catalogue}": [*get(WIDE, f"{WIDE}~folded"), Costly(WIDE, YAML)],
    "GET /api/v1/catalogues/{catalogue}/diff": get(f"{WIDE}/diff?to=interfaces"),
    "GET /api/v1/catalogues/{catalogue}/export/{format}": get(f"{WIDE}/export/{'x' * 200}"),
    "GET /api/v1/catalogues/{catalogue}/nodes": [
        *get(f"{WIDE}/nodes?q=vehicle&limit=200", f"{WIDE}/nodes?q={WORDS}"),
        Costly(f"{WIDE}/nodes", CSV),
        Costly(f"{WIDE}/nodes?q=vehicle&limit=200", YAML),
    ],
    "GET /api/v1/catalogues/{catalogue}/nodes/{path}": [
        *get(f"{WIDE}/nodes/Vehicle", f"{WIDE}/nodes/{MISSPELLED}", f"{WIDE}/nodes/Vehicle.S7000"),
        Costly(f"{WIDE}/nodes/Vehicle", YAML),
    ],
    "GET /api/v1/catalogues/{catalogue}/nodes/{path}/history": get(
        f"{WIDE}/nodes/Vehicle.S7000/history", f"{WIDE}/nodes/{MISSPELLED}/history", f"{SMALL}/nodes/Vehicle.Speed/history"
    ),
    "GET /api/v1/catalogues/{catalogue}/quantities": [Costly("/api/v1/catalogues/interfaces/quantities", YAML)],
    "GET /api/v1/catalogues/{catalogue}/search": [
        *get(f"{WIDE}/search?q={WORDS}", f"{WIDE}/search?q=vehicl3+sped+desc", f"{WIDE}/search?limit=200&instances=true"),
        *get(f"{WIDE}/search?q=sig+num+des+tree", f"{WIDE}/search?q=signal+number+speed+place"),
        Costly(f"{WIDE}/search?q=s&limit=200", YAML),
    ],
    "GET /api/v1/catalogues/{catalogue}/tree": [
        *get(f"{WIDE}/tree?depth=64", f"{WIDE}~folded/tree?depth=64", f"{WIDE}/tree?path={MISSPELLED}"),
        Costly(f"{WIDE}/tree?depth=64", YAML),
        Costly(f"{WIDE}/tree?depth=64", {"Accept-Encoding": "identity"}),
    ],
    "GET /api/v1/catalogues/{catalogue}/units": [Costly("/api/v1/catalogues/interfaces/units", YAML)],
    "GET /api/v1/catalogues/{catalogue}/viss/{path:path}": get(f"{WIDE}/viss/Vehicle?filter={METADATA}"),
    "GET /api/v1/registry": get(REGISTRY),
    "GET /api/v1/registry/capabilities": get(f"{REGISTRY}/capabilities"),
    "GET /api/v1/registry/contents": get(f"{REGISTRY}/contents?digest={'0' * 64}"),
    "GET /api/v1/registry/deprecations": [*get(f"{REGISTRY}/deprecations"), Costly(f"{REGISTRY}/deprecations", YAML)],
    "GET /api/v1/registry/events": get(f"{REGISTRY}/events?limit=200", f"{REGISTRY}/events?after=2147483647&wait=1"),
    "GET /api/v1/registry/key": get(f"{REGISTRY}/key"),
    "GET /api/v1/registry/lines": [*get(f"{REGISTRY}/lines", f"{REGISTRY}/lines?line={'x' * 300}"), Costly(f"{REGISTRY}/lines", YAML)],
    "GET /api/v1/registry/log": [*get(f"{REGISTRY}/log?limit=200"), Costly(f"{REGISTRY}/log?limit=200", YAML)],
    "GET /api/v1/registry/model": get(f"{REGISTRY}/model"),
    "GET /api/v1/registry/pending": [*get(f"{REGISTRY}/pending"), Costly(f"{REGISTRY}/pending", YAML)],
    "GET /api/v1/registry/users": get(f"{REGISTRY}/users?path=Vehicle", f"{REGISTRY}/users?path={MISSPELLED}"),
    "GET /api/v1/registry/{group}": [*get(f"{REGISTRY}/functions?limit=200"), Costly(f"{REGISTRY}/functions", YAML)],
    "GET /api/v1/registry/{group}/{name}": get(f"{REGISTRY}/functions/CoreAcc", f"{REGISTRY}/functions/{'x' * 300}"),
    "GET /api/v1/registry/{group}/{name}$details": get(f"{REGISTRY}/functions/CoreAcc$details"),
    "GET /api/v1/registry/{group}/{name}/versions": get(f"{REGISTRY}/functions/CoreAcc/versions"),
    "GET /api/v1/registry/{group}/{name}/versions/{version}": get(f"{REGISTRY}/functions/CoreAcc/versions/1.0.0"),
    "GET /api/v1/registry/{group}/{name}/versions/{version}$details": get(
        f"{REGISTRY}/functions/CoreAcc/versions/1.0.0$details?inline=uses"
    ),
    "GET /api/v1/rules": [*get("/api/v1/rules"), Costly("/api/v1/rules", YAML), Costly("/api/v1/rules", CSV)],
    "GET /api/v1/rules/{rule_id}": get("/api/v1/rules/V102", f"/api/v1/rules/{'V' * 300}"),
    "GET /api/v1/schemas": get("/api/v1/schemas"),
    "GET /api/v1/schemas/{name}.json": get("/api/v1/schemas/function.json", f"/api/v1/schemas/{'f' * 300}.json"),
    "GET /basket/{catalogue}": get("/basket/wide?pick=Vehicle", f"/basket/wide?pick={','.join(f'Vehicle.Sn{n}' for n in range(400))}"),
    "GET /basket/{catalogue}/{file}": get(
        "/basket/wide/signals.csv?pick=Vehicle", "/basket/wide/overlay.vspec?pick=Vehicle", "/basket/interfaces/function.yaml?pick=Vehicle", "/basket/wide/x"
    ),
    "GET /catalogues/{catalogue}": get("/catalogues/wide"),
    "GET /changes": get("/changes?old=interfaces&new=wide"),
    "GET /compare": get(
        f"/compare?catalogue=wide&path=Vehicle&with={MISSPELLED}", "/compare?catalogue=wide&path=Vehicle&other=interfaces"
    ),
    "GET /docs": get("/docs"),
    "GET /docs/api/{chapter}": get("/docs/api/exports", "/docs/api/schemas"),
    "GET /docs/{chapter:path}": get("/docs/reference/command-line.md", f"/docs/{'x' * 300}"),
    "GET /functions": get("/functions", "/functions?catalogue=wide"),
    "GET /functions.json": get("/functions.json", "/functions.json?catalogue=wide"),
    "GET /functions/sets/{set_id}/compare": get("/functions/sets/ecocontrol/compare"),
    "GET /functions/sets/{set_id}/compare.json": get("/functions/sets/ecocontrol/compare.json"),
    "GET /functions/{function_id}": get(
        "/functions/core_acc?view=ros2", "/functions/core_acc.json", "/functions/eco_control_mpc?view=run", "/functions/x"
    ),
    "GET /functions/{function_id}/files/{document_id}": get("/functions/core_acc/files/source", "/functions/core_acc/files/x"),
    "GET /functions/{function_id}/runs.json": get("/functions/core_acc/runs.json"),
    "GET /functions/{function_id}/runs/{run_id}": get("/functions/core_acc/runs/drive", "/functions/core_acc/runs/x"),
    "GET /functions/{function_id}/runs/{run_id}/values.json": get(
        "/functions/core_acc/runs/drive/values.json", "/functions/core_acc/runs/x/values.json"
    ),
    "GET /health": get("/health"),
    "GET /health/live": get("/health/live"),
    "GET /health/ready": get("/health/ready"),
    "GET /healthz": get("/healthz"),
    "GET /history/{catalogue}/{path}": get(
        "/history/wide/Vehicle.S7000", f"/history/wide/{MISSPELLED}", "/history/interfaces/Vehicle.Speed"
    ),
    "GET /metrics": get("/metrics"),
    "GET /openapi.json": get("/openapi.json"),
    "GET /problems/{kind}": get("/problems/busy", f"/problems/{'x' * 300}"),
    "GET /propose": get("/propose?catalogue=wide&change=Vehicle", "/propose?catalogue=wide&below=Vehicle", f"/propose?catalogue=wide&change={MISSPELLED}"),
    "GET /registry": get("/registry", "/registry?from=99"),
    "GET /registry/deliveries": get("/registry/deliveries", "/registry/deliveries?state=failed"),
    "GET /registry/lines": get("/registry/lines", "/registry/lines?from=99"),
    "GET /registry/login": get(f"/registry/login?next={'x' * 300}"),
    "GET /registry/openid": get("/registry/openid"),
    "GET /registry/openid/return": get("/registry/openid/return?code=x&state=x"),
    "GET /registry/publish": get("/registry/publish"),
    "GET /registry/users": get("/registry/users?path=Vehicle&catalogue=wide", f"/registry/users?path={MISSPELLED}&catalogue=wide"),
    "GET /registry/{group}/{name}": get("/registry/functions/Alpha", f"/registry/functions/{'x' * 300}"),
    "GET /rows/{catalogue}": get("/rows/wide?depth=99", f"/rows/wide?path={MISSPELLED}"),
    "GET /rules": get("/rules", "/rules?catalogue=wide"),
    "GET /rules/{rule_id}": get("/rules/V102?catalogue=wide", f"/rules/{'V' * 300}"),
    "GET /search/{catalogue}": get(f"/search/wide?q={WORDS}", "/search/wide?q=vehicl3+sped", "/search/wide?limit=200"),
    "GET /tree/{catalogue}": get("/tree/wide?open=*", "/tree/wide~folded?open=*"),
    "GET /tree/{catalogue}/{path}": get("/tree/wide/Vehicle?open=*", f"/tree/wide/{MISSPELLED}", "/tree/wide/Vehicle.json"),
    "GET /try": get("/try", "/try?kind=function", "/try?catalogue=wide"),
    "GET /units/{catalogue}": get("/units/interfaces"),
    "GET /vehicles/{catalogue}": get("/vehicles/wide?show=all", "/vehicles/wide?show=all&q=s7"),
    "GET /vehicles/{catalogue}/matrix.csv": get("/vehicles/wide/matrix.csv?show=all"),
    "GET /wiring": get("/wiring", "/wiring?catalogue=wide&view=ros2"),
    "GET /wiring.json": get("/wiring.json"),
    "GET /wiring/files/{document_id}": get("/wiring/files/ros2", f"/wiring/files/{'x' * 300}"),
    "GET /{page_name}.ico": get("/favicon.ico"),
    "POST /api/v1/catalogues/{catalogue}/reload": post(f"{WIDE}/reload", b""),
    "POST /api/v1/catalogues/{catalogue}/trial": post(
        f"{WIDE}/trial", LINES, b"Vehicle.Part: {type: branch, instances: ['A[1,300]', 'B[1,300]'], description: X.}"
    ),
    "POST /api/v1/functions/build": post("/api/v1/functions/build?catalogue=interfaces", FUNCTION, _DOCUMENT),
    "POST /api/v1/functions/reload": post("/api/v1/functions/reload", b""),
    "POST /api/v1/functions/validate": post("/api/v1/functions/validate?catalogue=wide", FUNCTION, _DOCUMENT, LINES),
    "POST /api/v1/generate/core": post("/api/v1/generate/core?catalogue=interfaces", FUNCTION, _DOCUMENT),
    "POST /api/v1/integrate/{platform}": post("/api/v1/integrate/ros2?catalogue=interfaces", FUNCTION, _DOCUMENT),
    "POST /api/v1/integrate/{platform}/archive": post(
        "/api/v1/integrate/autosar-classic/archive?catalogue=interfaces", FUNCTION, _DOCUMENT
    ),
    "POST /api/v1/lint": post("/api/v1/lint?catalogue=wide", LINES, _DOCUMENT, b"Vehicle.*: {max: 1}\n" * 1000),
    **{
        f"POST /api/v1/registry/{action}": post(f"{REGISTRY}/{action}?reference=Alpha@1.1.0&owner=Beta{more}", b"")
        for action, more in (("approve", ""), ("reject", "&reason=No."))
    },
    "POST /api/v1/registry/acknowledge": post(f"{REGISTRY}/acknowledge?reference=Alpha@1.0.0&owner=Beta", b""),
    "POST /api/v1/registry/can-i-deploy": post(f"{REGISTRY}/can-i-deploy?function=CoreAcc@1.0.0&line=SUV-2025", b""),
    "POST /api/v1/registry/check": post(f"{REGISTRY}/check?catalogue=wide", FUNCTION, LINES, _DOCUMENT),
    "POST /api/v1/registry/deprecate": post(f"{REGISTRY}/deprecate?reference=CoreAcc@1.0.0", b""),
    "POST /api/v1/registry/publish": post(f"{REGISTRY}/publish?catalogue=wide&version=1.0.0", FUNCTION, LINES, _DOCUMENT),
    **{
        f"POST /api/v1/registry/{action}": post(f"{REGISTRY}/{action}?function=CoreAcc@1.0.0&line=SUV-2026", b"")
        for action in ("record-deployment", "record-release", "support-ended")
    },
    "POST /api/v1/registry/retire": post(f"{REGISTRY}/retire?reference=Alpha@1.0.0", b""),
    "POST /api/v1/registry/rule": post(f"{REGISTRY}/rule?published=Alpha&compatibility_rule=full", b""),
    "POST /propose": forms("/propose"),
    "POST /registry/acknowledge": [
        *forms("/registry/acknowledge"), signed("/registry/acknowledge", "reference=Alpha@1.0.0&group=functions&owner=Beta"),
    ],
    "POST /registry/decide": [*forms("/registry/decide"), signed("/registry/decide", "reference=Alpha@1.1.0&group=functions&action=approve")],
    "POST /registry/end": [*forms("/registry/end"), signed("/registry/end", "reference=Alpha@1.0.0&group=functions&action=retire")],
    "POST /registry/login": [*forms("/registry/login"), Costly("/registry/login", FORM, f"token={SECRET}".encode())],
    "POST /registry/logout": [*forms("/registry/logout"), signed("/registry/logout", "")],
    "POST /registry/publish": [*forms("/registry/publish"), *map(posted_file, (FUNCTION, LINES, _DOCUMENT))],
    "POST /registry/redeliver": [*forms("/registry/redeliver"), signed("/registry/redeliver", "delivery=msg_0")],
    "POST /try": forms("/try"),
    "POST /wiring": forms("/wiring"),
    **{f"GET /api/v1/catalogues/{{catalogue}}/export/{name}": get(f"{SMALL}/export/{name}") for name in EXPORTERS},
    **{
        f"POST /api/v1/generate/{generator.name}": post(f"/api/v1/generate/{generator.name}", _DOCUMENT)
        for platform in PLATFORMS.values()
        for generator in platform.generators
    },
}  # fmt: skip
COSTLY["GET /api/v1/catalogues/{catalogue}/export/json"] += get(f"{WIDE}/export/json")


def test_every_route_has_its_most_expensive_requests() -> None:
    assert set(served_routes()) == set(COSTLY)


@pytest.fixture(scope="module")
def client(tmp_path_factory: pytest.TempPathFactory) -> Iterator[httpx.Client]:
    folder = tmp_path_factory.mktemp("watched")
    (folder / "tree.vspec").write_text(TREE + "".join(map(SIGNAL.format, range(9_000))))
    command = [sys.executable, "-m", "tests.api.loop_lag", str(folder / "tree.vspec"), str(TOKEN)]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        address = process.stdout.readline().strip()
        with httpx.Client(base_url=address, headers={"Authorization": f"Bearer {SECRET}"}, timeout=DEADLINE) as client:
            client.post(
                "/api/v1/lint?catalogue=wide", content=b"Vehicle: {}"
            )  # answered when workers know all catalogues
            yield client
        process.kill()


def standstill(client: httpx.Client, request: Costly, method: str) -> float:
    """Seconds of the processor for which the loop stood still while a request was answered."""
    client.get(ADDRESS)
    answer = client.request(method, request.address, headers=request.headers, content=request.body)
    assert answer.status_code != httpx.codes.INTERNAL_SERVER_ERROR
    return float(client.get(ADDRESS).text)


@pytest.mark.parametrize("route", COSTLY)
def test_the_loop_goes_on_meanwhile(client: httpx.Client, route: str) -> None:
    for request in COSTLY[route]:
        tries = map(partial(standstill, client, request), [route.partition(" ")[0]] * TRIES)
        assert any(seconds < MOST for seconds in tries), request.address
