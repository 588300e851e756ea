"""Tests by real parts that take minutes: `make real` runs them, and `make test` one or a few that stand for each kind.

Whatever stands at the places of a kind is marked `real`, but for its representatives. So every test is run by `-m real` or by
`-m "not real"`, and none by both. Without either, pytest runs what it is told to.
"""

from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

USUAL, REAL = "not real", "real"
"""What `make test` and `make real` say to `pytest -m`."""
_ROOT = Path(__file__).parents[1]


TIMES = "times and memory, and how they grow"
"""The kind of tests that depend on the speed of the machine."""


class Kind(NamedTuple):
    """Real parts of one kind."""

    title: str
    """What its tests do, in the line that says what was left out."""
    places: tuple[str, ...]
    """Folders, files, tests, and with a star at the end all tests whose names begin so."""
    representatives: tuple[str, ...]
    """Tests at these places that every run has: with all their cases, or one case of one. None where times are compared."""


KINDS = (
    Kind(
        TIMES,
        (
            "tests/catalogue/comparing/test_compare.py::test_ten_times_the_signals_take_about_ten_times_as_long",
            "tests/catalogue/comparing/test_official_releases.py::test_it_takes_less_time_than_to_read_one_of_them",
            "tests/function/test_define.py::test_ten_times_the_definitions_take_about_ten_times_as_long",
            "tests/function/test_document.py::test_unterminated_texts_are_refused_in_linear_time",
            "tests/function/test_hostile.py::test_aliases_that_multiply_cost_no_more_than_a_megabyte_of_text",
            "tests/function/test_hostile.py::test_ten_times_the_bytes_of_anything_take_about_ten_times_as_long",
            "tests/function/test_hostile.py::test_ten_times_the_calls_are_put_in_order_in_about_ten_times_the_time",
            "tests/function/test_hostile.py::test_ten_times_the_signals_are_built_in_about_ten_times_the_time",
            "tests/function/test_hostile.py::test_ten_times_the_signals_are_validated_in_about_ten_times_the_time",
            "tests/function/test_hostile.py::test_ten_times_the_wrong_signals_are_told_in_about_ten_times_the_time",
            "tests/function/test_sets.py::test_ten_times_the_functions_take_about_ten_times_as_long",
            "tests/integration/autosar_adaptive/test_refused.py::test_ten_times_the_signals_take_about_ten_times_as_long",
            "tests/integration/autosar_classic/test_derive.py::test_ten_times_the_signals_take_about_ten_times_as_long",
            "tests/integration/ros2/test_bad_input.py::test_ten_times_the_signals_take_about_ten_times_as_long",
            "tests/integration/ros2/test_bad_input.py::test_ten_times_the_text_takes_about_ten_times_as_long",
            "tests/comparison/running/test_launch.py::test_a_process_that_records_nothing_any_more_is_ended_and_told_as_hanging",
            "tests/comparison/running/test_launch.py::test_a_process_that_records_slowly_has_all_its_time",
            "tests/test_bench.py::test_a_catalogue_takes_no_more_than_six_times_its_json",
        ),
        (),
    ),
    Kind(
        "nodes in real ROS 2",
        (
            "tests/adapter/ros2/test_bringup.py::test_the_launch_file_is_as_ament_flake8_wants_it",
            "tests/adapter/ros2/test_composition.py",
            "tests/adapter/ros2/test_conditions.py",
            "tests/adapter/ros2/test_cyclonedds.py",
            "tests/adapter/ros2/test_derived.py",
            "tests/adapter/ros2/test_end.py",
            "tests/adapter/ros2/test_environment.py",
            "tests/adapter/ros2/test_exceptions.py",
            "tests/adapter/ros2/test_free_running.py",
            "tests/adapter/ros2/test_interfaces.py::test_rosidl_reads_every_field_with_its_unit",
            "tests/adapter/ros2/test_life.py",
            "tests/adapter/ros2/test_liveliness.py",
            "tests/adapter/ros2/test_lock_step.py",
            "tests/adapter/ros2/test_parameters.py",
            "tests/adapter/ros2/test_played.py",
            "tests/adapter/ros2/test_python_methods.py",
            "tests/adapter/ros2/test_python_nodes.py",
            "tests/adapter/ros2/test_python_package.py::test_the_linters_of_ros_find_nothing",
            "tests/adapter/ros2/test_scheduling.py",
            "tests/adapter/ros2/test_style.py",
            "tests/adapter/ros2/test_topics.py",
        ),
        (
            "tests/adapter/ros2/test_bringup.py::test_the_launch_file_is_as_ament_flake8_wants_it[small]",
            "tests/adapter/ros2/test_environment.py::test_rclpy_starts",
            "tests/adapter/ros2/test_interfaces.py::test_rosidl_reads_every_field_with_its_unit[ecocontrol]",
            "tests/adapter/ros2/test_python_package.py::test_the_linters_of_ros_find_nothing[ament_pep257]",
        ),
    ),
    Kind(
        "attacks in the text of documents",
        (
            "tests/adapter/test_hostile_text.py",
            "tests/adapter/hostile/test_cmake_runs_no_text.py::test_text_calls_no_command",
            "tests/adapter/hostile/test_cmake_runs_no_text.py::test_values_of_types_call_no_command",
            "tests/adapter/hostile/test_dangerous_values.py",
            "tests/adapter/hostile/test_every_field_refuses.py::test_every_field_refuses_it_at_every_door",
            "tests/adapter/hostile/test_function_yaml.py::test_it_is_refused_or_no_code",
        ),
        (
            "tests/adapter/hostile/test_cmake_runs_no_text.py::test_text_calls_no_command[autosar-classic]",
            "tests/adapter/hostile/test_dangerous_values.py::test_no_value_of_a_type_becomes_code[function-json]",
            "tests/adapter/hostile/test_every_field_refuses.py::test_every_field_refuses_it_at_every_door[deployment-*",
            "tests/adapter/hostile/test_function_yaml.py::test_it_is_refused_or_no_code['x; EVIL_code']",
            "tests/adapter/test_hostile_text.py::test_free_text_never_becomes_code[0-autosar-classic]",
            "tests/adapter/test_hostile_text.py::test_free_text_never_becomes_code[2-ros2]",
            "tests/adapter/test_hostile_text.py::test_free_text_never_becomes_code[10-autosar-adaptive]",
        ),
    ),
    Kind(
        "every page in a browser",
        ("tests/web/in_browser",),
        (
            "tests/web/in_browser/test_accessibility.py::test_axe_finds_nothing[/search/small?q=speed]",
            "tests/web/in_browser/test_flows.py::test_branches_are_opened_and_nodes_selected",
            "tests/web/in_browser/test_layout.py::test_nothing_sticks_out_sideways[/search/interfaces?q=wheel]",
            "tests/web/in_browser/test_search.py",
            "tests/web/in_browser/test_service.py",
        ),
    ),
    Kind(
        "applications over SOME/IP",
        (
            "tests/adapter/autosar_adaptive/application/test_e2e.py",
            "tests/adapter/autosar_adaptive/application/test_generate.py::test_a_platform_that_is_given_is_the_one_that_is_used",
            "tests/adapter/autosar_adaptive/application/test_generate.py::test_headers_may_stand_in_one_folder_as_some_generators_write_them",
            "tests/adapter/autosar_adaptive/application/test_generate.py::test_no_compiler_warns_of_adapters_with_little_and_of_names_that_are_easily_taken",
            "tests/adapter/autosar_adaptive/application/test_generate.py::test_no_compiler_warns_of_an_adapter_with_everything",
            "tests/adapter/autosar_adaptive/application/test_generate.py::test_services_may_have_the_names_of_members_and_of_keywords",
            "tests/adapter/autosar_adaptive/application/test_life.py",
            "tests/adapter/autosar_adaptive/application/test_recorder.py",
            "tests/adapter/autosar_adaptive/application/test_run.py",
            "tests/adapter/autosar_adaptive/application/test_threads.py::test_a_slow_call_does_not_block_an_urgent_one_and_threads_are_in_order",
            "tests/adapter/autosar_adaptive/application/test_threads.py::test_a_state_that_is_protected_is_sent_at_once_and_again_with_each_call",
            "tests/adapter/autosar_adaptive/application/test_threads.py::test_a_state_that_is_protected_reaches_another_function_early_and_late",
            "tests/adapter/autosar_adaptive/bench/test_discovery.py",
            "tests/adapter/autosar_adaptive/bench/test_e2e.py",
            "tests/adapter/autosar_adaptive/bench/test_hostile.py",
            "tests/adapter/autosar_adaptive/bench/test_pysomeip.py",
            "tests/adapter/autosar_adaptive/bench/test_recovery.py",
            "tests/adapter/autosar_adaptive/bench/test_runtime.py",
            "tests/adapter/autosar_adaptive/bench/test_serialization.py",
            "tests/adapter/autosar_adaptive/bench/test_services.py",
            "tests/adapter/autosar_adaptive/bench/test_stamps.py",
        ),
        (
            "tests/adapter/autosar_adaptive/application/test_generate.py::test_no_compiler_warns_of_adapters_with_little_and_of_names_that_are_easily_taken",
            "tests/adapter/autosar_adaptive/bench/test_services.py::test_events_of_every_datatype_arrive",
        ),
    ),
    Kind(
        "components on the test RTE",
        ("tests/adapter/autosar_classic/test_test_rte.py",),
        (
            "tests/adapter/autosar_classic/test_test_rte.py::test_every_bit_is_that_of_the_simulation[one_function_feeds_another]",
        ),
    ),
    Kind(
        "changed documents, compiled for every platform",
        (
            "tests/adapter/test_mutated.py::test_what_is_generated_of_a_changed_function_is_compiled",
            "tests/adapter/test_mutated.py::test_what_is_generated_of_a_changed_integration_is_compiled",
        ),
        (
            "tests/adapter/test_mutated.py::test_what_is_generated_of_a_changed_function_is_compiled[autosar-classic-time_outs-drawn 0]",
            "tests/adapter/test_mutated.py::test_what_is_generated_of_a_changed_integration_is_compiled[autosar-classic-time_outs-drawn 0]",
        ),
    ),
    Kind(
        "drives played to every platform",
        ("tests/comparison/running/test_platforms.py", "tests/comparison/test_can_drive.py"),
        (
            "tests/comparison/running/test_platforms.py::test_what_is_missing_is_told_in_one_line",
            "tests/comparison/test_can_drive.py::test_a_log_is_the_drive_that_it_was_recorded_from",
        ),
    ),
    Kind(
        "attacks on a service",
        ("tests/api/test_attacks.py", "tests/api/test_hostile_requests.py", "tests/api/test_work_attacks.py"),
        (
            "tests/api/test_hostile_requests.py::test_a_body_that_drips_is_refused",
            "tests/api/test_hostile_requests.py::test_no_address_in_a_request_is_ever_asked",
        ),
    ),
    Kind(
        "the most expensive requests of every operation and page",
        ("tests/api/test_event_loop.py",),
        (
            "tests/api/test_event_loop.py::test_every_route_has_its_most_expensive_requests",
            "tests/api/test_event_loop.py::test_the_loop_goes_on_meanwhile[POST /try]",
        ),
    ),
    Kind(
        "every operation with requests of any kind",
        ("tests/api/test_contract.py",),
        ("tests/api/test_contract.py::test_every_operation_answers_as_its_schema_says[GET /api/v1/catalogues]",),
    ),
    Kind(
        "services that are started, stopped and killed",
        (
            "tests/api/test_export_processes.py",
            "tests/api/test_logged_once.py",
            "tests/api/test_running.py",
            "tests/api/test_several_workers.py::test_metrics_are_the_total_of_all_workers",
            "tests/api/test_tracing.py::test_requests_are_spans_of_the_trace_that_their_client_names",
            "tests/catalogue/hosting/test_killed.py",
        ),
        (
            "tests/api/test_logged_once.py::test_sighup_reads_files_again_and_is_logged",
            "tests/api/test_export_processes.py::test_an_export_has_the_bytes_of_a_process_of_its_own[csv]",
            "tests/api/test_running.py::test_each_request_is_a_line_of_json_with_the_id_that_its_problem_carries",
        ),
    ),
    Kind(
        "trees and exports beside those of vss-tools",
        (
            "tests/api/test_openapi.py::test_every_example_works_and_is_answered_as_the_schema_says[export_*",
            "tests/catalogue/exporting/test_same_bytes.py",
            "tests/catalogue/exporting/test_stopping.py::test_every_public_overlay_that_vss_tools_exports_is_exported",
            "tests/catalogue/test_official_trees.py",
            "tests/catalogue/test_shipped_tree.py::test_vss_tools_takes_it_without_a_complaint",
            "tests/function/test_define.py::test_vss_tools_takes_the_overlay_and_the_types_strictly",
            "tests/overlays/test_overlays.py::test_vss_tools_takes_all_of_them_strictly_and_sees_the_same_nodes",
        ),
        (
            "tests/api/test_openapi.py::test_every_example_works_and_is_answered_as_the_schema_says[export_csv]",
            "tests/api/test_openapi.py::test_every_example_works_and_is_answered_as_the_schema_says[export_json]",
            "tests/catalogue/exporting/test_same_bytes.py::test_a_tree_with_everything[json -e ASILlevel]",
            "tests/catalogue/exporting/test_same_bytes.py::test_a_tree_with_everything[csv -e ASILlevel]",
        ),
    ),
    Kind(
        "commands as pages, hooks and an installed package run them",
        (
            "tests/cli/test_pre_commit.py",
            "tests/documentation/test_commands.py",
            "tests/test_generated.py::test_it_is_up_to_date[shown_outputs]",
            "tests/test_installed.py",
        ),
        ("tests/documentation/test_commands.py::test_pages_show_commands",),
    ),
    Kind(
        "27,000 random formulas",
        (
            "tests/catalogue/network/test_formula_judge.py::test_random_formulas_have_the_values_of_the_judge",
            "tests/catalogue/network/test_formula_judge.py::test_very_many_random_formulas_have_the_values_of_the_judge",
        ),
        ("tests/catalogue/network/test_formula_judge.py::test_random_formulas_have_the_values_of_the_judge",),
    ),
    Kind(
        "linters of others that take long",
        (
            "tests/adapter/autosar_adaptive/application/test_misra_cpp.py::test_the_adapter_of_a_function_with_everything_has_documented_deviations_alone",
            "tests/adapter/autosar_adaptive/application/test_misra_cpp.py::test_threads_and_watches_have_documented_deviations_alone",
            "tests/adapter/autosar_classic/test_components.py::test_cppcheck_finds_documented_deviations",
            "tests/adapter/core/test_strict.py::test_cppcheck_finds_documented_deviations_in_examples",
            "tests/clients/test_clients.py::test_the_document_passes_the_strict_rules_of_redocly",
        ),
        (
            "tests/adapter/autosar_adaptive/application/test_misra_cpp.py::test_threads_and_watches_have_documented_deviations_alone",
            "tests/adapter/autosar_classic/test_components.py::test_cppcheck_finds_documented_deviations[methods]",
        ),
    ),
    Kind(
        "functions compiled and run",
        (
            "tests/adapter/core/test_equivalence.py",
            "tests/examples/test_sources.py::test_every_build_compiles_without_a_warning_and_answers_with_the_same_bits[cc-*",
            "tests/examples/test_sources.py::test_every_build_compiles_without_a_warning_and_answers_with_the_same_bits[clang-*",
            "tests/adapter/autosar_classic/test_components.py::test_no_compiler_warns",
            "tests/runs/test_converting.py::test_a_run_is_written_alike",
            "tests/runs/test_simulate.py",
        ),
        (
            "tests/adapter/autosar_classic/test_components.py::test_no_compiler_warns[ecocontrol-*",
            "tests/adapter/autosar_classic/test_components.py::test_no_compiler_warns[everything-*",
            "tests/adapter/autosar_classic/test_components.py::test_no_compiler_warns[protected structs, events, methods and modes-*",
            "tests/adapter/core/test_equivalence.py::test_functions_for_each_subject[conversions]",
            "tests/runs/test_converting.py::test_a_run_is_written_alike[every_datatype_with_all_its_digits]",
            "tests/runs/test_converting.py::test_a_run_is_written_alike[structs_and_queues]",
            "tests/runs/test_simulate.py::test_an_init_that_crashes_is_told",
            "tests/runs/test_simulate.py::test_the_drive_of_the_examples_goes_as_it_was_recorded",
            "tests/runs/test_simulate.py::test_what_functions_keep_is_in_a_file_that_the_next_run_reads",
            "tests/runs/test_simulate.py::test_what_the_declaration_says_of_the_code_and_is_not_so",
        ),
    ),
)


