"""Secrets and signatures of Standard Webhooks."""

import base64
import hmac
import secrets
from collections.abc import Mapping

_PREFIX = "whsec_"


def new_secret() -> str:
    """A new secret, as Standard Webhooks write it."""
    return f"{_PREFIX}{base64.b64encode(secrets.token_bytes(32)).decode('ascii')}"


def signed_headers(secret: str, delivery: str, seconds: int, body: bytes) -> Mapping[str, str]:
    """The headers of a delivery that is sent at a time: its id, the time, and the signature of both with the body."""
    key = base64.b64decode(secret.removeprefix(_PREFIX))
    mac = hmac.digest(key, f"{delivery}.{seconds}.".encode() + body, "sha256")
    return {
        "webhook-id": delivery,
        "webhook-timestamp": str(seconds),
        "webhook-signature": f"v1,{base64.b64encode(mac).decode('ascii')}",
    }
