"""Datatypes, proxies and skeletons of an Integration JSON, named as SWS_CM of AUTOSAR R23-11 names them."""

import json
from typing import Any

import pytest

from sigcat.adapter.autosar_adaptive.bench.adaptive_bench import generate
from sigcat.adapter.autosar_adaptive.cpp_names import member_name
from sigcat.errors import InputRefused
from sigcat.integration.autosar_adaptive.document import read_integration
from tests.adapter.autosar_adaptive.bench.probe_service import integration_json

INCLUDE = "include/probe/demo"


def files(document: bytes) -> dict[str, str]:
    """Every generated file, by its name."""
    return {file.name: file.data.decode() for file in generate(read_integration(document, "probe.json"))}


@pytest.fixture(scope="module")
def made() -> dict[str, str]:
    """Those of the service of the tests."""
    return files(integration_json())


def document(**service: Any) -> dict[str, Any]:
    """The Integration JSON without further processes, with other fields of the service."""
    loaded: dict[str, Any] = json.loads(integration_json())
    for component in loaded["ComponentList"]:
        del component["Processes"]
        component["ServiceInterfaceList"][0] |= service
    return loaded


def test_namespaces_are_folders_and_headers_have_the_name_of_what_is_in_them(made: dict[str, str]) -> None:
    headers = {name.removeprefix(f"{INCLUDE}/") for name in made if name.startswith(INCLUDE)}
    assert headers == {
        "probeservice_common.h", "probeservice_proxy.h", "probeservice_skeleton.h", "probeservice_tables.h",
        "impl_type_corners_t.h", "impl_type_flags_t.h", "impl_type_image_t.h", "impl_type_mode_t.h",
        "impl_type_string.h", "impl_type_track_t.h", "functionmethod_error_domain.h",
    }  # fmt: skip


def test_a_struct_includes_what_it_is_made_of(made: dict[str, str]) -> None:
    assert made[f"{INCLUDE}/impl_type_track_t.h"] == (
        """// Track_T.
#ifndef PROBE_DEMO_IMPL_TYPE_TRACK_T_H_
#define PROBE_DEMO_IMPL_TYPE_TRACK_T_H_

#include "probe/demo/impl_type_corners_t.h"
#include "probe/demo/impl_type_flags_t.h"
#include "probe/demo/impl_type_mode_t.h"
#include "probe/demo/impl_type_string.h"

namespace probe::demo {

struct Track_T {
    probe::demo::String name{};
    probe::demo::Mode_T mode{};
    probe::demo::Corners_T corners{};
    probe::demo::Flags_T flags{};
    double distance{};
};

}  // namespace probe::demo

#endif  // PROBE_DEMO_IMPL_TYPE_TRACK_T_H_
"""
    )


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("impl_type_mode_t.h", "enum class Mode_T : std::uint8_t {"),
        ("impl_type_corners_t.h", "using Corners_T = ara::core::Array<std::int16_t, 4>;"),
        ("impl_type_image_t.h", "using Image_T = ara::core::Vector<std::uint8_t>;"),
        ("impl_type_string.h", "using String = ara::core::String;"),
        ("probeservice_proxy.h", "namespace probe::demo::proxy {"),
        ("probeservice_proxy.h", "class ProbeServiceProxy final : public bench::ProxyBase<probeservice_tables::kService> {"),
        ("probeservice_proxy.h", "// Speed."),
        ("probeservice_proxy.h", "class Speed final : public bench::ProxyEvent<float> {"),
        ("probeservice_proxy.h", "class Mode final : public bench::ProxyField<probe::demo::Mode_T> {"),
        ("probeservice_proxy.h", "    using Output = probe::demo::probeservice_outputs::AddOutput;"),
        ("probeservice_proxy.h", "    methods::Add Add;"),
        ("probeservice_skeleton.h", "namespace probe::demo::skeleton {"),
        ("probeservice_skeleton.h", "    virtual ara::core::Future<AddOutput> Add(const std::int32_t& left, const std::int32_t& right) = 0;"),
        ("probeservice_skeleton.h", "    virtual ara::core::Future<void> Reset() = 0;"),
    ],
)  # fmt: skip
def test_names_are_those_of_the_standard(made: dict[str, str], name: str, line: str) -> None:
    assert line in made[f"{INCLUDE}/{name}"].splitlines()


@pytest.mark.parametrize(
    ("short_name", "name"), [("speed", "Speed"), ("ADAS_Mode", "ADAS_Mode"), ("coreAcc_mode", "CoreAcc_mode")]
)
def test_members_are_in_upper_camel_case(short_name: str, name: str) -> None:
    assert member_name(short_name) == name


def test_the_same_document_gives_the_same_bytes(made: dict[str, str]) -> None:
    assert files(integration_json()) == made


def test_a_service_may_have_a_namespace_of_its_own(made: dict[str, str]) -> None:
    other = files(json.dumps(document(Namespace="elsewhere")).encode())
    assert "include/elsewhere/probeservice_proxy.h" in other
    assert other[f"{INCLUDE}/impl_type_track_t.h"] == made[f"{INCLUDE}/impl_type_track_t.h"]


def refusal(made: object) -> str:
    """The messages with which a document is refused."""
    with pytest.raises(InputRefused) as refused:
        files(json.dumps(made).encode())
    assert all(finding.fix for finding in refused.value.findings)
    return " ".join(finding.message for finding in refused.value.findings)


def test_two_services_of_one_namespace_share_no_name() -> None:
    both = document()
    for component in both["ComponentList"]:
        first = component["ServiceInterfaceList"][0]
        second = {**first, "Name": "OtherService", "ServiceID": 0x777, "ServiceInstanceID": 78}
        component["ServiceInterfaceList"].append(second)
    assert "OtherService and ProbeService must not both have Speed in one namespace" in refusal(both)
    for component in both["ComponentList"]:
        component["ServiceInterfaceList"][1]["Namespace"] = "elsewhere"
    assert "include/elsewhere/otherservice_proxy.h" in files(json.dumps(both).encode())


@pytest.mark.parametrize("namespace", ["bench", "demo::ara", "demo::std", "other::probe"])
def test_a_namespace_that_hides_another_one_is_refused(namespace: str) -> None:
    assert "The namespace of ProbeService must not have" in refusal(document(Namespace=namespace))


def test_an_element_must_not_be_called_as_every_proxy_has_it() -> None:
    taken = document()
    for component in taken["ComponentList"]:
        component["ServiceInterfaceList"][0]["ServiceList"][0]["Methods"][0]["Name"] = "findService"
    assert "findService of ProbeService must have another name" in refusal(taken)


def test_each_of_18_services_has_a_proxy_and_each_of_162_events_its_description() -> None:
    large = document()
    events = [
        {
            "Name": f"Event{n}",
            "DataType": "Track_T",
            "EventID": 0x8001 + n,
            "EventGroup": "Fast",
            "DataMappingList": None,
        }
        for n in range(9)
    ]
    for component in large["ComponentList"]:
        first = component["ServiceInterfaceList"][0]
        component["ServiceInterfaceList"] = [
            {**first, "Name": f"Service{n}", "Namespace": f"service{n}", "ServiceID": 0x100 + n,
             "ServiceInstanceID": 200 + n, "ServiceList": [{"Events": events, "Methods": [], "Fields": []}]}
            for n in range(18)
        ]  # fmt: skip
    made = files(json.dumps(large).encode())
    assert sum(name.endswith("_proxy.h") for name in made) == 18
    tables = [text for name, text in made.items() if name.endswith("_tables.cpp")]
    assert [text.count('{"Event') for text in tables] == [9] * 18
