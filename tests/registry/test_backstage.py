"""The registry as entities of Backstage, checked by its rules and by its own model."""

import json
import re
import shutil
import subprocess
from collections import Counter
from pathlib import Path

import pytest
import yaml

from sigcat.cli import main
from sigcat.data import EXAMPLES
from sigcat.registry.backstage import Entity, backstage_entities, written
from sigcat.registry.storing.database import in_memory, reading
from tests.registry.parts import add, candidate, catalogue, declaration

_MODEL = "@backstage/catalog-model@1.10.3"
_NAME = re.compile(r"[A-Za-z0-9](?:[A-Za-z0-9_.-]{0,61}[A-Za-z0-9])?")
_REQUIRED: dict[str, dict[str, type]] = {
    "Group": {"type": str, "children": list},
    "API": {"type": str, "lifecycle": str, "owner": str, "definition": str},
    "Component": {"type": str, "lifecycle": str, "owner": str, "providesApis": list, "consumesApis": list},
}
OWNERS = (
    "Team A",
    "team a",
    "Ω",
    "",
    "1.10",
    "1e3",
    "yes",
    "a: [b",
    "x" * 200,
    "x" * 199 + "y",
    "- \u2028\x7f",
    "Team/A",
)


@pytest.fixture
def exported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A catalog-info.yaml of the examples, of which one runs in a line."""
    monkeypatch.chdir(tmp_path)
    Path("sigcat.toml").write_text('[registry]\ndatabase = "registry.db"\n', encoding="utf-8")
    files = [str(EXAMPLES / name / "function.yaml") for name in ("core_acc", "eco_control_mpc", "wheel_speed_calculation")]  # fmt: skip
    assert main(["publish", *files]) == 0
    assert main(["registry", "record-deployment", "SUV-2025", "CoreAcc@1.0.0"]) == 0
    assert main(["registry", "deprecate", "EcoControlMpc@1.0.0"]) == 0
    assert main(["registry", "export", "--backstage", "-o", "catalog-info.yaml"]) == 0
    return tmp_path / "catalog-info.yaml"


def read(file: Path) -> list[Entity]:
    return list(yaml.safe_load_all(file.read_text(encoding="utf-8")))


def check(entities: list[Entity]) -> None:
    """Check the form of entities, and that each reference has an entity."""
    names = [(each["kind"], each["metadata"]["name"].lower()) for each in entities]
    assert Counter(names).most_common(1)[0][1] == 1
    for each in entities:
        assert each["apiVersion"] == "backstage.io/v1alpha1"
        assert _NAME.fullmatch(each["metadata"]["name"]), each["metadata"]["name"]
        for key, kind in _REQUIRED[each["kind"]].items():
            assert isinstance(each["spec"][key], kind)
            assert kind is not str or each["spec"][key]
        spec = each["spec"]
        apis = {*spec.get("providesApis", ()), *spec.get("consumesApis", ())}
        owners = {spec["owner"]} if "owner" in spec else set()
        assert {("API", name.lower()) for name in apis} | {("Group", name.lower()) for name in owners} <= set(names)


def test_functions_are_components_with_their_owners_and_apis(exported: Path) -> None:
    entities = read(exported)
    check(entities)
    components = {each["metadata"]["name"]: each for each in entities if each["kind"] == "Component"}
    assert {name: each["spec"]["lifecycle"] for name, each in components.items()} == {
        "CoreAcc": "production", "EcoControlMpc": "deprecated", "WheelSpeedCalculation": "experimental",
    }  # fmt: skip
    proposal = "Vehicle.ADAS.EcoControl.AccelerationProposal"
    assert proposal in components["CoreAcc"]["spec"]["consumesApis"]
    assert proposal in components["EcoControlMpc"]["spec"]["providesApis"]
    (api,) = [each for each in entities if each["kind"] == "API" and each["metadata"]["name"] == proposal]
    assert api["spec"]["owner"] == components["EcoControlMpc"]["spec"]["owner"] == "Energy-management-team"
    assert yaml.safe_load(api["spec"]["definition"])["unit"] == "m/s^2"
    (speed,) = [each for each in entities if each["metadata"]["name"] == "Vehicle.Speed"]
    assert speed["spec"]["owner"] == "No-published-function-provides-it"


def hostile() -> list[Entity]:
    """Entities of functions whose owners and descriptions have texts of any kind."""
    over = catalogue()
    with in_memory() as connection:
        for name, owner in zip(("Alpha", "Beta", "Gamma", "Delta") * 3, OWNERS, strict=True):
            made = candidate(declaration(name, ("S0",), ("S1",)), over)
            text = made.resolved.replace(json.dumps(f"Team {name}").encode(), json.dumps(owner).encode())
            number = OWNERS.index(owner)
            add(connection, made._replace(name=f"F{number}", owner=owner, resolved=text))
        return list(backstage_entities(connection))


def test_names_of_any_kind_are_names_of_backstage(tmp_path: Path) -> None:
    file = tmp_path / "catalog-info.yaml"
    entities = hostile()
    file.write_text(written(entities), encoding="utf-8")
    assert read(file) == entities
    check(entities)
    assert {each["metadata"]["title"] for each in entities if each["kind"] == "Group"} >= {"1.10", "Ω", "No owner"}


def test_the_file_is_for_backstage_and_an_export_stays_as_it_is(exported: Path, tmp_path: Path) -> None:
    assert main(["registry", "export", "-o", "all.jsonl"]) == 0
    assert Path("all.jsonl").read_text(encoding="utf-8").startswith('{"format"')
    with reading(tmp_path / "registry.db") as connection:
        assert exported.read_text(encoding="utf-8") == written(backstage_entities(connection))


_PROGRAM = """
const model = require('@backstage/catalog-model');
const yaml = require('yaml');
const text = require('fs').readFileSync(0, 'utf-8');
const policy = model.EntityPolicies.allOf([
  new model.DefaultNamespaceEntityPolicy(), new model.FieldFormatEntityPolicy(),
  new model.NoForeignRootFieldsEntityPolicy(), new model.SchemaValidEntityPolicy(),
]);
const kinds = [
  model.groupEntityV1alpha1Validator, model.apiEntityV1alpha1Validator, model.componentEntityV1alpha1Validator,
];
(async () => {
  const read = yaml.parseAllDocuments(text).map(each => each.toJS());
  for (const entity of read) {
    await policy.enforce(entity);
    const found = await Promise.all(kinds.map(kind => kind.check(entity)));
    if (!found.some(Boolean)) throw new Error(JSON.stringify(entity));
  }
  console.log(JSON.stringify(read));
})().catch(error => { console.error(error.message); process.exit(1); });
"""


@pytest.mark.parametrize("kind", ["examples", "hostile"])
def test_the_model_of_backstage_accepts_every_entity(exported: Path, tmp_path: Path, kind: str) -> None:
    node, npm = shutil.which("node"), shutil.which("npm")
    if node is None or npm is None:
        pytest.skip("Node: install it with npm")
    install = [npm, "install", "--no-audit", "--no-fund", "--ignore-scripts", _MODEL, "yaml@2"]
    if subprocess.run(install, cwd=tmp_path, capture_output=True, check=False, timeout=300).returncode:
        pytest.skip(f"{_MODEL}: npm could not install it")
    entities = read(exported) if kind == "examples" else hostile()
    done = subprocess.run(
        [node, "-e", _PROGRAM], cwd=tmp_path, input=written(entities), capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    for each in found:
        each["metadata"].pop("namespace", None)
    assert found == entities
