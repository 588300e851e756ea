"""Functions to integrate with AUTOSAR Classic, and what to look at in the result."""

from sigcat.findings import has_errors
from sigcat.function.function_json.wire import written
from sigcat.integration.autosar_classic import classic_integration as deriving
from sigcat.integration.autosar_classic.document import read_integration
from sigcat.integration.autosar_classic.model import ClassicIntegration, Component
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT
from tests.function.shipped import resolved


def derive(functions, deployment=DEFAULT_DEPLOYMENT):
    """The integration with the deployment of a file. Where nothing is wrong, no RTE generator refuses it."""
    derived = deriving.derive([resolved(each) for each in functions], deployment, deployment.autosar_classic)
    if not has_errors(derived.findings):
        assert read_integration(written(derived.model), "integration.json") == derived.model
    return derived


def rules(derived):
    """Rules of its findings, each once."""
    return {finding.rule for finding in derived.findings}


def component(model: ClassicIntegration, name: str) -> Component:
    """A component by its name."""
    return next(each for each in model.components if each.name == name)


def port(of: Component, name: str):
    """A port by its name."""
    return next(each for each in of.ports if each.name == name)


def runnable(of: Component, name: str):
    """A runnable by its name."""
    return next(each for each in of.runnables if each.name == name)


def accesses(of: Component, name: str):
    """Kinds of access of a runnable, by port; without port by element."""
    return {(each.port or each.element): each.kind for each in runnable(of, name).accesses}


def starts(of: Component, name: str):
    """Trigger of a runnable: kind, and port, mode or period."""
    return {
        (each.kind, each.mode or each.port or each.period or each.source)
        for each in of.events
        if each.runnable == name
    }  # fmt: skip
