"""Writes the speed three times, and prints what eco_control_mpc sends: by CycloneDDS, without anything of ROS 2.

Types and topics are what ROS 2 makes of messages: `dds_`, `_` and `rt/`.
"""

import json
import os
import time
from dataclasses import dataclass
from typing import Any

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.idl import IdlStruct, types
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

PATIENCE = 60.0
SETTINGS = """<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast>
<Interfaces><NetworkInterface address="127.0.0.1"/></Interfaces></General>
<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>60</MaxAutoParticipantIndex>
<Peers><Peer Address="127.0.0.1"/></Peers></Discovery></Domain></CycloneDDS>"""
RELIABLE = Policy.Reliability.Reliable(duration(seconds=1))


@dataclass
class Time(IdlStruct, typename="builtin_interfaces::msg::dds_::Time_"):  # type: ignore[call-arg, misc]
    """A time, as ROS 2 has it."""

    sec: types.int32 = 0
    nanosec: types.uint32 = 0


@dataclass
class Speed(IdlStruct, typename="eco_control_interfaces::msg::dds_::Speed_"):  # type: ignore[call-arg, misc]
    """Vehicle.Speed."""

    stamp: Time
    speed: types.float32


@dataclass
class Proposal(IdlStruct, typename="eco_control_interfaces::msg::dds_::EcoControlMpcCycle500ms_"):  # type: ignore[call-arg, misc]
    """Vehicle.ADAS.EcoControl.AccelerationProposal."""

    stamp: Time
    acceleration_proposal: types.float32


@dataclass
class Reaction(IdlStruct, typename="eco_control_interfaces::msg::dds_::SafetyReaction_"):  # type: ignore[call-arg, misc]
    """A safety reaction."""

    stamp: Time
    state: types.uint8


def first(reader: DataReader) -> Any:
    """Return the first message."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        for sample in reader.take(1):
            return sample
        time.sleep(0.01)
    raise TimeoutError(reader.topic.name)


def main() -> None:
    """Read, write, tell."""
    number = int(os.environ["ROS_DOMAIN_ID"])
    domain = Domain(number, SETTINGS)
    participant = DomainParticipant(number)
    kept = Qos(RELIABLE, Policy.Durability.TransientLocal, Policy.History.KeepLast(1))
    speeds = DataWriter(participant, Topic(participant, "rt/vehicle/speed", Speed), Qos(RELIABLE))
    proposals = Topic(participant, "rt/eco_control_mpc/cycle500_ms", Proposal)
    reactions = Topic(participant, "rt/eco_control_mpc/acc_prop_invalid", Reaction)
    proposal = first(DataReader(participant, proposals, Qos(Policy.Reliability.BestEffort)))
    reaction = first(DataReader(participant, reactions, kept))
    while not speeds.get_matched_subscriptions():
        time.sleep(0.01)
    for number in range(3):
        speeds.write(Speed(Time(), 10.0 * number))
        time.sleep(0.05)
    print(json.dumps({"proposal": proposal.acceleration_proposal, "reaction": reaction.state}))
    time.sleep(1)
    del domain


if __name__ == "__main__":
    main()
