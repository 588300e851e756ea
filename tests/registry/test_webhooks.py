"""Webhooks that are really sent: to receivers that fail, hang, redirect and answer too much."""

import datetime as dt
import json
import multiprocessing
import os
import random
import signal
import socket
import ssl
import time
from collections import Counter
from ipaddress import ip_address, ip_network
from pathlib import Path

import pytest
from standardwebhooks import Webhook

from sigcat.cli import main
from sigcat.errors import InputRefused
from sigcat.limits import WEBHOOK_ATTEMPTS
from sigcat.registry.publish import publish
from sigcat.registry.storing.database import reading, writing
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.transfer import exported
from sigcat.registry.storing.verify import verify
from sigcat.registry.webhooks import deliver
from sigcat.registry.webhooks.addresses import Policy, is_allowed
from sigcat.registry.webhooks.deliver import deliver_due
from sigcat.registry.webhooks.deliveries import LEASE, Delivery, deliveries, pause, redeliver
from sigcat.registry.webhooks.sending import send
from sigcat.registry.webhooks.subscriptions import Subscription, subscribe, subscriptions, unsubscribe
from tests.registry.parts import plain_candidate
from tests.registry.receiver import Receiver, receiving

LOCAL = Policy(("127.0.0.1", "hooks.example"), (ip_network("127.0.0.0/8"),))
_FORK = multiprocessing.get_context("fork")


@pytest.fixture
def registry(tmp_path: Path) -> Registry:
    registry = Registry(tmp_path / "registry.db")
    publish(registry, [plain_candidate("first", "1.0.0")])
    return registry


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[dt.timedelta]:
    """Time that is added to that of the machine."""
    passed = [dt.timedelta()]
    monkeypatch.setattr(deliver, "_now", lambda: dt.datetime.now(dt.UTC) + sum(passed, dt.timedelta()))
    return passed


def subscribed(registry: Registry, receiver: Receiver, *types: str) -> Subscription:
    """A subscription, and an event that it gets."""
    made = subscribe(registry, receiver.url, types, LOCAL)
    publish(registry, [plain_candidate("second", "1.0.0")])
    return made


def delivered(registry: Registry) -> list[Delivery]:
    return list(deliver_due(registry, LOCAL))


def states(registry: Registry) -> list[tuple[str, int]]:
    with reading(registry.database) as connection:
        assert verify(connection).findings == ()
        return [(each.state, each.attempts) for each in deliveries(connection)]


def test_a_webhook_is_signed_as_standard_webhooks_ask(registry: Registry) -> None:
    with receiving() as receiver:
        made = subscribed(registry, receiver)
        (sent,) = delivered(registry)
        assert delivered(registry) == []
    (request,) = receiver.requests
    event = Webhook(made.secret).verify(request.body.decode(), dict(request.headers))
    assert (event["type"], event["subject"], event["specversion"]) == (
        "io.sigcat.registry.published", "second@1.0.0", "1.0",
    )  # fmt: skip
    assert (request.path, request.headers["Content-Type"]) == ("/hook?a=b", "application/cloudevents+json")
    assert (sent.id, sent.state, sent.answer) == (request.headers["webhook-id"], "delivered", "HTTP 204")
    assert states(registry) == [("delivered", 1)]


def test_a_subscription_gets_its_types_from_then_on(registry: Registry) -> None:
    with receiving() as receiver:
        made = subscribed(registry, receiver, "drafted", "io.sigcat.registry.retired")
        publish(registry, [plain_candidate("third", "1.0.0")], is_draft=True)
        assert [each.event["subject"] for each in delivered(registry)] == ["third@1.0.0"]
        unsubscribe(registry, made.id)
        publish(registry, [plain_candidate("fourth", "1.0.0")], is_draft=True)
        assert delivered(registry) == []
    assert states(registry) == []


