"""`sigcat generate autosar-adaptive` writes adaptive applications whole."""

import json
import re
import subprocess
import xml.etree.ElementTree as ET

import pytest

from bench import integration as large_set
from scripts.run_autosar import CODE
from sigcat.adapter.autosar_adaptive.application.adaptive_application import generate
from sigcat.adapter.autosar_adaptive.application.report import report
from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.errors import InputRefused
from sigcat.integration.autosar_adaptive.deployment.releases import SOURCE_RELEASES
from sigcat.integration.reading import read_functions
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.integrate import integrate
from sigcat.platforms.table import PLATFORMS
from tests.adapter.autosar_adaptive.application.generated import (
    ECOCONTROL,
    FULL,
    SMALL,
    ecocontrol,
    files,
    full,
    full_integration,
    small,
    storing,
    write,
)
from tests.needs import CPP_COMPILERS, IS_SLOW_RUN, cmake, slow

STRICT = ("-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror")


def refused(document):
    with pytest.raises(InputRefused) as caught:
        files(json.dumps(document).encode())
    return caught.value.findings


def test_each_executable_has_a_main_function_and_an_adapter_for_each_component():
    assert {name for name in ecocontrol() if name.startswith("CoreAccExecutable/")} == {
        "CoreAccExecutable/CMakeLists.txt",
        "CoreAccExecutable/core_acc_adapter.cpp",
        "CoreAccExecutable/core_acc_adapter.h",
        "CoreAccExecutable/main.cpp",
    }


def test_beside_it_are_the_arxml_and_the_cores():
    folders = {name.partition("/")[0] for name in ecocontrol()}
    assert folders == {
        "CMakeLists.txt", "CoreAccExecutable", "EcoControlMpcExecutable", "README.md", "application", "arxml", "bench",
        "core", "generated", "player",
    }  # fmt: skip


def test_what_runs_it_without_a_platform_is_there_on_request_only():
    plain = files(ECOCONTROL.read_bytes())
    assert {"bench", "generated", "player"} & {name.partition("/")[0] for name in plain} == set()
    same = plain.keys() - {"CMakeLists.txt"}
    assert {name: plain[name] for name in same} == {name: ecocontrol()[name] for name in same}


def test_sources_of_a_function_share_no_unit_where_others_are_joined():
    """Each may have a static function, or a macro, of the same name."""
    text = ecocontrol()["CoreAccExecutable/CMakeLists.txt"]
    assert "set_target_properties(core_acc_core PROPERTIES UNITY_BUILD OFF)" in text


PLATFORM = "-DPLATFORM_TARGETS=vendor"
"""Targets of a platform; CMake does not ask for them before it links."""


@cmake
@pytest.mark.parametrize(
    ("is_plain", "settings", "uses_bench"),
    [(False, (), True), (False, (PLATFORM,), False), (False, ("-DBENCH=OFF",), False), (True, (PLATFORM,), False), (True, (), False)],
    ids=["bench", "bench and a platform", "bench switched off", "plain over a bench, with a platform", "plain over a bench"],
)  # fmt: skip
def test_a_platform_that_is_given_is_the_one_that_is_used(is_plain, settings, uses_bench, tmp_path):
    write(ecocontrol(), tmp_path)
    if is_plain:
        write(files(ECOCONTROL.read_bytes()), tmp_path)
    quick = (
        "-DCMAKE_C_COMPILER_WORKS=1",
        "-DCMAKE_CXX_COMPILER_WORKS=1",
        *(f"-D{name}={path}" for name, path in CODE.items()),
    )
    done = subprocess.run(
        ["cmake", "-S", tmp_path, "-B", tmp_path / "build", *quick, *settings], capture_output=True, text=True, check=False
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "build/bench").exists() == uses_bench


def test_an_adapter_uses_names_of_ara_and_of_the_standard_library_alone():
    adapters = "".join(text for name, text in full().items() if re.match(r"\w+Executable/.*\.(h|cpp)$", name))
    included = {name.partition("/")[0] for name in re.findall(r'#include "(.*)"', adapters)}
    assert included == {"application", "ara", "core", "full", "full_adapter.h", "full_structs.h"}
    assert "bench" not in set(re.findall(r"\b(\w+)::", adapters))


def test_all_that_a_declaration_can_say_reaches_the_core():
    adapter = full()["FullExecutable/full_adapter.cpp"]
    for called in ("Init", "Start", "NextCall", "NextTime", "SetInput_Step", "Begin_Step", "Run_Step", "GetOutput_Step",
                   "Supervise", "Published", "Terminate", "Receive_Speed", "Reject_Speed", "Receive_Stop", "Receive_Mode_In",
                   "Method_Do", "Answer_Ask"):  # fmt: skip
        assert f"Full_Adapter_{called}(&core_" in adapter, called


