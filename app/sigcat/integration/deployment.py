"""Settings of a deployment for every platform: responsible team and names of documents."""

import datetime as dt
from typing import Annotated, Self

from pydantic import Field, PrivateAttr

from sigcat.findings import Finding, RuleCode
from sigcat.function.declaration.form import DeclarationModel, Text
from sigcat.function.document.document import Document, Pointer
from sigcat.function.document.field_types import VERSION, Name, VssPath


class Deployment(DeclarationModel):
    """Settings that differ from the defaults of `derive`, whatever the platform. All of it is optional."""

    name: Text | None = Field(None, description="Name of the application; made from the functions' names if absent.")
    description: Text | None = Field(None, description="What the application does; the functions' own words if absent.")
    responsible: Text | None = Field(None, description="Who answers for the integration.")
    authority: Text | None = Field(None, description="Organization that the documents belong to.")
    author: Text | None = Field(None, description="Author of the documents.")
    date: dt.date | None = Field(None, description="Date of the documents, as 2025-09-12; the functions' if absent.")
    version: Annotated[str, Field(pattern=r"^\d+\.\d+\.\d+$"), VERSION] | None = Field(
        None, description="Version of the documents, as 1.2.3."
    )
    safety_manager: Text | None = Field(
        None, description="Who informs functions of safety conditions: the provider of every safety reaction."
    )
    mode_manager: Text | None = Field(
        None, description="Who sends functions their mode: the provider of every mode in."
    )
    paths: dict[Name, VssPath] = Field(
        {}, description="VSS paths of signals that name none, by `Function.Signal`; for Function JSON from elsewhere."
    )
    _document: Document | None = PrivateAttr(default=None)

    def read_from(self, document: Document) -> Self:
        """The same, with the file that it was read from."""
        self._document = document
        return self

    def finding(self, rule: RuleCode, pointer: Pointer, message: str, fix: str, path: str) -> Finding:
        """A finding about a key of the file, or about a value that has none."""
        if self._document is None:
            return rule.finding(message, path=path, fix=fix)
        return self._document.finding(rule, pointer, message, fix, path, of_key=isinstance(pointer[-1], str))


NO_DEPLOYMENT = Deployment.model_construct()
"""Everything by default."""