def test_a_failure_is_tried_again_with_the_same_id_after_a_pause(registry: Registry, clock: list[dt.timedelta]) -> None:
    with receiving(lambda number: 204 if number > 2 else 500) as receiver:
        subscribed(registry, receiver)
        (first,) = delivered(registry)
        assert (first.state, first.answer) == ("waiting", "HTTP 500")
        assert delivered(registry) == []
        for attempt in (1, 2):
            clock.append(pause(first.id, attempt))
            assert len(delivered(registry)) == 1
    assert receiver.ids == [first.id] * 3
    assert states(registry) == [("delivered", 3)]


def test_a_receiver_that_fails_is_left_alone_with_its_other_events_and_others_are_served(registry: Registry) -> None:
    with receiving(lambda _: 500) as broken, receiving() as sound:
        for receiver in (broken, sound):
            subscribe(registry, receiver.url, (), LOCAL)
        publish(registry, [plain_candidate("second", f"1.{n}.0") for n in range(5)])
        delivered(registry)
    assert (len(broken.requests), len(sound.requests)) == (1, 5)


def test_attempts_end_and_a_failed_delivery_is_sent_again_on_request(
    registry: Registry, clock: list[dt.timedelta]
) -> None:
    with receiving(lambda number: 204 if number > WEBHOOK_ATTEMPTS else 503) as receiver:
        subscribed(registry, receiver)
        for _ in range(WEBHOOK_ATTEMPTS + 3):
            delivered(registry)
            clock.append(dt.timedelta(hours=8))
        assert states(registry) == [("failed", WEBHOOK_ATTEMPTS)]
        with writing(registry.database) as connection:
            redeliver(connection, receiver.ids[0], deliver._now())
        delivered(registry)
    assert len(set(receiver.ids)) == 1
    assert states(registry) == [("delivered", 1)]


def test_a_receiver_that_is_gone_gets_no_more_attempts(registry: Registry) -> None:
    with receiving(lambda _: 410) as receiver:
        subscribed(registry, receiver)
        delivered(registry)
    assert states(registry) == [("failed", 1)]


def test_pauses_grow_to_a_limit_and_differ_between_deliveries() -> None:
    pauses = [pause("msg_1", attempt).total_seconds() for attempt in range(1, WEBHOOK_ATTEMPTS + 1)]
    assert pauses[:7] == sorted(pauses[:7])
    assert 3 < pauses[0] < 7
    assert max(pauses) <= 1.25 * 6 * 3600
    assert sum(pauses) > 24 * 3600
    assert pause("msg_1", 3) == pause("msg_1", 3) != pause("msg_2", 3)


@pytest.mark.parametrize(
    ("behaviour", "answer"),
    [
        ("hang", "no answer within 0.5 s"),
        ("drip", "no answer within 0.5 s"),
        ("headers", "no answer: got more than"),
        ("noise", "no answer: "),
        (307, "HTTP 307, a redirect, which is not followed"),
        ("big", "HTTP 200"),
    ],
)
def test_answers_are_bounded_in_time_and_size(monkeypatch, behaviour: int | str, answer: str) -> None:
    monkeypatch.setattr("sigcat.registry.webhooks.sending.WEBHOOK_SECONDS", 0.5)
    with receiving(lambda _: behaviour) as receiver:
        start = time.monotonic()
        found = send(receiver.url, b"{}", {}, LOCAL)
        assert time.monotonic() - start < 15, "the receiver hangs for 20 s"
    assert found.text.startswith(answer)
    assert found.is_delivered is (behaviour == "big")
    assert [each.path for each in receiver.requests] == ["/hook?a=b"]


def test_a_closed_port_and_an_unknown_host_are_failures() -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        url = f"http://127.0.0.1:{free.getsockname()[1]}/"
    assert send(url, b"", {}, LOCAL).text.startswith("no answer: ")
    nowhere = Policy(("nowhere.invalid",))
    assert send("https://nowhere.invalid/", b"", {}, nowhere).text.startswith("no answer: ")