def test_only_a_signal_that_triggers_a_call_wakes_it():
    connects = full()["FullExecutable/full_adapter.cpp"].partition("::Connect(")[2]
    assert connects.count("clock_->Wake();") == 1


def test_what_another_call_of_the_function_takes_does_not_go_over_the_network():
    adapter = full()["FullExecutable/full_adapter.cpp"]
    assert "Full_Adapter_Receive_AccBack(&core_, out.Acc, clock_->Now());" in adapter


def test_only_a_call_that_no_mode_excludes_reports_to_the_health_management():
    assert "supervision_.ReportCheckpoint(Checkpoint::kFull_Step);" in full()["FullExecutable/full_adapter.cpp"]
    assert "PHM-SUPERVISED-ENTITY-INTERFACE" in full()["arxml/components.arxml"]
    assert "ReportCheckpoint" not in ecocontrol()["CoreAccExecutable/core_acc_adapter.cpp"]
    assert "PHM-SUPERVISED-ENTITY-INTERFACE" not in ecocontrol()["arxml/components.arxml"]


def body(adapter, function):
    """The statements of a function."""
    return adapter.partition(f"::{function}(")[2].partition("\n}\n")[0]


def test_no_method_runs_while_the_function_ends():
    stop = body(full()["FullExecutable/full_adapter.cpp"], "Stop")
    steps = [
        "thread_.join();",
        "fullService_.StopOfferService();",
        "call{call_mutex_};",
        "Full_Adapter_Terminate(",
        "Publish();",
    ]
    assert steps == sorted(steps, key=stop.index)


def test_a_service_without_methods_tells_what_comes_of_the_end():
    stop = body(ecocontrol()["CoreAccExecutable/core_acc_adapter.cpp"], "Stop")
    steps = ["CoreAcc_Adapter_Terminate(", "Publish();", "coreAccService_.StopOfferService();"]
    assert steps == sorted(steps, key=stop.index)


def test_each_parameter_is_read_from_its_storage_under_the_name_of_its_element():
    made = storing()
    adapter = made["StoringExecutable/storing_adapter.cpp"]
    read = re.findall(r'storage_(\w+)_\.Read(?:Counts)?\("(\w+)"', adapter)
    assert read == [
        ("Adapter", "IgnitionCycle"), ("Adapter", "Storing_Late_ErrorSts"), ("Parameters", "IgnitionCycle"),
        ("Parameters", "Plain"), ("CalA", "Gain"), ("CalB", "Gain"),
    ]  # fmt: skip
    assert re.findall(r"storage_(\w+)_\.Save", adapter) == ["Parameters", "Adapter"]
    elements = {
        (storage.findtext("{*}SHORT-NAME"), element.findtext("{*}SHORT-NAME"))
        for storage in ET.fromstring(made["arxml/components.arxml"]).iterfind(
            ".//{*}PERSISTENCY-KEY-VALUE-STORAGE-INTERFACE"
        )
        for element in storage.iterfind(".//{*}PERSISTENCY-DATA-ELEMENT")
    }
    assert {(f"Storing_{storage}", key) for storage, key in read} - {
        ("Storing_Adapter", "Storing_Late_ErrorSts")
    } <= elements
    for storage in ("Adapter", "Parameters", "CalA", "CalB"):
        assert f'storage_{storage}_{{"StoringExecutable/Storing_Root/{storage}", logger_}}' in adapter


def test_a_document_without_its_functions_is_refused():
    document = json.loads(ECOCONTROL.read_bytes())
    del document["SourceFunctionList"]
    (finding,) = refused(document)
    assert (finding.rule, finding.pointer) == ("A020", "/SourceFunctionList")


@pytest.mark.parametrize("name", ["application", "Core", "test", "player"])
def test_no_executable_has_the_name_of_a_folder_or_a_target_of_the_application(name):
    document = json.loads(ECOCONTROL.read_bytes())
    document["ComponentList"][0]["ExecutableName"] = name
    (finding,) = refused(document)
    assert (finding.rule, finding.pointer) == ("A020", "/ComponentList/0/ExecutableName")
    assert name in finding.message


