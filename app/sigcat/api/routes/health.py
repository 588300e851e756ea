"""Health: whether the process lives, and whether it can answer."""

from fastapi import APIRouter, Request
from pydantic import BaseModel, Field

router = APIRouter(prefix="/health", tags=["operation"])


class Health(BaseModel):
    """Answer of a health check."""

    status: str = Field(description="`alive`, or `ready`.", examples=["ready"])
    catalogues: dict[str, str] = Field(default={}, description="Content hash of each hosted catalogue by id.")


@router.get("/live")
async def get_liveness() -> Health:
    """Whether the process lives. An orchestrator restarts it when this does not answer."""
    return Health(status="alive", catalogues={})


@router.get("/ready")
async def get_readiness(request: Request) -> Health:
    """Whether catalogues are loaded and requests can be answered; with their hashes, which are equal on all replicas."""
    hosted = list(request.app.state.library)
    return Health(status="ready", catalogues={entry.source.id: entry.catalogue.digest for entry in hosted})