PRIVATE = ("127.0.0.1", "127.8.8.8", "10.0.0.1", "172.16.3.4", "192.168.1.1", "169.254.169.254", "100.64.0.1", "0.0.0.0",
           "224.0.0.1", "240.0.0.1", "255.255.255.255", "::1", "::", "fe80::1", "fe80::1%eth0", "fd00::1", "ff02::1",
           "::ffff:127.0.0.1", "::ffff:8.8.8.8", "64:ff9b::7f00:1", "2002:7f00:1::", "2001:0:7f00:1::", "::127.0.0.1")  # fmt: skip


@pytest.mark.parametrize("address", PRIVATE)
def test_private_addresses_are_refused_unless_they_are_allowed(address: str) -> None:
    assert not is_allowed(address, ())
    plain = ip_address(address.partition("%")[0])
    assert is_allowed(address, (ip_network(plain),))
    assert is_allowed(address, (ip_network(plain),), "http")


@pytest.mark.parametrize("address", ["8.8.8.8", "1.1.1.1", "2606:4700::1111"])
def test_public_addresses_are_reached_with_encryption_only(address: str) -> None:
    assert is_allowed(address, ())
    assert not is_allowed(address, (), "http")


def test_the_address_that_was_checked_is_the_one_that_is_connected_to(monkeypatch: pytest.MonkeyPatch) -> None:
    """A name service that answers a private address at the second question changes nothing."""
    answers = [["8.8.8.8"], ["127.0.0.1"]]
    connected: list[tuple[str, int]] = []

    def resolve(host: str, port: int, **_: object) -> list[tuple[object, ...]]:
        assert host == "hooks.example"
        return [(socket.AF_INET, socket.SOCK_STREAM, 6, "", (each, port)) for each in answers.pop(0)]

    def connect(address: tuple[str, int], **_: object) -> socket.socket:
        connected.append(address)
        raise ConnectionRefusedError

    monkeypatch.setattr(socket, "getaddrinfo", resolve)
    monkeypatch.setattr(socket, "create_connection", connect)
    send("https://hooks.example/", b"", {}, Policy(("hooks.example",)))
    assert connected == [("8.8.8.8", 443)]
    answer = send("https://hooks.example/", b"", {}, Policy(("hooks.example",)))
    assert (
        answer.text
        == "not sent: hooks.example is 127.0.0.1, which is in no public network, and not in `webhook-networks`"
    )
    assert connected == [("8.8.8.8", 443)]


def test_a_host_that_is_no_longer_allowed_gets_nothing(registry: Registry) -> None:
    with receiving() as receiver:
        subscribed(registry, receiver)
        (found,) = deliver_due(registry, Policy(networks=LOCAL.networks))
    assert found.answer == "not sent: its host 127.0.0.1 is not in `webhook-hosts` of [registry]"
    assert receiver.requests == []


@pytest.mark.parametrize(
    "url",
    ["", "hooks.example", "ftp://hooks.example/", "https://", "https://other.example/", "https://u:p@hooks.example/",
     "https://hooks.example/#a", "https://hooks.example:x/", "https://hooks.example:0/", "https://hooks.example/a b",
     "https://hooks.example/\r\nX: y", "https://hooks.example.other.example/", "https://[::1/", "https://hoöks.example/",
     "https://hooks.example/" + "a" * 3000],
)  # fmt: skip
def test_an_address_that_does_not_fit_is_a_finding(registry: Registry, url: str) -> None:
    with pytest.raises(InputRefused) as refused:
        subscribe(registry, url, (), LOCAL)
    assert [each.rule for each in refused.value.findings] == ["E016"]
    with pytest.raises(InputRefused) as refused:
        subscribe(registry, "https://HOOKS.example/", ("publishd",), LOCAL)
    assert "published" in refused.value.findings[0].fix


