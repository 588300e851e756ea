"""Severities of the findings of function files; interface_rules/function.yaml says the rest of each rule."""

from collections.abc import Mapping

from sigcat.findings import Severity

SEVERITIES: Mapping[str, Severity] = {
    "F001": "error", "F002": "error", "F003": "error", "F004": "error",
    "F005": "error",
    "F010": "error", "F011": "error", "F012": "warning", "F013": "error", "F014": "error", "F015": "error",
    "F016": "warning", "F017": "warning",
    "F020": "error", "F021": "error", "F022": "error", "F023": "error", "F024": "error", "F025": "warning",
    "F026": "error", "F027": "error", "F028": "warning", "F029": "error",
    "F030": "error", "F031": "warning", "F032": "warning", "F033": "warning", "F034": "warning", "F035": "warning",
    "F036": "error", "F037": "warning",
    "F040": "warning", "F041": "error", "F042": "warning", "F043": "warning",
    "F050": "warning", "F051": "error", "F052": "error", "F053": "error", "F054": "error", "F055": "error",
    "F056": "error", "F057": "warning", "F058": "warning", "F059": "warning",
    "F060": "error", "F061": "error", "F062": "error",
    "F070": "error", "F071": "error",
    "F080": "error", "F081": "warning", "F082": "warning", "F083": "info",
    "F090": "warning", "F091": "warning", "F092": "warning", "F093": "warning", "F094": "warning", "F095": "info",
    "F096": "info", "F097": "warning", "F098": "warning", "F099": "info",
    "F100": "error", "F101": "error", "F102": "warning", "F103": "warning", "F104": "error", "F105": "warning",
    "F106": "error", "F107": "error", "F108": "warning", "F109": "warning", "F110": "warning", "F111": "error",
}  # fmt: skip
