"""The section of the deployment file that concerns ROS 2."""

import re
from typing import Annotated, Literal

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from sigcat.function.declaration.form import DeclarationModel, Natural, Text
from sigcat.function.document.field_types import (
    E_MAIL,
    ROS_NAME,
    ROS_NAMESPACE,
    Name,
    RosField,
    RosInterface,
    RosTopicName,
    UnitKey,
)
from sigcat.function.function_json.wire import Integer, Number
from sigcat.integration.ros2.names import PACKAGES_OF_ROS

EMAIL = re.compile(r"[^@\s<>\"&]+@[^@\s<>\"&]+")
NAMESPACE = re.compile(r"(/[a-z](_?[a-z0-9]+)*)*")


def _not_of_ros(name: str) -> str:
    if name in PACKAGES_OF_ROS:
        raise PydanticCustomError("package_of_ros", "Input should be no package that ROS 2 brings")
    return name


RosName = Annotated[str, Field(pattern=r"^[a-z](_?[a-z0-9]+)*$", max_length=100), AfterValidator(_not_of_ros), ROS_NAME]
Topics = Literal["cycle", "signal", "branch", "function"]


Enumerations = Literal["both", "number", "text"]
MOST_VALUES = 2**31 - 1
"""Most values that a topic keeps: the middleware counts in 32 bits."""
SchedulingPolicy = Literal["other", "fifo", "rr"]


class QualitySettings(DeclarationModel):
    """Differences from the quality of service that is derived from ASIL, cycle and queue."""

    reliability: Literal["reliable", "best_effort"] | None = Field(None, description="Whether lost values are resent.")
    durability: Literal["transient_local", "volatile"] | None = Field(
        None, description="Whether a late subscriber gets the last value."
    )
    depth: Annotated[Natural, Field(ge=1, le=MOST_VALUES)] | None = Field(None, description="Values that are kept.")
    deadline: Natural | None = Field(None, description="Longest time between two values, in ms; 0 for none.")


class FieldSettings(DeclarationModel):
    """The signal of a field of an existing message."""

    signal: Name = Field(description="VSS path of the signal, or `Function.Signal` of one that has none.")
    unit: UnitKey | None = Field(
        None, description="Unit of the field, by its key in the catalogue, as m/s; that of the signal if absent."
    )
    symbols: dict[Name, Integer] | None = Field(
        None,
        description="Numbers that the message has for the values of an enumeration, where the catalogue has others.",
    )


class MessageSettings(DeclarationModel):
    """An existing message whose fields have signals."""

    type: RosInterface = Field(description="The message, as geometry_msgs/Twist.")
    fields: dict[RosField, Name | FieldSettings] = Field(
        description="The signal of each field, by the path of the field, as linear.x.", min_length=1
    )
    values: dict[RosField, bool | Number | Text] = Field(
        {}, description="What other fields of a message that is sent always have, as header.frame_id: base_link."
    )

    @property
    def mapped(self) -> dict[str, FieldSettings]:
        """Signals by the path of their field."""
        return {
            path: FieldSettings.model_validate({"signal": each}) if isinstance(each, str) else each
            for path, each in self.fields.items()
        }


class Ros2Settings(DeclarationModel):
    """Settings for ROS 2."""

    topics: Topics = Field(
        "cycle",
        description="One topic for all that a function of the set provides in one cycle, for each signal, for each branch "
        "and provider, or for all outputs of a function. Only topics for single signals keep name and type whatever else "
        "is integrated.",
    )
    enumerations: Enumerations = Field(
        "both",
        description="How messages hold an enumeration of texts: its number, with a constant for each, beside the text; "
        "or one of the two alone. The numbers are the catalogue's.",
    )
    namespace: Annotated[str, Field(pattern=f"^{NAMESPACE.pattern}$", max_length=100), ROS_NAMESPACE] = Field(
        "", description="Namespace of the nodes, as /ego. Names of topics and services are relative to it."
    )
    message_package: RosName | None = Field(
        None,
        description="Package that holds the messages and services, for sets that share one; <name>_interfaces if "
        "absent.",
    )
    scheduling_policy: SchedulingPolicy = Field(
        "other",
        description="Policy of the threads that run the calls: fifo or rr with the highest priority of a node's calls, or "
        "other, without. The parameter `scheduling_policy` of a node goes before.",
    )
    bond: bool = Field(
        False,
        description="Whether nodes send heartbeats to the lifecycle manager of Nav2, by bondcpp and bondpy, so that it "
        "notices a node that has ended or hangs.",
    )
    maintainer: Text | None = Field(None, description="Maintainer of the packages; the responsible of the function.")
    email: Annotated[str, Field(pattern=f"^{EMAIL.pattern}$", max_length=200), E_MAIL] = Field(
        "maintainer@example.com", description="Mail address of the maintainer; package.xml requires one."
    )
    license: Text = Field("Proprietary", description="License of the packages, as package.xml states it.")
    quality: dict[Name, QualitySettings] = Field(
        {}, description="Quality of service by VSS path or name of a topic, where it differs from the derived one."
    )

    messages: dict[RosTopicName, MessageSettings] = Field(
        {}, description="Existing messages, by the topic that has them, and the signals that their fields have."
    )
    message_folders: tuple[Text, ...] = Field(
        (),
        description="Folders with definitions of existing messages, as PACKAGE/msg/NAME.msg, beside those that ROS 2 has "
        "installed here; relative to the deployment file.",
        strict=False,
    )
    message_definitions: dict[Name, Text] = Field(
        {}, description="Text of the definition of a message, by its name, where no file has it."
    )


NO_SETTINGS = Ros2Settings.model_validate({})
"""Everything by default."""