def test_processes_at_the_same_time_send_each_event_once(registry: Registry) -> None:
    with receiving() as receiver:
        subscribe(registry, receiver.url, (), LOCAL)
        publish(registry, [plain_candidate("second", f"1.{n}.0") for n in range(30)])
        with _FORK.Pool(4) as pool:
            counts = pool.map(_deliver_all, [registry] * 4)
    assert sum(counts) == 30
    assert Counter(receiver.ids).most_common(1)[0][1] == 1
    assert len(receiver.ids) == 30


def _deliver_all(registry: Registry) -> int:
    return len(delivered(registry))


def test_a_delivery_of_a_killed_process_is_sent_by_another_one_with_the_same_id(
    registry: Registry, clock: list[dt.timedelta]
) -> None:
    with receiving(lambda number: "hang" if number == 1 else 204) as receiver:
        subscribed(registry, receiver)
        process = _FORK.Process(target=_deliver_all, args=(registry,))
        process.start()
        while not receiver.requests:
            time.sleep(0.01)
        assert process.pid is not None
        os.kill(process.pid, signal.SIGKILL)
        process.join()
        assert delivered(registry) == []  # as long as the killed process may still send it
        clock.append(LEASE)
        assert [each.state for each in delivered(registry)] == ["delivered"]
    assert len(receiver.ids) == 2
    assert len(set(receiver.ids)) == 1


def test_processes_that_are_killed_send_an_event_once_more_at_most_for_each_kill(
    registry: Registry, monkeypatch
) -> None:
    monkeypatch.setattr("sigcat.registry.webhooks.deliveries.LEASE", dt.timedelta(seconds=1))
    chance, kills = random.Random(0), 6
    with receiving() as receiver:
        subscribe(registry, receiver.url, (), LOCAL)
        publish(registry, [plain_candidate("second", f"1.{n}.0") for n in range(60)])
        for _ in range(kills):
            process = _FORK.Process(target=_deliver_all, args=(registry,))
            process.start()
            time.sleep(chance.uniform(0.02, 0.2))
            process.kill()
            process.join()
        deadline = time.monotonic() + 60
        while set(states(registry)) != {("delivered", 1)} and time.monotonic() < deadline:
            delivered(registry)
            time.sleep(0.1)
    assert len(set(receiver.ids)) == 60
    assert 60 <= len(receiver.ids) <= 60 + kills


def test_secrets_are_in_no_export(registry: Registry) -> None:
    with receiving() as receiver:
        made = subscribed(registry, receiver)
    with reading(registry.database) as connection:
        assert subscriptions(connection) == (made,)
        lines = "".join(exported(connection))
    assert made.secret.removeprefix("whsec_") not in lines
    assert made.url not in lines


def certificate(folder: Path, name: str) -> tuple[Path, Path]:
    """A certificate of a name that signs itself, and its key."""
    from cryptography import x509
    from cryptography.hazmat.primitives import hashes, serialization
    from cryptography.hazmat.primitives.asymmetric import ec

    key = ec.generate_private_key(ec.SECP256R1())
    subject = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, name)])
    begin = dt.datetime.now(dt.UTC) - dt.timedelta(days=1)
    made = (
        x509.CertificateBuilder()
        .subject_name(subject)
        .issuer_name(subject)
        .public_key(key.public_key())
        .serial_number(1)
        .not_valid_before(begin)
        .not_valid_after(begin + dt.timedelta(days=3))
        .add_extension(x509.SubjectAlternativeName([x509.DNSName(name)]), critical=False)
        .sign(key, hashes.SHA256())
    )
    files = folder / "certificate.pem", folder / "key.pem"
    files[0].write_bytes(made.public_bytes(serialization.Encoding.PEM))
    form = serialization.PrivateFormat.PKCS8
    files[1].write_bytes(key.private_bytes(serialization.Encoding.PEM, form, serialization.NoEncryption()))
    return files


