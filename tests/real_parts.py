"""Tests by real parts that take minutes: `make real` runs them, and `make test` one or a few that represent each kind.

All tests at the places of a kind are marked `real`, except its representatives. So every test is run by `-m real` or by
`-m "not real"`, and none by both. Without either, pytest runs the given tests.
"""

from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

USUAL, REAL = "not real", "real"
"""Arguments of `make test` and `make real` for `pytest -m`."""
_ROOT = Path(__file__).parents[1]


TIMES = "times and memory, and how they grow"
"""The kind of tests that depend on the speed of the machine."""


class Kind(NamedTuple):
    """Real parts of one kind."""

    title: str
    """Subject of its tests, in the line about omitted tests."""
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
            "tests/adapter/ros2/test_growth.py",
            "tests/integration/ros2/test_bad_input.py::test_ten_times_the_signals_take_about_ten_times_as_long",
            "tests/integration/ros2/test_bad_input.py::test_ten_times_the_text_takes_about_ten_times_as_long",
            "tests/comparison/running/test_launch.py::test_a_process_that_records_nothing_any_more_is_ended_and_told_as_hanging",
            "tests/comparison/running/test_launch.py::test_a_process_that_records_slowly_has_all_its_time",
            "tests/test_bench.py::test_a_catalogue_takes_no_more_than_six_times_its_json",
            "tests/gateway/test_damaged_logs.py::test_a_log_of_any_size_takes_the_same_memory",
            "tests/catalogue/hosting/test_archive.py::test_a_bomb_is_refused_before_half_of_it_is_unpacked_and_in_little_memory",
            "tests/web/test_forms.py::test_many_escapes_are_read_in_little_memory",
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
            "tests/function/test_faulty_catalogue.py::test_a_wrong_value_of_the_catalogue_is_no_error_of_sigcat",
            "tests/adapter/hostile/test_function_yaml.py::test_it_is_refused_or_no_code",
            "tests/adapter/hostile/test_payloads.py::test_a_payload_is_a_finding_at_its_field",
            "tests/adapter/hostile/test_function_yaml.py::test_fields_of_other_signatures_refuse_it",
            "tests/adapter/hostile/test_large_numbers.py::test_a_declaration_with_one_is_refused[negative]",
            "tests/adapter/hostile/test_large_numbers.py::test_json_with_one_is_refused_by_every_generator",
            "tests/adapter/hostile/test_reserved_words.py::test_a_core_with_signals_and_parameters_of_all_these_names_compiles",
            "tests/web/test_sets.py::test_whatever_is_posted_shows_as_text",
            "tests/web/test_try_overlay.py::test_any_text_has_a_page",
            "tests/function/importing/test_hostile_code.py::test_macros_that_multiply_are_stopped",
            "tests/function/importing/test_hostile_code.py::test_unbalanced_and_endless_code_is_survived",
            "tests/gateway/test_damaged_logs.py::test_any_bytes_are_a_log_or_are_told",
            "tests/rules/linting/test_input_of_any_kind.py::test_values_of_any_kind_at_any_place_never_end_a_lint",
            "tests/adapter/test_classic_arxml.py::test_a_document_that_is_wrong_somewhere_is_refused_with_findings_or_gives_files_that_are_right",
        ),
        (
            "tests/adapter/hostile/test_dangerous_values.py::test_no_value_of_a_type_becomes_code[fmi]",
            "tests/adapter/hostile/test_every_field_refuses.py::test_every_field_refuses_it_at_every_door[deployment-*",
            "tests/adapter/test_hostile_text.py::test_free_text_never_becomes_code[0-autosar-classic]",
            "tests/adapter/hostile/test_payloads.py::test_a_payload_is_a_finding_at_its_field[function-json/Code/*",
            "tests/adapter/hostile/test_function_yaml.py::test_fields_of_other_signatures_refuse_it[member]",
            "tests/adapter/hostile/test_large_numbers.py::test_json_with_one_is_refused_by_every_generator[function-json-*",
            "tests/adapter/hostile/test_reserved_words.py::test_a_core_with_signals_and_parameters_of_all_these_names_compiles[c]",
            "tests/web/test_sets.py::test_whatever_is_posted_shows_as_text[</textarea><script>alert(1)</script>]",
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
            "tests/adapter/autosar_adaptive/application/test_speed.py",
            "tests/adapter/autosar_adaptive/application/test_threads.py::test_no_compiler_warns_of_the_threads",
            "tests/adapter/autosar_adaptive/application/test_threads.py::test_threads_that_are_measured_are_in_order",
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
        (
            "tests/comparison/running/test_optional_signals.py",
            "tests/comparison/running/test_platforms.py",
            "tests/comparison/test_can_drive.py",
            "tests/comparison/test_command.py",
            "tests/comparison/test_ended.py",
            "tests/players/test_cmake.py",
        ),
        (
            "tests/comparison/running/test_platforms.py::test_what_is_missing_is_told_in_one_line",
            "tests/players/test_cmake.py::test_a_copy_of_a_folder_is_built_where_it_is",
            "tests/comparison/test_command.py::test_functions_take_turns_by_their_names_on_every_platform",
        ),
    ),
    Kind(
        "attacks on a service",
        (
            "tests/api/test_attacks.py",
            "tests/api/test_hostile_requests.py",
            "tests/api/test_work_attacks.py",
            "tests/api/test_connections.py::test_of_many_answers_that_wait_the_one_left_longest_is_cut_off",
            "tests/api/test_connections.py::test_what_is_no_request_is_a_problem_with_an_id_and_a_line_in_the_log[half a head*",
            "tests/api/test_connections.py::test_a_client_that_leaves_is_no_failure_and_what_it_asked_for_is_given_up",
            "tests/api/test_connections.py::test_nothing_that_a_client_invents_makes_series_or_long_lines",
            "tests/api/test_connections.py::test_a_connection_without_a_request_is_closed",
            "tests/api/test_connections.py::test_the_connection_that_waits_longest_for_its_client_gives_way",
            "tests/api/test_connections.py::test_with_all_at_work_the_next_is_told_to_come_again_until_those_who_read_nothing_are_cut_off",
            "tests/api/test_connections.py::test_who_reads_slowly_reads_all",
            "tests/api/test_connections.py::test_half_a_head_that_drips_is_late_too",
            "tests/api/test_one_client_and_others.py::test_bodies_of_one_client_that_stall_are_bounded_and_given_back",
            "tests/web/test_sets.py::test_each_limit_holds_for_whatever_is_tried",
        ),
        (
            "tests/api/test_hostile_requests.py::test_no_address_in_a_request_is_ever_asked",
            "tests/api/test_connections.py::test_nothing_that_a_client_invents_makes_series_or_long_lines[paths]",
        ),
    ),
    Kind(
        "every operation and page with its most expensive requests and those of any kind, and every shortcut beside the whole way",
        ("tests/api/test_contract.py", "tests/api/test_event_loop.py", "tests/api/test_shortcuts.py"),
        (
            "tests/api/test_event_loop.py::test_every_route_has_its_most_expensive_requests",
            "tests/api/test_shortcuts.py::test_a_shortcut_is_as_the_whole_way",
        ),
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
            "tests/catalogue/hosting/test_pull.py::test_what_is_refused_leaves_nothing_behind",
            "tests/catalogue/hosting/test_pull.py::test_a_pull_that_is_killed_leaves_no_release_and_the_next_one_cleans_up",
            "tests/catalogue/hosting/test_download.py::test_a_server_that_takes_its_time_is_given_up",
            "tests/api/test_tracing.py::test_nothing_is_loaded_where_no_collector_is_named",
            "tests/registry/test_over_a_server.py::test_a_service_that_is_killed_while_it_publishes_leaves_a_registry_that_verifies",
            "tests/registry/test_over_a_server.py::test_two_services_on_one_database_write_one_log",
            "tests/registry/test_over_a_server.py::test_events_are_followed_over_a_restart_of_the_service_until_an_interrupt",
            "tests/registry/test_over_a_server.py::test_another_log_at_the_same_address_ends_following",
            "tests/registry/test_over_a_server.py::test_a_service_with_a_follower_stops_without_force",
            "tests/registry/test_over_a_server.py::test_a_token_is_taken_from_the_environment",
            "tests/registry/test_over_a_server.py::test_a_token_is_not_sent_to_where_a_server_redirects",
            "tests/catalogue/hosting/test_hosting.py::test_readers_never_see_a_mix",
        ),
        (
            "tests/api/test_logged_once.py::test_sighup_reads_files_again_and_is_logged",
            "tests/api/test_running.py::test_each_request_is_a_line_of_json_with_the_id_that_its_problem_carries",
        ),
    ),
    Kind(
        "registries that many write at once, and writers that are killed",
        (
            "tests/registry/test_postgresql.py::test_a_dump_that_is_made_while_others_write_is_a_whole_registry",
            "tests/registry/test_postgresql.py::test_a_server_that_ends_within_a_transaction_keeps_nothing_of_it",
            "tests/registry/test_webhooks.py::test_processes_that_are_killed_send_an_event_once_more_at_most_for_each_kill",
            "tests/registry/test_writers.py::test_after_a_kill_every_answered_version_is_there_and_every_other_is_whole_or_absent",
            "tests/registry/test_writers.py::test_equal_bytes_of_parallel_writers_are_published_once_and_unchanged_for_the_others",
            "tests/registry/test_writers.py::test_twenty_writers_of_one_name_make_no_version_twice_and_lose_none",
        ),
        (
            "tests/registry/test_writers.py::test_after_a_kill_every_answered_version_is_there_and_every_other_is_whole_or_absent[postgresql-0]",
            "tests/registry/test_writers.py::test_after_a_kill_every_answered_version_is_there_and_every_other_is_whole_or_absent[sqlite-0]",
            "tests/registry/test_writers.py::test_twenty_writers_of_one_name_make_no_version_twice_and_lose_none[sqlite]",
        ),
    ),
    Kind(
        "changes that real tools check for each binding",
        ("tests/catalogue/comparing/witnesses",),
        (
            "tests/catalogue/comparing/witnesses/test_functions.py::test_what_a_function_uses_breaks_as_the_table_says[a wider integer]",
            "tests/catalogue/comparing/witnesses/test_pairs.py::test_table_and_tool_agree[ids-0]",
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
            "tests/catalogue/exporting/test_stopping.py::test_an_error_stops_an_export_where_it_stops_that_of_vss_tools",
            "tests/catalogue/exporting/test_stopping.py::test_what_vss_tools_exports_has_the_same_bytes",
            "tests/catalogue/exporting/test_exporters.py::test_every_exporter_is_there",
            "tests/catalogue/exporting/test_exporters.py::test_every_option_of_an_exporter_is_there",
            "tests/catalogue/exporting/test_isolation.py",
            "tests/catalogue/test_vspec_language.py::test_vss_tools_gives_the_same",
            "tests/project/test_vehicles.py::test_a_vehicle_is_exported_as_vss_tools_exports_its_equivalent_overlay",
        ),
        (
            "tests/api/test_openapi.py::test_every_example_works_and_is_answered_as_the_schema_says[export_json]",
            "tests/catalogue/exporting/test_same_bytes.py::test_a_tree_with_everything[json -e ASILlevel]",
            "tests/catalogue/exporting/test_same_bytes.py::test_a_tree_with_everything[csv -e ASILlevel]",
            "tests/catalogue/exporting/test_isolation.py::test_nothing_of_vss_tools_is_imported_here",
            "tests/catalogue/exporting/test_exporters.py::test_every_option_of_an_exporter_is_there[json]",
            "tests/project/test_vehicles.py::test_a_vehicle_is_exported_as_vss_tools_exports_its_equivalent_overlay[everything]",
        ),
    ),
    Kind(
        "commands as pages, hooks and an installed package run them",
        (
            "tests/cli/test_pre_commit.py",
            "tests/documentation/test_commands.py",
            "tests/test_generated.py::test_it_is_up_to_date[drives]",
            "tests/test_generated.py::test_it_is_up_to_date[examples]",
            "tests/test_generated.py::test_it_is_up_to_date[runs]",
            "tests/test_generated.py::test_it_is_up_to_date[shown_outputs]",
            "tests/test_installed.py",
            "tests/documentation/test_pipelines.py",
            "tests/project/test_every_command.py",
            "tests/test_real_parts.py::test_every_test_is_of_one_of_both_runs",
            "tests/assistants/test_server.py",
            "tests/cli/test_without_extras.py",
        ),
        (
            "tests/documentation/test_commands.py::test_pages_show_commands",
            "tests/assistants/test_server.py::test_look_ups_over_standard_input_and_output",
            "tests/project/test_every_command.py::test_an_assistant_has_the_same_catalogue_and_rules",
        ),
    ),
    Kind(
        "27,000 random formulas",
        (
            "tests/catalogue/network/test_formula_reference.py::test_random_formulas_have_the_values_of_the_reference",
            "tests/catalogue/network/test_formula_reference.py::test_very_many_random_formulas_have_the_values_of_the_reference",
        ),
        ("tests/catalogue/network/test_formula_reference.py::test_random_formulas_have_the_values_of_the_reference",),
    ),
    Kind(
        "linters of others that take long",
        (
            "tests/adapter/autosar_adaptive/application/test_misra_cpp.py::test_the_adapter_of_a_function_with_everything_has_documented_deviations_alone",
            "tests/adapter/autosar_adaptive/application/test_misra_cpp.py::test_threads_and_watches_have_documented_deviations_alone",
            "tests/adapter/autosar_classic/test_components.py::test_cppcheck_finds_documented_deviations",
            "tests/adapter/core/test_strict.py::test_cppcheck_finds_documented_deviations_in_examples",
            "tests/adapter/core/test_float_cores.py::test_cppcheck_finds_documented_deviations",
            "tests/clients/test_clients.py::test_the_document_passes_the_strict_rules_of_redocly",
            "tests/registry/test_backstage.py::test_the_model_of_backstage_accepts_every_entity",
        ),
        ("tests/adapter/autosar_classic/test_components.py::test_cppcheck_finds_documented_deviations[methods]",),
    ),
    Kind(
        "FMUs in an importer of others",
        (
            "tests/adapter/fmi/test_fmus.py",
            "tests/adapter/fmi/test_event_mode.py",
            "tests/adapter/fmi/test_drive_over_a_bus.py",
            "tests/adapter/fmi/test_fmi2.py",
            "tests/adapter/fmi/test_hostile.py",
            "tests/adapter/fmi/test_player.py",
            "tests/adapter/fmi/test_random.py",
            "tests/adapter/fmi/test_scheduled_execution.py",
            "tests/adapter/fmi/test_state.py",
            "tests/adapter/fmi/test_system.py",
            "tests/adapter/fmi/test_two_fmus_on_a_bus.py",
            "tests/adapter/fmi/test_bus.py::test_fmpy_finds_nothing_wrong",
            "tests/adapter/fmi/test_bus_fuzzed.py",
            "tests/comparison/running/test_fmi.py",
        ),
        ("tests/adapter/fmi/test_system.py::test_fmus_of_functions_exchange_what_functions_of_a_set_exchange[3.0]",),
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
            "tests/runs/test_cases.py",
            "tests/runs/test_expected.py",
            "tests/runs/test_outputs.py",
            "tests/runs/test_limits.py",
            "tests/runs/test_clashes.py",
            "tests/runs/test_ros2_bag.py::test_a_bag_gives_the_same_bits_as_the_drive",
            "tests/python_api/test_run.py",
            "tests/adapter/autosar_classic/test_protected_data.py",
            "tests/adapter/core/test_mutants.py::test_a_mutant_is_found",
            "tests/adapter/core/test_float_arithmetic.py::test_a_conversion_in_float_is_at_most_one_ulp_away",
            "tests/adapter/core/test_float_cores.py::test_a_controller_needs_no_double_and_no_division_of_64_bits_for_a_value",
            "tests/adapter/core/test_float_cores.py::test_no_compiler_warns_or_promotes_to_double",
            "tests/adapter/core/runtime/test_runtime.py::test_a_fault_is_found",
            "tests/adapter/core/test_ticks.py::test_every_decision_is_that_in_nanoseconds",
            "tests/adapter/core/test_ticks.py::test_so_it_is_with_float_arithmetic",
            "tests/adapter/core/test_ticks.py::test_what_is_long_over_stays_over",
            "tests/adapter/core/test_ticks.py::test_each_kind_of_time_is_kept_near",
            "tests/adapter/core/test_ticks.py::test_a_fault_is_found",
            "tests/adapter/core/test_ticks.py::test_no_compiler_warns",
            "tests/adapter/core/test_ticks.py::test_a_controller_needs_no_double_and_no_division_of_64_bits",
            "tests/adapter/core/test_sizes.py::test_a_size_that_is_not_the_declared_one_does_not_compile",
            "tests/adapter/core/test_sizes.py::test_a_kind_or_sign_that_is_not_the_declared_one_does_not_compile",
            "tests/adapter/core/test_sizes.py::test_so_it_is_in_a_class_of_cpp",
            "tests/function/test_code_variables.py::test_an_array_or_struct_that_is_not_that_of_the_header_is_found",
            "tests/function/test_code_variables.py::test_a_type_that_is_not_that_of_the_header_is_found",
            "tests/adapter/test_mutated.py::test_what_was_found_is_generated_for_every_platform",
            "tests/adapter/ros2/test_stored_text.py",
            "tests/test_bench.py::test_the_programs_of_events_fit_what_is_generated",
            "tests/test_bench.py::test_each_datagram_of_the_reference_is_received_after_it_was_sent",
            "tests/function/importing/test_with_adapter.py",
        ),
        (
            "tests/adapter/autosar_classic/test_components.py::test_no_compiler_warns[ecocontrol-*",
            "tests/adapter/autosar_classic/test_components.py::test_no_compiler_warns[everything-system]",
            "tests/adapter/core/test_equivalence.py::test_functions_for_each_subject[conversions]",
            "tests/runs/test_converting.py::test_a_run_is_written_alike[every_datatype_with_all_its_digits]",
            "tests/runs/test_simulate.py::test_an_init_that_crashes_is_told",
            "tests/runs/test_simulate.py::test_the_drive_of_the_examples_goes_as_it_was_recorded",
            "tests/adapter/core/test_mutants.py::test_a_mutant_is_found[equal is late]",
            "tests/adapter/core/test_float_arithmetic.py::test_a_conversion_in_float_is_at_most_one_ulp_away[a hundredth]",
            "tests/adapter/core/test_float_arithmetic.py::test_a_conversion_in_float_is_at_most_one_ulp_away[same scale]",
            "tests/adapter/core/test_float_cores.py::test_a_controller_needs_no_double_and_no_division_of_64_bits_for_a_value[conversions]",
            "tests/adapter/core/test_float_cores.py::test_no_compiler_warns_or_promotes_to_double[system-conversions]",
            "tests/adapter/core/test_float_cores.py::test_no_compiler_warns_or_promotes_to_double[system-classes]",
            "tests/adapter/core/runtime/test_runtime.py::test_a_fault_is_found[sigcat_core.c-36-*",
            "tests/adapter/core/test_ticks.py::test_every_decision_is_that_in_nanoseconds[schedules-4294965296]",
            "tests/adapter/core/test_ticks.py::test_so_it_is_with_float_arithmetic[time_outs]",
            "tests/adapter/core/test_ticks.py::test_what_is_long_over_stays_over[time_outs-0]",
            "tests/adapter/core/test_ticks.py::test_each_kind_of_time_is_kept_near[times]",
            "tests/adapter/core/test_ticks.py::test_a_fault_is_found[times are compared as numbers]",
            "tests/adapter/core/test_ticks.py::test_no_compiler_warns[system-supervision]",
            "tests/adapter/core/test_ticks.py::test_a_controller_needs_no_double_and_no_division_of_64_bits[schedules]",
            "tests/adapter/core/test_sizes.py::test_a_size_that_is_not_the_declared_one_does_not_compile[a*",
            "tests/adapter/core/test_sizes.py::test_a_kind_or_sign_that_is_not_the_declared_one_does_not_compile[a signed*",
            "tests/adapter/core/test_sizes.py::test_so_it_is_in_a_class_of_cpp[a signed one]",
            "tests/function/test_code_variables.py::test_an_array_or_struct_that_is_not_that_of_the_header_is_found[an element beyond*",
            "tests/function/test_code_variables.py::test_a_type_that_is_not_that_of_the_header_is_found[a narrower*",
            "tests/runs/test_cases.py::test_functions_send_what_is_expected[one_function_feeds_another]",
            "tests/runs/test_expected.py::test_what_a_run_wrote_is_what_is_expected_of_it",
            "tests/runs/test_limits.py::test_no_descriptor_leads_to_the_results",
            "tests/adapter/ros2/test_stored_text.py::test_a_value_has_one_text_and_a_text_one_value[Python]",
        ),
    ),
)


def note(item: pytest.Item) -> None:
    """Mark a test that `make test` leaves out."""
    if is_at(item.nodeid, _places()) and not is_at(item.nodeid, _representatives()):
        item.add_marker("real")


def has_none(path: Path, wanted: str) -> bool:
    """Whether a file or folder has no selected test: then it need not be read."""
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
    """Return one line with the omitted tests of a run, and how to run them."""
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
