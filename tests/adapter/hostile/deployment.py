"""A deployment file in which every field that takes a string has one."""

from typing import Any

DEPLOYMENT: dict[str, Any] = {
    "name": "Demo", "description": "It shows.", "responsible": "Team", "authority": "Organization", "author": "Author", "version": "1.2.3",
    "safetyManager": "Manager", "modeManager": "Manager", "paths": {"Demo.In": "Vehicle.Demo.In"},
    "autosarAdaptive": {
        "package": "Demo", "namespace": "demo::services", "typeNamespace": "demo::types", "functionGroup": "Demo", "contract": "Contract",
        "modes": {"init": "Startup", "step": "Run", "terminate": "Terminate"},
        "components": {
            "Demo": {
                "executable": "DemoExecutable", "headerFiles": ["Demo.h"], "processes": {"First": {"VehicleDemoService": 7}},
                "startup": {"arguments": ["-v"], "environment": {"LEVEL": "3"}},
            }
        },
        "services": [{"name": "DemoService", "namespace": "demo", "paths": ["Vehicle.Demo"]}],
        "units": {"furlong": {"factor": 0.00497}},
        "identifiers": {"DemoService": 100}, "versions": {"DemoService": "2.1"}, "identifierCatalogue": {"OldService": 200},
        "e2e": {"events": {"DemoService.In": {"profile": "none"}}},
        "transport": {
            "DemoService": {
                "multicast": {"threshold": 2, "address": "239.0.0.1", "port": 30500}, "eventGroups": {"Fast": ["In"]},
            }
        },
    },
    "autosarClassic": {
        "package": "Demo", "ecu": "DemoEcu",
        "signals": {"Vehicle.Demo.In": {"signal": "In", "message": "Status", "database": "can.dbc"}},
        "e2e": {"elements": {"Vehicle.Demo.In": {"valid": {"windowSize": 4}}}},
    },
    "fmi": {"fmus": "set", "stepSize": 10, "license": "Proprietary", "copyright": "Demo team", "bus": {"name": "Can", "dbc": ["can.dbc"]}},
    "ros2": {
        "namespace": "/demo", "messagePackage": "demo_messages", "maintainer": "Team", "email": "team@example.com", "license": "Proprietary",
        "quality": {"vehicle/demo/in": {"depth": 2}},
        "messages": {
            "demo": {
                "type": "demo_msgs/Demo", "values": {"header.frame_id": "base"},
                "fields": {"speed": {"signal": "Vehicle.Demo.In", "unit": "m/s", "symbols": {"P": 1}}},
            }
        },
        "messageFolders": ["messages"], "messageDefinitions": {"demo_msgs/Demo": "float64 speed"},
    },
}  # fmt: skip
