"""End-to-end protection: which events have it, by which profile, and with which data ids."""

import json

import pytest

from sigcat.errors import InputRefused
from sigcat.function.function_json.wire import written
from sigcat.integration.autosar_adaptive.document import read_integration
from tests.integration.autosar_adaptive.identifiers import identifiers_of
from tests.integration.autosar_adaptive.sets import at, deployed, derive, function, signal

SPEED, ANGLE = "VehicleBranchService.Branch_Speed", "VehicleBranchService.Branch_Angle"


def demo(**more):
    """One signal with an ASIL, one without."""
    return function(signals=[at("Vehicle.Branch.Speed", AsilLevel="B", **more), at("Vehicle.Branch.Angle")])


def derived(e2e, one=None, **settings):
    return derive([one or demo()], deployed(autosarAdaptive={"e2e": e2e, **settings}))


def protections(found):
    """Profile and largest step, by event."""
    return {
        f"{interface.name}.{event.name}": (event.protection.profile, event.protection.max_delta_counter)
        for component in found.model.components
        for interface in component.services
        for event in interface.services[0].events
        if event.protection
    }


def data_ids(found):
    return [
        event.protection.data_id
        for component in found.model.components
        for interface in component.services
        for event in interface.services[0].events
        if event.protection
    ]


def rules(found):
    return [finding.rule for finding in found.findings]


@pytest.mark.parametrize(
    ("e2e", "expected"),
    [
        ({}, {}),
        ({"profile": 4}, {SPEED: (4, 1)}),
        ({"profile": 5, "maxDeltaCounter": 3}, {SPEED: (5, 3)}),
        ({"events": {ANGLE: {"profile": 6}}}, {ANGLE: (6, 1)}),
        ({"profile": 4, "events": {"VehicleBranchService": {"profile": 7}}}, {SPEED: (7, 1), ANGLE: (7, 1)}),
        (
            {"events": {"VehicleBranchService": {"profile": 7, "maxDeltaCounter": 2}, SPEED: {"profile": 4}}},
            {SPEED: (4, 2), ANGLE: (7, 2)},
        ),
        ({"profile": 4, "events": {SPEED: {"profile": "none"}}}, {}),
    ],
    ids=["nothing", "by ASIL", "lost messages pass", "one event", "a service", "an event before its service", "none"],
)
def test_protected_are(e2e, expected):
    assert protections(derived(e2e)) == expected


def test_an_event_with_an_asil_is_told_unless_it_is_protected():
    assert rules(derived({})) == ["A019"]
    assert rules(derived({"profile": 4})) == []


def test_an_error_of_protection_needs_one():
    one = demo(E2eError="Broken")
    assert rules(derived({}, one)) == ["A019", "A021"]
    assert rules(derived({"profile": 4}, one)) == []


def test_what_the_deployment_says_of_no_event_is_told():
    found = derived({"profile": 4, "events": {"VehicleBranchService.Branch_Sped": {"profile": 5}}})
    assert [(f.rule, SPEED in f.fix) for f in found.findings] == [("A014", True)]


def test_a_data_id_is_unique_and_stays_when_another_event_comes():
    everything = {"events": {"VehicleBranchService": {"profile": 4}}}
    few = data_ids(derived(everything))
    many = data_ids(derived(everything, function(signals=[at(f"Vehicle.Branch.A{n}") for n in range(200)])))
    assert len(set(many)) == 200
    more = function(signals=[at("Vehicle.Branch.Speed"), at("Vehicle.Branch.Angle"), at("Vehicle.Branch.Other")])
    assert set(few) < set(data_ids(derived(everything, more)))


@pytest.mark.parametrize("key", ["identifiers", "identifierCatalogue"])
def test_the_deployment_or_an_id_catalogue_may_fix_a_data_id(key):
    found = derived({"profile": 4}, **{key: {f"{SPEED}:dataId": 4660}})
    assert data_ids(found) == [4660]
    assert found.findings == ()


def test_an_id_that_the_catalogue_has_for_another_event_is_not_given_away():
    (own,) = data_ids(derived({"profile": 4}))
    (moved,) = data_ids(derived({"profile": 4}, identifierCatalogue={"OtherService.Event:dataId": own}))
    assert moved != own


@pytest.mark.parametrize(("profile", "number"), [(4, 0xFFFF_FFFF), (7, 0x0001_0000), (5, 0xFFFF), (6, 65535)])
def test_a_data_id_has_the_bits_of_its_profile(profile, number):
    made = derived({"profile": profile}, identifiers={f"{SPEED}:dataId": number})
    assert data_ids(made) == [number]
    assert [finding.rule for finding in made.findings if finding.severity == "error"] == []
    read_integration(written(made.model), "integration.json")


@pytest.mark.parametrize("profile", [5, 6])
def test_a_data_id_that_its_profile_does_not_have_is_refused(profile):
    made = derived({"profile": profile}, identifiers={f"{SPEED}:dataId": 65536})
    assert [finding.rule for finding in made.findings if finding.severity == "error"] == ["A009"]


