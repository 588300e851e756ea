"""Deployments, faults, the project file and pipelines: paths, values and names of releases."""

from sigcat.limits import DEFAULT_LIMITS
from sigcat.migration import migrate
from tests.catalogue.hosting.archives import FILES, saved, tar_bytes

DEPLOYMENT = """\
paths: {Cooler.T: Vehicle.Coolant}   # signal
autosarAdaptive:
  services:
    - {name: Lamps, paths: [Vehicle.Lamp]}
autosarClassic:
  signals:
    'Vehicle.Coolant': {signal: Temp}
"""
FAULTS = """\
scenarios:
  - name: fast
    faults:
      - {fault: value, signal: Vehicle.Speed, from: 1, to: 2, value: '36'}
"""


def test_paths_of_a_deployment_change_as_keys_and_as_values(sides):
    sides.write("deployment.yaml", DEPLOYMENT)
    assert sides.run().status == 0
    assert sides.text("deployment.yaml") == DEPLOYMENT.replace("Vehicle.Coolant", "Vehicle.Engine.Coolant").replace(
        "Vehicle.Lamp", "Vehicle.Light"
    )


def test_values_of_faults_are_converted_once(sides):
    sides.write("faults.yaml", FAULTS)
    for _ in range(2):
        assert sides.run().status == 0
    assert sides.text("faults.yaml") == FAULTS.replace("'36'", "'10'")


def test_generated_documents_are_generated_again(sides):
    text = '{"FunctionInfo": {"FunctionName": "F"}, "Path": "Vehicle.Coolant"}'
    sides.write("f.json", text)
    result = sides.run()
    assert (result.status, sides.text("f.json")) == (0, text)
    assert "D009" in result.messages


def test_files_of_other_programs_may_be_anything(sides):
    sides.write("chart.yaml", "{{ if }}\n")
    sides.write("binary.csv", b"\xff\xfe\x00")
    assert sides.run().status == 0


def test_files_that_are_too_large_or_no_text_are_reported(sides, monkeypatch):
    monkeypatch.setattr(migrate, "DEFAULT_LIMITS", DEFAULT_LIMITS._replace(file_bytes=2000))
    sides.write("long.csv", "time,Vehicle.Speed\n" + "0,1\n" * 600)
    sides.write("old.vspec", b"Vehicle.Speed:\n  comment: \xe9\n")
    result = sides.run()
    assert result.status == 1
    assert "The file has more than 2,000 bytes. It is not migrated." in result.messages
    assert "The file must be in UTF-8. It is not migrated." in result.messages


PIPELINE = """\
steps:
  - run: sigcat pull v5.0 && sigcat lint -s v5.0
  - run: git clone -b v5.0 https://example.com/vehicle_signal_specification
  - uses: other/action@v5.0
"""
PROJECT = '[[catalogue]]\nid = "ours"  # v5.0\nrelease = "v5.0"\n'


def test_names_of_releases_change(tmp_path, monkeypatch, capsys):
    from sigcat.cli import main

    monkeypatch.setenv("SIGCAT_DATA", str(tmp_path / "data"))
    for version in ("v5.0", "v6.0"):
        major = version[1]
        files = {name: text.replace("default: 5", f"default: {major}") for name, text in FILES.items()}
        assert main(["pull", version, "--from", str(saved(tmp_path, tar_bytes(files=files)))]) == 0
    folder = tmp_path / "project"
    workflow = folder / ".github/workflows/ci.yml"
    workflow.parent.mkdir(parents=True)
    workflow.write_text(PIPELINE, encoding="utf-8")
    (folder / "sigcat.toml").write_text(PROJECT, encoding="utf-8")
    monkeypatch.chdir(folder)
    assert main(["migrate", "v5.0", "v6.0"]) == 0
    assert "D007" in capsys.readouterr().err
    assert (folder / "sigcat.toml").read_text(encoding="utf-8") == PROJECT.replace('"v5.0"', '"v6.0"')
    lines = workflow.read_text(encoding="utf-8").splitlines()
    assert lines[1] == "  - run: sigcat pull v6.0 && sigcat lint -s v6.0"
    assert lines[2:] == PIPELINE.splitlines()[2:]
    assert main(["migrate", "v5.0", "v6.0", "--accept-guesses"]) == 0
    assert "clone -b v6.0" in workflow.read_text(encoding="utf-8")


VEHICLES = """\
[[vehicle]]
id = "coupe"
without = ["Vehicle.Lamp", 'Vehicle.Door.Row1.Right', "Vehicle.Door.*", "units.yaml"]  # kept
attributes = {"Vehicle.Speed" = 36, "Vehicle.Trip" = 1.5, steering = "left"}

[vehicle.instances]
"Vehicle.Door" = 2
"""
MIGRATED_VEHICLES = """\
[[vehicle]]
id = "coupe"
without = ["Vehicle.Light", 'Vehicle.Door.Row1.PassengerSide', "Vehicle.Door.*", "units.yaml"]  # kept
attributes = {"Vehicle.Speed" = 10, "Vehicle.Trip" = 1500, steering = "left"}

[vehicle.instances]
"Vehicle.Door" = 2
"""


def test_vehicles_of_the_project_name_the_new_nodes_and_values(sides):
    before = VEHICLES.replace(', "Vehicle.Door.*"', "")
    sides.write("sigcat.toml", before)
    for _ in range(2):
        result = sides.run()
        assert (result.status, sides.text("sigcat.toml")) == (0, MIGRATED_VEHICLES.replace(', "Vehicle.Door.*"', "")), (
            result
        )


def test_what_a_vehicle_names_and_is_not_certain_is_reported_at_its_place(sides):
    text = '[[vehicle]]\nid = "a"\nwithout = ["Vehicle.Gone"]\nattributes = {"Vehicle.Level" = 50}\n'
    sides.write("sigcat.toml", text)
    result = sides.run()
    assert (result.status, sides.text("sigcat.toml")) == (1, text)
    assert "sigcat.toml:3:12: error D003 Vehicle.Gone was removed" in result.messages
    assert "sigcat.toml:4:15: error D004 Vehicle.Level: the unit changed from percent to l" in result.messages
