"""Sign in by OpenID Connect: the code flow with PKCE, state and nonce. Authlib is loaded with the first sign-in.

The functions ask the provider, and run in a thread.
"""

from collections.abc import Mapping
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple
from urllib.parse import urlsplit

from sigcat.api.read_settings import TABLE as SERVICE
from sigcat.api.settings import Settings
from sigcat.errors import SigcatError, UsageError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from sigcat.registry.storing.tokens import Token

_SECONDS = 5
"""Seconds for which an answer of the provider may take."""
_ALGORITHMS = ("RS256", "RS384", "RS512", "PS256", "PS384", "PS512", "ES256", "ES384", "ES512", "EdDSA", "Ed25519")
"""Those with a public key: the client secret signs nothing."""
_LEEWAY = 60
"""Seconds by which the clock of the provider may differ."""
_NAME_CHARACTERS = 100


class ProviderFailed(SigcatError):
    """The provider cannot be asked, or its answer is unusable."""


class Begun(NamedTuple):
    """Random values of a sign-in that has begun. The browser keeps them until it returns."""

    state: str
    nonce: str
    verifier: str


def check_openid(settings: Settings) -> None:
    """Raises UsageError for settings of OpenID Connect that cannot work: better now than with the first sign-in."""
    if not settings.openid_issuer:
        return
    for name in ("openid_client", "openid_address", "openid_groups"):
        if not getattr(settings, name):
            raise UsageError(f"[{SERVICE}] must have `{name}` next to `openid_issuer`")
    if any(find_spec(package) is None for package in ("authlib", "httpx2", "joserfc")):
        raise UsageError(
            "OpenID Connect needs the extra `registry-openid`: run `pip install 'sigcat[registry-openid]'`"
        )
    try:
        _secret(settings)
    except ProviderFailed as failure:
        raise UsageError(str(failure)) from None


def begin(settings: Settings) -> tuple[Begun, str]:
    """Return the values of a new sign-in, and the address of the provider to send the browser to. Raises ProviderFailed."""
    from authlib.common.security import generate_token

    begun = Begun(*(generate_token(48) for _ in Begun._fields))
    with _client(settings) as client:
        endpoint = _address(_metadata(client, settings), "authorization_endpoint", settings)
        address, _ = client.create_authorization_url(
            endpoint, state=begun.state, code_verifier=begun.verifier, nonce=begun.nonce
        )
    return begun, str(address)


def person_of(settings: Settings, code: str, begun: Begun) -> "Token":
    """The person that the provider vouches for, with the scopes of the groups. Raises ProviderFailed and UsageError."""
    with _client(settings) as client:
        metadata = _metadata(client, settings)
        endpoint = _address(metadata, "token_endpoint", settings)
        token = client.fetch_token(endpoint, grant_type="authorization_code", code=code, code_verifier=begun.verifier)
        keys = _document(client, _address(metadata, "jwks_uri", settings))
        claims = _claims(token, keys, metadata, settings, begun.nonce)
    return _token_of(claims, settings)


@contextmanager
def _client(settings: Settings) -> "Iterator[Any]":
    """A client of the provider. Its errors, and those of its answers, are raised as ProviderFailed."""
    from authlib.common.errors import AuthlibBaseError
    from authlib.integrations.httpx_client import OAuth2Client
    from httpx2 import HTTPError
    from joserfc.errors import JoseError

    secret = _secret(settings)
    try:
        with OAuth2Client(
            settings.openid_client, secret, scope="openid profile email", code_challenge_method="S256", timeout=_SECONDS,
            token_endpoint_auth_method="client_secret_basic" if secret else "none",
            redirect_uri=f"{settings.openid_address}/registry/openid/return",
        ) as client:  # fmt: skip
            yield client
    except (AuthlibBaseError, HTTPError, JoseError, KeyError, TypeError, ValueError) as error:
        reason = str(error).partition("\n")[0][:200]
        raise ProviderFailed(f"The provider of OpenID Connect did not sign you in: {reason}. Sign in again.") from None


def _secret(settings: Settings) -> str | None:
    if not settings.openid_secret_file:
        return None
    try:
        return Path(settings.openid_secret_file).read_text("utf-8").strip()
    except (OSError, UnicodeDecodeError):
        raise ProviderFailed("The file of the setting `openid_secret_file` cannot be read.") from None


def _metadata(client: Any, settings: Settings) -> Mapping[str, Any]:
    address = f"{settings.openid_issuer.rstrip('/')}/.well-known/openid-configuration"
    metadata = _document(client, address)
    if metadata["issuer"] != settings.openid_issuer:
        raise ValueError(f"its issuer must be {settings.openid_issuer}")
    return metadata


def _document(client: Any, address: str) -> Mapping[str, Any]:
    document: Mapping[str, Any] = client.request("GET", address, withhold_token=True).raise_for_status().json()
    return document


def _address(metadata: Mapping[str, Any], name: str, settings: Settings) -> str:
    """An address of the provider, which is as safe as that of the issuer."""
    address = str(metadata[name])
    if urlsplit(address).scheme not in ("https", urlsplit(settings.openid_issuer).scheme):
        raise ValueError(f"its {name} must be an address of HTTPS")
    return address


def _claims(
    token: Mapping[str, Any], keys: Any, metadata: Mapping[str, Any], settings: Settings, nonce: str
) -> Mapping[str, Any]:
    """The claims of an ID token whose signature, issuer, audience, times and nonce are those of this sign-in."""
    from authlib.oidc.core import CodeIDToken
    from joserfc import jwt
    from joserfc.jwk import KeySet
    from joserfc.jws import JWSRegistry

    supported = metadata.get("id_token_signing_alg_values_supported", ["RS256"])
    registry = JWSRegistry(algorithms=[each for each in _ALGORITHMS if each in supported], strict_check_header=False)
    decoded = jwt.decode(token["id_token"], KeySet.import_key_set(keys), registry=registry)
    options = {
        "iss": {"essential": True, "value": settings.openid_issuer},
        "aud": {"essential": True, "value": settings.openid_client},
    }
    parameters = {"nonce": nonce, "client_id": settings.openid_client, "access_token": token.get("access_token")}
    claims = CodeIDToken(decoded.claims, decoded.header, options, parameters)
    claims.validate(leeway=_LEEWAY)
    return dict(claims)


def _token_of(claims: Mapping[str, Any], settings: Settings) -> "Token":
    """The person with the rights of a token. Raises UsageError for a person in no group of the settings."""
    from sigcat.registry.storing.tokens import Token

    is_verified = claims.get("email") and claims.get("email_verified") is not False
    name = str(claims["email"] if is_verified else claims["sub"])[:_NAME_CHARACTERS]
    value = claims.get(settings.openid_claim, [])
    groups = value if isinstance(value, list) else [value]
    group = next((each for each in settings.openid_groups if each.name in groups), None)
    if group is None:
        raise UsageError(
            f"{name} is in no group that may use the registry. The setting `openid_groups` lists these groups."
        )
    return Token(name, "", group.scopes, group.owner, "", "", "")