def test_a_request_that_is_not_answered_returns_an_application_error_that_the_arxml_has():
    answer = body(full()["FullExecutable/full_adapter.cpp"], "AnswerDo")
    refused = re.findall(r"reply == (\w+)\)|MakeErrorCode\(::full::FunctionMethodErrc::(\w+), 0\)", answer)
    assert refused == [("SIGCAT_OK", ""), ("SIGCAT_EXCLUDED", ""), ("", "kExcluded"), ("", "kBadArgument")]
    interfaces = ET.fromstring(full()["arxml/interfaces.arxml"])
    errors = {
        error.findtext("{*}SHORT-NAME"): (error.findtext("{*}ERROR-CODE"), error.findtext("{*}ERROR-DOMAIN-REF"))
        for error in interfaces.iterfind(".//{*}AP-APPLICATION-ERROR")
    }
    domain = "/Full/ApplicationErrors/FunctionMethod"
    assert errors == {"kExcluded": ("1", domain), "kBadArgument": ("2", domain)}
    for operation in interfaces.iterfind(".//{*}CLIENT-SERVER-OPERATION"):
        possible = [each.text for each in operation.iterfind(".//{*}POSSIBLE-AP-ERROR-REF")]
        assert possible == ["/Full/ApplicationErrors/kExcluded", "/Full/ApplicationErrors/kBadArgument"]


def test_a_parameter_of_the_function_that_the_component_does_not_list_is_told():
    document = json.loads(ECOCONTROL.read_bytes())
    parameter = document["ComponentList"][0]["ParameterList"][0]
    variable, parameter["Variable"] = parameter["Variable"], "core_params.other"
    (finding,) = refused(document)
    assert (finding.rule, finding.pointer) == ("A020", "/ComponentList/0/ParameterList")
    assert variable in finding.message


_LOGGER = "namespace ara { namespace log { class Logger; } }\n"
_CREATE = "namespace ara { namespace log { Logger& CreateLogger(const char*); } }\n"


@pytest.mark.parametrize("compiler", CPP_COMPILERS)
@pytest.mark.parametrize(
    "headers", [{"logger.h": _LOGGER + _CREATE}, {"logger.h": _LOGGER, "logging.h": _CREATE}], ids=["one", "two"]
)
def test_create_logger_is_found_beside_the_logger_or_in_a_header_of_its_own(headers, compiler, tmp_path):
    folder = tmp_path / "ara/log"
    folder.mkdir(parents=True)
    for name, text in headers.items():
        (folder / name).write_text(f"#pragma once\n{text}")
    write(full(), tmp_path / "made")
    used = '#include "application/log.h"\nara::log::Logger& Here();\nara::log::Logger& Here() { return ara::log::CreateLogger("x"); }\n'
    (tmp_path / "here.cpp").write_text(used)
    command = [
        *compiler,
        *STRICT,
        "-std=c++14",
        f"-I{tmp_path}",
        f"-I{tmp_path / 'made'}",
        "-c",
        "here.cpp",
        "-o",
        "here.o",
    ]
    subprocess.run(command, cwd=tmp_path, check=True)


@pytest.mark.parametrize("release", ["R20-11", "R21-11", "R22-11"])
def test_the_sources_are_of_no_release_whose_api_they_do_not_use(release):
    document = json.loads(ECOCONTROL.read_bytes())
    document["Deployment"]["Release"] = release
    (finding,) = refused(document)
    assert (finding.rule, finding.pointer) == ("A020", "/Deployment/Release")
    assert f"sigcat generate arxml --release {release}" in finding.fix
    with pytest.raises(InputRefused):
        generate(ECOCONTROL.read_bytes(), "integration.json", DEFAULT_LIMITS, release)


def test_the_sources_are_the_same_for_each_of_their_releases():
    made = [
        generate(ECOCONTROL.read_bytes(), "integration.json", DEFAULT_LIMITS, release) for release in SOURCE_RELEASES
    ]
    sources = [{file.name: file.data for file in each if not file.name.startswith("arxml/")} for each in made]
    assert sources[0] == sources[1]


def test_a_function_has_one_component():
    document = json.loads(ECOCONTROL.read_bytes())
    document["ComponentList"][1]["Function"] = "CoreAcc"
    (finding,) = refused(document)
    assert (finding.pointer, "CoreAcc must have one component" in finding.message) == (
        "/ComponentList/1/Function",
        True,
    )


def test_the_report_says_what_is_not_left_to_the_platform():
    entries = report(ECOCONTROL.read_bytes(), "integration.json", DEFAULT_LIMITS)
    (alive,) = [each for each in entries if each.field == "SupervisionType Alive"]
    assert (alive.interface, alive.target) == ("CoreAcc_Step", "core")
    assert "not exported to ara::phm" in alive.note


