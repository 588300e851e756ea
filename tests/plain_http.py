"""Ask a service on this machine, each time on a separate connection; `httpx.get` would read all certificates each time."""

import httpx

from tests.waiting import DEADLINE

_CLIENT = httpx.Client(verify=False, timeout=DEADLINE, limits=httpx.Limits(max_keepalive_connections=0))
get, post, request = _CLIENT.get, _CLIENT.post, _CLIENT.request
