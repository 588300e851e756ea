"""Parts of a derived Integration JSON."""

from sigcat.integration.autosar_adaptive.model import IntegrationModel


def services(model: IntegrationModel, component=None):
    """Service interfaces by name and role."""
    return {
        (interface.name, interface.role): interface
        for part in model.components
        if component in (None, part.name)
        for interface in part.services
    }


def events(model: IntegrationModel):
    """Events by service and name."""
    return {
        (interface.name, event.name): event
        for part in model.components
        for interface in part.services
        for event in interface.services[0].events
    }


def rules(derived):
    return [finding.rule for finding in derived.findings]