def test_the_report_names_the_function_that_runs_a_call_with_any_name():
    renamed = ECOCONTROL.read_bytes().replace(b"CoreAcc_Step", b"CoreAcc_Step_Fast")
    entries = report(renamed, "integration.json", DEFAULT_LIMITS)
    (cycle,) = [each for each in entries if (each.interface, each.field) == ("CoreAcc_Step_Fast", "CycleTime")]
    assert cycle.target == "CoreAccExecutable: RunStep_Fast"
    adapter = files(renamed)["CoreAccExecutable/core_acc_adapter.h"]
    assert "void RunStep_Fast();" in adapter


def test_three_executables_with_162_events_are_three_programs_and_a_player(tmp_path):
    folder = large_set.write_set(tmp_path)
    catalogue = read_catalogue(folder / "tree.vspec")
    sources = [(path.read_bytes(), path.name) for path in sorted(folder.glob("*.yaml"))]
    functions, _ = read_functions(sources, catalogue)
    document = integrate(PLATFORMS["autosar-adaptive"], functions).document
    made = files(document, bench=True)
    assert sum(name.endswith("/main.cpp") for name in made) == 3 + 1


def test_the_player_begins_with_the_status_that_the_function_begins_with_itself():
    ports = re.sub(r"\s+", "", full()["player/ports.cpp"])
    for field, status in {
        "Full_Mode_In": "DT_FullModeIn::ON",
        "Stop_SftyCondSts": "DT_FullSftyCondSts::ACTIVE",
    }.items():
        assert re.search(rf"{field}\.Update\([\w:]*{status}\)", ports), field


# -- compilers ----------------------------------------------------------------------------------------------------


each_compiler = pytest.mark.parametrize(
    "compiler", [pytest.param(each, marks=slow if at else (), id=each[-1]) for at, each in enumerate(CPP_COMPILERS)]
)


def compiled(compiler, source, folder, *options):
    """Compile a source strictly, below a folder of generated files."""
    kind = ("-c", "-o", "compiled.o") if IS_SLOW_RUN else ("-fsyntax-only",)
    includes = ("-I.", "-Igenerated/include", "-Ibench/include")
    command = [*compiler, "-std=c++17", *STRICT, *includes, *options, *kind, source]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


@each_compiler
def test_no_compiler_warns_of_an_adapter_with_everything(compiler, tmp_path):
    write(full(), tmp_path)
    for source in ("FullExecutable/full_adapter.cpp", "FullExecutable/main.cpp", "player/ports.cpp"):
        compiled(compiler, source, tmp_path, f"-I{FULL}")


def test_headers_may_stand_in_one_folder_as_some_generators_write_them(tmp_path):
    document = json.loads(full_integration())
    document["Deployment"]["HeaderFolders"] = "none"
    made = files(json.dumps(document).encode(), bench=True)
    headers = [name for name in made if name.endswith(("_proxy.h", "_skeleton.h", "_common.h"))]
    assert {name.rpartition("/")[0] for name in headers} == {"generated/include"}
    write(made, tmp_path)
    for source in ("FullExecutable/full_adapter.cpp", "FullExecutable/main.cpp", "player/ports.cpp"):
        compiled(CPP_COMPILERS[0], source, tmp_path, f"-I{FULL}")


@each_compiler
def test_no_compiler_warns_of_adapters_with_little_and_of_names_that_are_easily_taken(compiler, tmp_path):
    write(small(), tmp_path)
    adapters = [name for name in small() if name.endswith("_adapter.cpp")]
    assert len(adapters) == len(list(SMALL.glob("*.yaml")))
    skeletons = [name for name in small() if name.endswith("_skeleton.cpp")]
    included = [option for name in (*adapters, *skeletons) for option in ("-include", name)]
    compiled(compiler, "player/ports.cpp", tmp_path, f"-I{SMALL}", *included)


def test_services_may_have_the_names_of_members_and_of_keywords(tmp_path):
    document = full_integration().decode()
    services = sorted({
        each["Name"] for part in json.loads(document)["ComponentList"] for each in part["ServiceInterfaceList"]
    })  # fmt: skip
    for service, name in zip(services, ("Logger", "Clock", "Thread", "Core_mutex", "Class", "Switch"), strict=False):
        document = document.replace(f'"{service}"', f'"{name}"')
    write(files(document.encode(), bench=True), tmp_path)
    for source in ("FullExecutable/full_adapter.cpp", "player/ports.cpp"):
        compiled(CPP_COMPILERS[0], source, tmp_path, f"-I{FULL}")