def test_data_ids_of_profile_4_have_the_instance_in_their_highest_byte():
    made = derived({"profile": 4})
    instance = next(number for name, number in identifiers_of(made.model).items() if name.endswith(":instance"))
    assert 1 <= instance <= 255
    assert [number >> 24 for number in data_ids(made)] == [instance]


ERROR = {
    "Name": "Demo_Bad_ErrorSts", "Description": "Is bad.", "Datatype": "DT_Bool", "Dependancy": [], "OccurenceCountLimit": 1,
    "IgnitionCountLimit": 0, "MaturationTime": 0, "Severity": "Low", "AsilLevel": "B",
}  # fmt: skip


def field(found):
    """The one field of the first service."""
    return found.model.components[0].services[0].services[0].fields[0]


def test_a_field_with_an_asil_is_protected_as_events_are_and_has_no_getter():
    one = function(contract={"ErrorList": [ERROR]})
    assert rules(derived({}, one)) == ["A019"]
    found = derived({"profile": 4}, one)
    assert rules(found) == []
    assert (field(found).protection.profile, field(found).getter_id) == (4, None)
    assert field(derived({}, one)).getter_id is not None
    assert read_integration(written(found.model), "integration.json") == found.model


def test_the_advice_for_a_field_can_be_followed():
    one = function(contract={"ErrorList": [ERROR]})
    (service,) = derive([one]).model.components[0].services
    (finding,) = derived({}, one).findings
    assert "`profile` under `e2e`" in finding.fix
    found = derived({"events": {f"{service.name}.Demo_Bad_ErrorSts": {"profile": 5}}}, one)
    assert (rules(found), field(found).protection.profile) == ([], 5)


def test_data_ids_of_fields_and_events_are_unique_and_kept():
    found = derived(
        {"profile": 4}, function(signals=[at("Vehicle.Branch.Speed", AsilLevel="B")], contract={"ErrorList": [ERROR]})
    )
    kept = {name: number for name, number in identifiers_of(found.model).items() if name.endswith(":dataId")}
    assert len(kept) == len(set(kept.values())) == 2


METHOD = {
    "Name": "Ask",
    "Description": "Asks.",
    "Role": "Provider",
    "AsilLevel": "B",
    "InDataTypeList": [],
    "OutDataTypeList": [],
}


def test_a_method_cannot_be_protected_and_the_deployment_that_says_so_is_told():
    one = function(contract={"MethodList": [METHOD]})
    (service,) = derive([one]).model.components[0].services
    found = derived({"events": {f"{service.name}.Ask": {"profile": 4}}}, one)
    (finding,) = [each for each in found.findings if each.rule == "A014"]
    assert finding.message.startswith(f"{service.name}.Ask cannot be protected end to end.")


def test_the_document_read_back_has_it():
    model = derived({"profile": 4, "maxDeltaCounter": 2}).model
    assert read_integration(written(model), "integration.json") == model


def test_data_ids_are_kept_by_the_keys_that_fix_them():
    model = derived({"profile": 4}).model
    assert identifiers_of(model)[f"{SPEED}:dataId"] == data_ids(derived({"profile": 4}))[0]


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ([{"Profile": 5, "DataID": 65536}], "must be from 0 to 65535"),
        ([{"Profile": 4, "DataID": 7}, {"Profile": 5, "DataID": 7}], "must have different ids, not both 7"),
        ([{"Profile": 4, "DataID": 2**32}], "4294967295"),
        ([{"Profile": 8, "DataID": 7}], "4, 5, 6 or 7"),
        ([{"DataID": 7}], "Write Profile: 4, 5, 6 or 7."),
    ],
    ids=["16 bits", "twice", "32 bits", "profile", "no profile"],
)
def test_a_document_with_other_data_ids_or_profiles_is_refused(given, message):
    document = json.loads(written(derived({}).model))
    events = document["ComponentList"][0]["ServiceInterfaceList"][0]["ServiceList"][0]["Events"]
    for event, protection in zip(events, given, strict=False):
        event["E2eProtection"] = {"MaxDeltaCounter": 1, **protection}
    with pytest.raises(InputRefused) as refused:
        read_integration(json.dumps(document).encode(), "integration.json")
    assert any(message in finding.message + finding.fix for finding in refused.value.findings), refused.value.findings


@pytest.mark.parametrize(
    ("datatype", "vss", "expected"), [("DT_String", "string", ["A022"]), ("DT_Float32", "float", [])]
)
def test_profile_5_wants_a_fixed_length(datatype, vss, expected):
    one = function(signals=[signal("Demo", VssPath="Vehicle.Branch.Demo", Datatype=datatype, VssDatatype=vss)])
    everything = {"events": {"VehicleBranchService": {"profile": 5}}}
    assert rules(derived(everything, one)) == expected
    assert rules(derived({"events": {"VehicleBranchService": {"profile": 6}}}, one)) == []
