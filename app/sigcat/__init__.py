"""sigcat: vspec files, overlays and functions in; a catalogue, findings, exports and code of platforms out.

A room imports only those below it: cli, web, api, adapter, integration, function, rules, catalogue.
"""

__version__ = "0.1.0"