def note(item: pytest.Item) -> None:
    """Mark a test that `make test` leaves out."""
    if is_at(item.nodeid, _places()) and not is_at(item.nodeid, _representatives()):
        item.add_marker("real")


def has_none(path: Path, wanted: str) -> bool:
    """Whether a file or folder has no test of those that are wanted: then it need not be read."""
    name = path.relative_to(_ROOT).as_posix()
    if wanted == USUAL:
        return is_at(name, _places()) and not _are_below(name, _representatives())
    return wanted == REAL and not is_at(name, _places()) and not _are_below(name, _places())


def missing(items: Iterable[pytest.Item]) -> Sequence[str]:
    """Representatives that are not among the tests of their files, which were collected whole."""
    files: dict[str, list[str]] = {}
    for item in items:
        files.setdefault(_file(item.nodeid), []).append(item.nodeid)
    return [
        each
        for each in _representatives()
        if _file(each) in files and not any(is_at(name, (each,)) for name in files[_file(each)])
    ]


def left_out(wanted: str) -> str:
    """What a run has left out, and how to get it, in one line."""
    return f"left out: {', '.join(kind.title for kind in KINDS)}; `make real` runs these" if wanted == USUAL else ""


@cache
def _places() -> tuple[str, ...]:
    return tuple(place for kind in KINDS for place in kind.places)


@cache
def _representatives() -> tuple[str, ...]:
    return tuple(each for kind in KINDS for each in kind.representatives)


def _file(name: str) -> str:
    return name.partition("::")[0]


def is_at(name: str, places: tuple[str, ...]) -> bool:
    """Whether something is one of some places, or below it."""
    return name in places or name.startswith(_beginnings(places))


@cache
def _beginnings(places: tuple[str, ...]) -> tuple[str, ...]:
    """Beginnings of names below places; every test is compared with them."""
    return tuple(each for place in places for each in _beginnings_of(place))


def _beginnings_of(place: str) -> tuple[str, ...]:
    return (place[:-1],) if place.endswith("*") else (f"{place}/", f"{place}::", f"{place}[")


def _are_below(name: str, places: Iterable[str]) -> bool:
    """Whether any place is what has the name, or below that."""
    return any(is_at(place, (name,)) for place in places)
