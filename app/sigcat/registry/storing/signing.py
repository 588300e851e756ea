"""Ed25519 signatures of the log."""

from functools import lru_cache
from pathlib import Path

from cryptography.exceptions import InvalidSignature, UnsupportedAlgorithm
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey, Ed25519PublicKey
from cryptography.hazmat.primitives.serialization import (
    Encoding,
    NoEncryption,
    PrivateFormat,
    PublicFormat,
    load_pem_private_key,
    load_pem_public_key,
)

from sigcat.errors import UsageError, existing_file


def new_key() -> tuple[bytes, bytes]:
    """A new private key and its public key, as PEM."""
    key = Ed25519PrivateKey.generate()
    private = key.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, NoEncryption())
    return private, public_text(key.public_key())


def public_text(key: Ed25519PublicKey) -> bytes:
    """A public key as PEM."""
    return key.public_bytes(Encoding.PEM, PublicFormat.SubjectPublicKeyInfo)


def signature_of(text: str, key: Path | None) -> str:
    """The signature in hexadecimal; empty without a key. Raises UsageError."""
    return "" if key is None else _private(existing_file(key).read_bytes(), str(key)).sign(text.encode()).hex()


def public_key(file: Path) -> Ed25519PublicKey:
    """The public key of a file, which may also hold the private one. Raises UsageError."""
    data = existing_file(file).read_bytes()
    if b"PRIVATE KEY" in data:
        return _private(data, str(file)).public_key()
    try:
        key = load_pem_public_key(data)
    except (ValueError, UnsupportedAlgorithm):
        key = None
    if not isinstance(key, Ed25519PublicKey):
        raise UsageError(_unfit(str(file)))
    return key


def is_signed(text: str, signature: str, key: Ed25519PublicKey) -> bool:
    """Whether the signature is that of the key."""
    try:
        key.verify(bytes.fromhex(signature), text.encode())
    except (InvalidSignature, ValueError):
        return False
    return True


@lru_cache(maxsize=4)
def _private(data: bytes, name: str) -> Ed25519PrivateKey:
    try:
        key = load_pem_private_key(data, None)
    except (ValueError, TypeError, UnsupportedAlgorithm):
        key = None
    if not isinstance(key, Ed25519PrivateKey):
        raise UsageError(_unfit(name))
    return key


def _unfit(name: str) -> str:
    return f"{name} must be an Ed25519 key as PEM without a password: `sigcat registry new-key FILE` makes one"
