"""The deployment file: what differs from the defaults that `derive` takes for a platform. All of it is optional."""

import datetime as dt
from typing import Annotated, Any

from pydantic import Field, ValidationError

from sigcat.errors import InputRefused
from sigcat.findings import has_errors, in_order
from sigcat.function.document.document import read_yaml
from sigcat.function.document.form import DeclarationModel, Text
from sigcat.function.document.structure import structural_findings
from sigcat.integration.autosar_adaptive.settings import AutosarAdaptiveSettings
from sigcat.integration.ros2.settings import Ros2Settings
from sigcat.limits import DEFAULT_LIMITS, Limits


class Deployment(DeclarationModel):
    """What holds for every platform, and a section for each."""

    name: Text | None = Field(None, description="Name of the application; made from the functions' names if absent.")
    description: Text | None = Field(None, description="What the application does; the functions' own words if absent.")
    responsible: Text | None = Field(None, description="Who answers for the integration.")
    authority: Text | None = Field(None, description="Organization that the documents belong to.")
    author: Text | None = Field(None, description="Author of the documents.")
    date: dt.date | None = Field(None, description="Date of the documents, as 2025-09-12; the functions' if absent.")
    version: Annotated[str, Field(pattern=r"^\d+\.\d+\.\d+$")] | None = Field(
        None, description="Version of the documents, as 1.2.3."
    )
    paths: dict[str, Text] = Field(
        {}, description="VSS paths of signals that name none, by `Function.Signal`; for Function JSON from elsewhere."
    )
    autosar_adaptive: AutosarAdaptiveSettings = Field(
        AutosarAdaptiveSettings.model_validate({}), description="What holds for AUTOSAR adaptive."
    )
    ros2: Ros2Settings = Field(Ros2Settings.model_validate({}), description="What holds for ROS 2.")


DEFAULT_DEPLOYMENT = Deployment.model_validate({})


def read_deployment(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> Deployment:
    """The deployment of a YAML or JSON file. Raises InputRefused with everything that is wrong."""
    document = read_yaml(data, name, limits)
    findings = document.findings
    if not has_errors(findings):
        try:
            return Deployment.model_validate(document.value)
        except ValidationError as error:
            findings = (*findings, *structural_findings(error, document, Deployment))
    raise InputRefused(f"{name} is no deployment file.", in_order(findings))


def deployment_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of the deployment file, for editors."""
    schema = Deployment.model_json_schema(by_alias=True)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}
