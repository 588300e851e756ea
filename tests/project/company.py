"""A project of a company: a unit, an overlay, a rule and a function, over what sigcat ships."""

from pathlib import Path

PROJECT = """\
functions = ["functions"]
rules = ["rules.yaml"]
units = ["units.yaml"]
deployment = "deployment.yaml"
dbc = ["can.dbc"]

[lint]
extended-attributes = ["owner"]

[[catalogue]]
id = "acme"
title = "Acme"
release = "shipped"
overlays = ["overlays/*.vspec"]
"""
UNITS = """\
ppm:
  definition: Parts per million.
  unit: parts per million
  quantity: relation
  allowed-datatypes: ['numeric']
  symbol: ppm
"""
OVERLAY = """\
Vehicle.Cabin.AcmeGas:
  type: sensor
  datatype: float
  unit: ppm
  owner: Air team
  description: Carbon dioxide in the air of the cabin.
"""
RULES = """\
ACME001:
  name: owner-missing
  title: Each of our signals has an owner.
  severity: error
  why: Questions need an answer.
  check: required
  nodes: {types: [signals], path: Vehicle.Cabin.Acme*}
  options: {attributes: [owner]}
  source: Guide of Acme
"""
FUNCTION = """\
function: CabinAir
description: Watches the air in the cabin.
responsible: Air team

define:
  scheduling:
    Init: {asil: QM, description: Clears the mean.}
    Step: {cycleTime: 100, asil: QM, description: Adds a value to the mean.}
    Terminate: {asil: QM, description: Gives resources back.}

components:
  - name: CabinAir
    runnables:
      - Init
      - interface: Step
        data:
          - {path: Vehicle.Cabin.AcmeGas, role: consumed, variable: gas, asil: QM, provider: Sensor}
      - Terminate
"""


def write_company(folder: Path) -> Path:
    """Write the project into a folder."""
    texts = {
        "sigcat.toml": PROJECT,
        "units.yaml": UNITS,
        "rules.yaml": RULES,
        "deployment.yaml": "{}\n",
        "can.dbc": 'VERSION ""\n',
        "overlays/acme.vspec": OVERLAY,
        "functions/cabin_air/function.yaml": FUNCTION,
        "trace.csv": "time,Vehicle.Cabin.AcmeGas\n0,400\n1,500\n",
        "log.asc": "",
    }
    for name, text in texts.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder
