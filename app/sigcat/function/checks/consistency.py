"""Whether a function is consistent in itself: checks of every function, wherever its document is from."""

from sigcat.function.checks.call_checks import check_calls
from sigcat.function.checks.code import check_code
from sigcat.function.checks.data_interfaces import check_data_interfaces
from sigcat.function.checks.datatype_checks import check_types
from sigcat.function.checks.elements import check_elements
from sigcat.function.checks.error_causes import check_error_causes
from sigcat.function.checks.error_references import NO_ERRORS, KnownErrors, check_error_references
from sigcat.function.checks.modes import check_modes
from sigcat.function.checks.names import check_names
from sigcat.function.checks.schedule.checkpoints import check_checkpoints
from sigcat.function.checks.schedule.supervision import check_supervision
from sigcat.function.checks.schedule.times import check_times
from sigcat.function.checks.unfit import check_texts
from sigcat.function.checks.words import check_words
from sigcat.function.document.problem import Problems
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import Origin


def check_consistency(
    function: FunctionJson, known_errors: KnownErrors = NO_ERRORS, origin: Origin | None = None
) -> Problems:
    """Every problem of a function. `origin` is its declaration.

    What is wrong with a string is said once: by the check that knows it as an error, else by its type.
    """
    problems = tuple(_problems(function, known_errors))
    reported = {each.pointer for each in problems if each.rule.severity == "error"}
    unfit = tuple(each for each in check_texts(function, origin) if each.pointer not in reported)
    told = {each.pointer for each in unfit}
    yield from (each for each in problems if each.pointer not in told)
    yield from unfit


def _problems(function: FunctionJson, known_errors: KnownErrors) -> Problems:
    yield from check_names(function)
    yield from check_data_interfaces(function, known_errors.names)
    yield from check_calls(function)
    yield from check_supervision(function, known_errors.names)
    yield from check_error_references(function, known_errors)
    yield from check_modes(function)
    yield from check_times(function)
    yield from check_types(function)
    yield from check_code(function)
    yield from check_elements(function)
    yield from check_error_causes(function, known_errors.names)
    yield from check_checkpoints(function)
    yield from check_words(function)
