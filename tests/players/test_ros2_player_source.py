"""The player of ROS 2, as text: it reads a trace and writes outputs as the simulation does."""

import json
from pathlib import Path

from sigcat.players.ros2_player_source import player_files
from tests.adapter.autosar_adaptive.application.generated import FULL
from tests.adapter.ros2 import generated

OBJECTS = Path(__file__).parents[1] / "runs/cases/structs_and_queues/function.yaml"


def topics(function=FULL / "function.yaml", **ros2):
    """Generated code for the topics of a function, by default of one that uses everything."""
    document = json.loads(generated.integration(function, deployment={"ros2": ros2}))
    files = {file.name: file.data.decode() for file in player_files(document)}
    return files["player/topics.cpp"]


def test_members_of_structs_are_called_as_in_the_catalogue():
    text = topics()
    assert "value.latitude = player::Read<std::decay_t<decltype(value.latitude)>>(from);" in text
    assert 'std::string("{") + "\\042Latitude\\042:" + player::Text(value.latitude, true)' in text


def test_members_that_are_enumerations_have_names():
    assert 'Fill(value.kind, from, {{"CAR", 0}, {"TRUCK", 1}});' in topics(OBJECTS)
    assert 'NameOf(value.kind, {{"CAR", 0}, {"TRUCK", 1}}, true)' in topics(OBJECTS)


def test_only_a_field_with_names_has_names():
    """Constants of a message are those of one of its fields; the others are numbers and structs."""
    text = topics(enumerations="number")
    assert '{"Vehicle.Full.GearOut", NameOf(message.gear_out, {{"P", 0}, {"R", 1}, {"D", 2}})}' in text
    assert '{"Vehicle.Full.Acc", Text(message.acc)}, {"Vehicle.Full.Scaled", Text(message.scaled)}' in text
    assert '{"Vehicle.Full.PlaceOut", Text(message.place_out)}' in text


def test_a_text_is_sent_with_its_number():
    names = '{{"P", 0}, {"R", 1}, {"D", 2}}'
    assert f"FillAll(message.gear, cell, {names}); FillAll(message.gear_number, cell, {names});" in topics()


def test_names_of_an_array_are_sent_with_their_numbers():
    names = '{{"NONE", 0}, {"SOLID", 1}}'
    assert f"FillAll(message.lanes, cell, {names}); FillAll(message.lanes_number, cell, {names});" in topics(OBJECTS)


def test_modes_have_the_names_of_their_interface():
    assert '{"Full_Mode_Out", NameOf(message.mode, {{"OFF", 0}, {"ON", 1}})}' in topics()