@pytest.mark.parametrize(("name", "text"), [("hooks.example", "HTTP 204"), ("other.example", "TLS: ")])
def test_the_certificate_must_be_that_of_the_host(tmp_path: Path, monkeypatch, name: str, text: str) -> None:
    public, private = certificate(tmp_path, name)
    monkeypatch.setenv("SSL_CERT_FILE", str(public))

    def resolve(_host: str, port: int, **_: object) -> list[tuple[object, ...]]:
        return [(socket.AF_INET, socket.SOCK_STREAM, 6, "", ("127.0.0.1", port))]

    with receiving() as receiver:
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        context.load_cert_chain(public, private)
        receiver.socket = context.wrap_socket(receiver.socket, server_side=True)
        real = socket.getaddrinfo
        monkeypatch.setattr(
            socket, "getaddrinfo",
            lambda host, port, *a, **k: resolve(host, port) if host == "hooks.example" else real(host, port, *a, **k),
        )  # fmt: skip
        answer = send(f"https://hooks.example:{receiver.server_port}/hook", b"{}", {}, LOCAL)
    assert answer.text.startswith(text)
    assert answer.is_delivered is (name == "hooks.example")
    if answer.is_delivered:
        assert receiver.requests[0].headers["Host"] == f"hooks.example:{receiver.server_port}"


def test_the_commands(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)

    def run(*arguments: str) -> tuple[int, str, str]:
        status = main(["registry", *arguments])
        return status, *capsys.readouterr()

    project = '[registry]\ndatabase = "registry.db"\n'
    Path("sigcat.toml").write_text(project, encoding="utf-8")
    publish(Registry(Path("registry.db")), [plain_candidate("o", "1.0.0")])
    with receiving() as receiver:
        status, _, text = run("subscribe", receiver.url)
        assert (status, "error E016" in text, "webhook-networks = [" in text) == (1, True, True)
        allowed = 'webhook-hosts = ["127.0.0.1"]\nwebhook-networks = ["127.0.0.0/8"]\n'
        Path("sigcat.toml").write_text(project + allowed, encoding="utf-8")
        status, text, _ = run("subscribe", receiver.url, "--types", "published,pending")
        subscription, secret = text.split(": secret ")
        assert run("subscriptions")[1] == f"{subscription}: {receiver.url}, published, pending\n"
        publish(Registry(Path("registry.db")), [plain_candidate("o", "1.1.0")])
        status, text, _ = run("deliver", "--once")
        delivery = text.split()[0]
        assert text == f"{delivery} to {subscription}: published o@1.1.0, delivered after 1 attempt, HTTP 204\n"
        assert run("deliveries", "--state", "delivered")[1] == text
        assert run("deliveries", "--state", "failed")[1] == "No deliveries.\n"
        assert run("redeliver", delivery) == (0, f"{delivery}: waiting\n", "")
        assert run("redeliver", "msg_0")[0] == 1
        assert run("deliver", "--once")[1] == text
        assert run("unsubscribe", subscription)[0] == 0
        assert run("unsubscribe", subscription)[0] == 1
    first, second = receiver.requests
    assert Webhook(secret.strip()).verify(first.body.decode(), dict(first.headers))
    assert (first.headers["webhook-id"], first.body) == (second.headers["webhook-id"], second.body)
    assert json.loads(first.body)["subject"] == "o@1.1.0"


@pytest.mark.parametrize(
    "text",
    ["webhook-hosts = 1", "webhook-hosts = [1]", 'webhook-networks = ["10.0.0.1/8"]', 'webhook-networks = ["a"]'],
)
def test_settings_that_do_not_fit_are_findings(tmp_path: Path, monkeypatch, capsys, text: str) -> None:
    monkeypatch.chdir(tmp_path)
    Path("sigcat.toml").write_text(f'[registry]\ndatabase = "registry.db"\n{text}\n', encoding="utf-8")
    assert main(["registry", "subscriptions"]) == 2
    printed = capsys.readouterr()
    assert "sigcat.toml:3" in printed.err + printed.out
