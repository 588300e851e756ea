"""The deployment file: settings for every platform, and a section for each platform of the table."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import Field, ValidationError, create_model

from sigcat import codes
from sigcat.errors import InputRefused, existing_file
from sigcat.findings import has_errors, in_order
from sigcat.function.document.read_yaml import read_yaml
from sigcat.function.document.structure import structural_findings
from sigcat.function.document.unfit_texts import unfit_texts
from sigcat.function.function_json.wire import document_schema
from sigcat.integration.deployment import Deployment
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.platforms.table import PLATFORMS

_SECTIONS: dict[str, Any] = {
    platform.section: (
        platform.settings(),
        Field(platform.settings().model_validate({}), description=f"What holds for {platform.title}."),
    )
    for platform in PLATFORMS.values()
}
DEPLOYMENT_FILE = create_model(
    "Deployment", __base__=Deployment, __doc__="What holds for every platform, and a section for each.", **_SECTIONS
)
DEFAULT_DEPLOYMENT: Deployment = DEPLOYMENT_FILE.model_validate({})


def read_deployment(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> Deployment:
    """The deployment of a YAML or JSON file. Raises InputRefused with everything that is wrong."""
    document = read_yaml(data, name, limits)
    findings = document.findings
    if not has_errors(findings):
        try:
            deployment = DEPLOYMENT_FILE.model_validate(document.value).read_from(document)
        except ValidationError as error:
            findings = (*findings, *structural_findings(error, document, DEPLOYMENT_FILE))
        else:
            unfit = unfit_texts(deployment)
            findings = tuple(
                document.finding(codes.VALUE_UNFIT, each.pointer, each.message, each.fix) for each in unfit
            )
            if not findings:
                return deployment
    raise InputRefused(f"{name} cannot be used as a deployment file.", in_order(findings))


def deployment_of_file(path: Path, environment: Mapping[str, str]) -> Deployment:
    """The deployment of a file of this machine, with the files that it names. Raises InputRefused."""
    deployment = read_deployment(existing_file(path).read_bytes(), str(path))
    for platform in PLATFORMS.values():
        if platform.with_files is not None:
            deployment = platform.with_files(deployment, path.parent, environment)
    return deployment


def deployment_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of the deployment file, for editors."""
    return document_schema(DEPLOYMENT_FILE)
