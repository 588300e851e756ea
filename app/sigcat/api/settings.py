"""Settings of the service: in `[service]` of sigcat.toml, and as SIGCAT_… in the environment."""

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field

from sigcat.api.groups import Group, group_from_text
from sigcat.api.tokens import Token, token_from_text
from sigcat.limits import Limits

_MEBIBYTE = 1024 * 1024


def _listed(value: Any) -> Any:
    """A list; in the environment, separated by commas."""
    return tuple(part.strip() for part in value.split(",") if part.strip()) if isinstance(value, str) else value


def _token(value: Any) -> Any:
    return token_from_text(value) if isinstance(value, str) else value


def _group(value: Any) -> Any:
    return group_from_text(value) if isinstance(value, str) else value


Texts = Annotated[tuple[str, ...], BeforeValidator(_listed)]
Tokens = Annotated[tuple[Annotated[Token, BeforeValidator(_token)], ...], BeforeValidator(_listed)]
Groups = Annotated[tuple[Annotated[Group, BeforeValidator(_group)], ...], BeforeValidator(_listed)]


class Settings(BaseModel):
    """Bounds on requests, each with a clear answer when it is exceeded, and the place of the service in its network."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    host: str = Field(default="127.0.0.1", description="Address to listen on.", min_length=1)
    port: int = Field(default=8000, description="Port to listen on; 0 picks a free one.", ge=0, le=65535)
    root_path: str = Field(
        default="",
        description="Path below which a proxy offers the service, such as `/sigcat`.",
        pattern=r"^(/[\w.~-]+)*$",
    )
    contact_name: str = Field(
        default="The operator of the service", description="Who answers for the service; the OpenAPI document names it."
    )
    contact_url: str = Field(
        default="",
        description="Address of their contact page; shown there too.",
        pattern=r"^(https?://\S+)?$",
    )
    contact_email: str = Field(
        default="", description="Their e-mail address; shown there too.", pattern=r"^([^@\s]+@[^@\s]+)?$"
    )
    trusted_proxies: Texts = Field(
        default=(),
        description="Addresses of proxies whose `X-Forwarded-For` and `X-Forwarded-Proto` are believed; `*`: all.",
    )
    origins: Texts = Field(
        default=(), description="Origins whose pages may call the API from a browser (CORS); `*`: all."
    )
    reading: Literal["open", "token"] = Field(
        default="open", description="Whether reading is open to all, or needs a token with the scope `read`."
    )
    tokens: Tokens = Field(
        default=(), description="Tokens as `NAME:SCOPE+SCOPE:SHA-256`; `sigcat config --new-token` makes one."
    )
    openid_issuer: str = Field(
        default="",
        description="Issuer of OpenID Connect by which people sign in to the registry, such as `https://login.example.org`; "
        "needs the extra `registry-openid`.",
        pattern=r"^(https://[^\s?#]+|http://(localhost|127\.0\.0\.1|\[::1\])(:\d+)?(/[^\s?#]*)?)?$",
    )
    openid_client: str = Field(default="", description="Client id of the service there.", max_length=200)
    openid_secret_file: str = Field(
        default="", description="File with the secret of this client; without it, the client is a public one."
    )
    openid_address: str = Field(
        default="",
        description="Address of the service for browsers, such as `https://signals.example.org`; the provider sends people "
        "back to `/registry/openid/return` there.",
        pattern=r"^(https?://[^\s?#]+[^\s?#/])?$",
    )
    openid_claim: str = Field(
        default="groups", description="Claim of the ID token with the groups of a person.", min_length=1
    )
    openid_groups: Groups = Field(
        default=(),
        description="What people of a group may do, as `GROUP:SCOPE+SCOPE:TEAM`, without `:TEAM` for all teams; of a person in "
        "several, the first counts.",
    )
    connections: int = Field(
        default=1000,
        description="Connections that are open at once, or fewer if the system allows fewer files; for a new one, the one "
        "that waits longest for its client is closed, and if none does: 503.",
        ge=1,
    )
    client_connections: int = Field(
        default=100,
        description="The same of one client: an IPv4 address, or an IPv6 network of 64 bits. `trusted_proxies` may have all.",
        ge=1,
    )
    head_seconds: float = Field(
        default=10.0, description="Seconds in which address and headers of a request have to arrive; later: 408.", gt=0
    )
    unread_seconds: float = Field(
        default=20.0, description="Seconds in which a client has to read some of its answer; else it is cut off.", gt=0
    )
    unread_bytes: int = Field(
        default=64 * _MEBIBYTE,
        description="Bytes of answers that wait until clients read them, in all; beyond, the client with most of them is cut off.",
        ge=_MEBIBYTE,
    )
    body_bytes: int = Field(
        default=4 * _MEBIBYTE, description="Bytes of a posted text; more is answered with 413.", ge=1
    )
    body_seconds: float = Field(default=20.0, description="Seconds in which a body has to arrive; later: 408.", gt=0)
    bodies_bytes: int = Field(
        default=24 * _MEBIBYTE,
        description="Bytes of bodies that are held at once (more: 503), of one client a quarter (more: 429).",
        ge=1,
    )
    nesting: int = Field(
       default=64, description="Levels of collections inside each other in a posted text; more is an error (R004).",
        ge=4, le=256,
    )  # fmt: skip
    values: int = Field(
        default=100_000,
        description="Values in a posted text, aliases counted as often as they are used; more is an error (R014).",
        ge=1_000,
    )
    nodes: int = Field(
        default=100_000, description="Nodes of a tree that a posted text may make; more is a finding.", ge=1_000
    )
    compared: int = Field(
        default=20_000_000,
        description="Characters of paths that the wildcard paths of a posted text are compared with; more is a finding.",
        ge=100_000,
    )
    pattern_seconds: float = Field(
        default=0.3,
        description="Seconds for the `pattern`s of a tree with a posted text; the rest is reported as unchecked.",
        gt=0,
    )
    results: int = Field(default=200, description="Most results in one page of a list; a larger `limit`: 422.", ge=1)
    tree_nodes: int = Field(default=20_000, description="Most nodes in one answer of the tree; more: 422.", ge=1)
    query_characters: int = Field(default=200, description="Longest text to search for; longer: 422.", ge=1)
    heavy_requests: int = Field(
        default=2, description="Compositions, lints and diffs under way at once, each in its own process.", ge=1
    )
    exports: int = Field(default=2, description="Exports under way at once, each in separate processes.", ge=1)
    long_answers: int = Field(default=2, description="Answers of many nodes that are made at once.", ge=1)
    heavy_waiting: int = Field(
        default=32, description="Further ones of each kind that wait; more: 503 with `Retry-After`.", ge=0
    )
    heavy_seconds: float = Field(
        default=60.0,
        description="Seconds that each of them may take, waiting included; what takes longer is ended: 503.",
        gt=0,
    )
    heavy_bytes: int = Field(
        default=256 * _MEBIBYTE,
        description="Bytes of memory that each of them may take; what takes more is ended: 503 (Linux only).",
        ge=8 * _MEBIBYTE,
    )
    client_share: float = Field(
        default=0.5,
        description="Part of them, under way and waiting, that one client (token, else address) may have, at least one; "
        "more: 429 with `Retry-After`.",
        gt=0,
        le=1,
    )
    cache_bytes: int = Field(
        default=32 * _MEBIBYTE, description="Bytes of answers that are kept to be sent again; 0 keeps none.", ge=0
    )
    metrics: bool = Field(default=True, description="Whether `/metrics` serves metrics for Prometheus.")
    log: Literal["json", "none"] = Field(default="json", description="One line of JSON for each request, or none.")
    stop_seconds: int = Field(
        default=10, description="Seconds that requests under way get when the service stops.", ge=0
    )

    @property
    def limits(self) -> Limits:
        """Bounds on a posted text."""
        return Limits(
            file_bytes=self.body_bytes,
            nesting=self.nesting,
            values=self.values,
            nodes=self.nodes,
            compared=self.compared,
            pattern_seconds=self.pattern_seconds,
        )


DEFAULT_SETTINGS = Settings()
