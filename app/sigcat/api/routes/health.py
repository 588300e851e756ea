"""Health: whether the process lives, and whether it can answer."""

from fastapi import APIRouter, Request

from sigcat.api.answers.schemas import Health

router = APIRouter(tags=["operation"])


@router.get("/health", name="get_health")
@router.get("/healthz", name="get_healthz")
@router.get("/health/live")
async def get_liveness() -> Health:
    """Whether the process lives. An orchestrator restarts it when this does not answer."""
    return Health(state="alive", digests={}, outdated=[], skipped=[])


@router.get("/health/ready")
async def get_readiness(request: Request) -> Health:
    """Whether catalogues are loaded and requests can be answered; with their hashes, which are equal on all replicas."""
    hosted, functions = list(request.app.state.library), request.app.state.functions
    return Health(
        state="ready",
        digests={entry.source.id: entry.catalogue.digest for entry in hosted},
        outdated=[
            *(f"catalogue {entry.source.id}" for entry in hosted if entry.rejected),
            *(f"function {file.id}" for file in functions.files if file.rejected),
        ],
        skipped=list(functions.skipped),
    )
