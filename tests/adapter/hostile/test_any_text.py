"""People write any text: who provides a signal, what an error leads to, start values, arguments, names of files."""

import json
from xml.etree import ElementTree as ET

import pytest

from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.function.function_json.model import to_json
from sigcat.integration.reading import read_functions
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT, read_deployment
from sigcat.platforms.integrate import integrate
from sigcat.platforms.platform import Options
from sigcat.platforms.table import PLATFORMS
from tests.adapter.hostile.everything import FUNCTION

PROVIDER = "The driver's display; rear <left>"
SEVERITY = 'It says "hello"; #1 & {x} `y` @z@ */'
FILE = 'a&b; "c" #1.function.yaml'
ARGUMENT, VARIABLE = 'say "hello"; #1', "a;b=$HOME `c` <d> & \\"
DEPLOYMENT = {
    "safetyManager": f"{PROVIDER} 1",
    "modeManager": f"{PROVIDER} 2",
    "autosarAdaptive": {"components": {"Demo": {"startup": {"arguments": [ARGUMENT], "environment": {"A": VARIABLE}}}}},
    "autosarClassic": {"signals": {"Vehicle.Demo.In": {"signal": "In", "database": FILE}}},
}


def functions():
    text = FUNCTION.read_text().replace("provider: Camera", f"provider: {json.dumps(PROVIDER)}")
    text = text.replace("severity: The output is 0.", f"severity: {json.dumps(SEVERITY)}")
    return read_functions([(text.encode(), FILE)], load(shipped_sources()[0])).functions


def made(platform):
    deployment = read_deployment(json.dumps(DEPLOYMENT).encode(), "deployment.json")
    return integrate(PLATFORMS[platform], functions(), deployment).document


def files(platform, document):
    return [
        file
        for generator in PLATFORMS[platform].generators
        for file in generator.generate(document, "a.json", DEFAULT_LIMITS, Options(bench=generator.has_bench))
    ]


def texts_of_arxml(made):
    return {
        element.text
        for file in made if file.name.endswith(".arxml")
        for element in ET.fromstring(file.data).iter()
    }  # fmt: skip


def test_function_json_has_it():
    document = json.loads(to_json(functions()[0].function))
    assert document["Provenance"]["Declaration"] == FILE
    text = json.dumps(document)
    assert json.dumps(PROVIDER) in text
    assert json.dumps(SEVERITY) in text


def test_adaptive_writes_it_into_arxml():
    found = texts_of_arxml(files("autosar-adaptive", made("autosar-adaptive")))
    assert {ARGUMENT, VARIABLE, PROVIDER, f"{PROVIDER} 1", f"{PROVIDER} 2"} <= found


def test_classic_writes_it_into_arxml():
    found = texts_of_arxml(files("autosar-classic", made("autosar-classic")))
    assert {FILE, PROVIDER, f"{PROVIDER} 1", f"{PROVIDER} 2"} <= found


def test_ros2_writes_it_into_its_page():
    (page,) = (file.data.decode() for file in files("ros2", made("ros2")) if file.name == "README.md")
    assert "| The driver's display; rear &lt;left&gt; |" in page
    assert "It says &quot;hello&quot;; #1 &amp; {x} \\`y\\` @z@ \\*/" in page.replace('"hello"', "&quot;hello&quot;")


TEXT = "say \"hello\"; #1 <b> \\ & 'x' %s {0} é"
PARAMETER = """
    Label: {{datatype: string, default: {0}, asil: QM, description: A label.}}
    Labels: {{datatype: 'string[]', arraysize: 2, default: [{0}, ''], asil: QM, description: Labels.}}
"""


@pytest.mark.parametrize("platform", ["autosar-adaptive", "ros2"])
def test_the_default_of_a_parameter_that_is_a_text_is_kept(platform):
    text = FUNCTION.read_text().replace(
        "  parameters:\n    Gain:", f"  parameters:{PARAMETER.format(json.dumps(TEXT))}    Gain:"
    )
    text = text.replace(
        "        parameters:\n",
        "        parameters:\n          - {path: Label, variable: Demo_B.label}\n          - {path: Labels, variable: Demo_B.labels}\n",
    )
    (function,) = read_functions([(text.encode(), FILE)], load(shipped_sources()[0])).functions
    document = integrate(PLATFORMS[platform], (function,), DEFAULT_DEPLOYMENT).document
    assert document.count(json.dumps(TEXT, ensure_ascii=False).encode()) >= 2
    if platform == "autosar-adaptive":  # a core takes no text
        (arxml,) = (each for each in PLATFORMS[platform].generators if each.name == "arxml")
        assert TEXT in texts_of_arxml(arxml.generate(document, "a.json", DEFAULT_LIMITS, Options()))
