"""Ids of services, events and methods: given, taken over, or made from the name."""

from sigcat.integration.autosar_adaptive.model import IntegrationModel
from tests.integration.autosar_adaptive.derived import services
from tests.integration.autosar_adaptive.identifiers import identifiers_of
from tests.integration.autosar_adaptive.sets import at, deployed, derive, example, examples, function


def ids(model: IntegrationModel):
    """Every id by what it belongs to."""
    found = {}
    for part in model.components:
        for interface in part.services:
            found[interface.name] = interface.service_id
            found[f"{interface.name}:instance"] = interface.instance_id
            for group in interface.event_groups or ():
                found[f"{interface.name}.{group.name} group"] = group.id
            for event in interface.services[0].events:
                found[f"{interface.name}.{event.name}"] = event.event_id
            for field in interface.services[0].fields:
                found[f"{interface.name}.{field.name}"] = field.notifier_id
                found[f"{interface.name}.Get{field.name}"] = field.getter_id
    return found


def test_ids_do_not_change_when_a_signal_is_added():
    paths = [f"Vehicle.Branch{i}.Signal{j}" for i in range(5) for j in range(8)]
    before = ids(derive([function(signals=[at(path) for path in paths])]).model)
    for more in ("Vehicle.Aaa.First", "Vehicle.Branch2.Between", "Vehicle.Zzz.Last"):
        after = ids(derive([function(signals=[at(path) for path in sorted([*paths, more])])]).model)
        assert before.items() <= after.items()


def test_ids_do_not_change_when_a_function_is_added():
    before = ids(derive([example("EcoControlMpc")]).model)
    after = ids(derive(examples()).model)
    assert before.items() <= after.items()


def test_ids_are_unique_and_in_range():
    paths = [f"Vehicle.Branch{i % 18}.Signal{i}" for i in range(3000)]
    model = derive([function(signals=[at(path) for path in paths])]).model
    found = list(services(model).values())
    assert len({service.service_id for service in found}) == len({service.instance_id for service in found}) == 18
    for service in found:
        numbers = [event.event_id for event in service.services[0].events]
        assert len(set(numbers)) == len(numbers)
        assert all(number is not None and 0x8001 <= number <= 0xFFFE for number in numbers)


def test_ids_that_depend_on_each_other_are_told_with_what_keeps_them():
    paths = [f"Vehicle.Branch.Signal{i}" for i in range(600)]
    derived = derive([function(signals=[at(path) for path in paths])])
    reported = [finding for finding in derived.findings if finding.rule == "A008"]
    assert reported
    assert reported[0].fix.startswith("To keep it, fix it in the deployment file: identifiers: {VehicleBranchService.")


def test_ids_that_a_deployment_keeps_stay_whatever_is_added():
    paths = [f"Vehicle.Branch.Signal{i}" for i in range(900)]
    before = derive([function(signals=[at(path) for path in paths[300:]])]).model
    kept = deployed(autosarAdaptive={"identifiers": identifiers_of(before)})
    after = derive([function(signals=[at(path) for path in paths])], kept).model
    assert ids(before).items() <= ids(after).items()


def test_the_deployment_may_fix_ids():
    given = {"VehicleBranchService": 4660, "VehicleBranchService:instance": 7, "VehicleBranchService.Branch_B": 32769}
    derived = derive([function(signals=[at("Vehicle.Branch.B")])], deployed(autosarAdaptive={"identifiers": given}))
    made = ids(derived.model)
    assert given.items() <= made.items()


def test_an_id_that_the_deployment_gives_twice_or_out_of_range_is_refused():
    given = {
        "VehicleBranchService.Branch_A": 5,
        "VehicleBranchService.Branch_B": 32769,
        "VehicleBranchService.Branch_C": 32769,
    }
    one = function(signals=[at(f"Vehicle.Branch.{name}") for name in "ABC"])
    derived = derive([one], deployed(autosarAdaptive={"identifiers": given}))
    assert [(finding.rule, finding.severity) for finding in derived.findings] == [("A009", "error")] * 2
