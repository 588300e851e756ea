"""The commands of the registry, as a team and its pipeline use them."""

import json
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from sigcat.cli import main
from sigcat.data import EXAMPLES

CORE, MPC, WHEELS = (
    EXAMPLES / name / "function.yaml" for name in ("core_acc", "eco_control_mpc", "wheel_speed_calculation")
)
PROPOSAL = "Vehicle.ADAS.EcoControl.AccelerationProposal"
Run = Callable[..., tuple[int, str]]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Run a command in a project with a registry; its status and everything that it prints."""
    monkeypatch.chdir(tmp_path)
    Path("sigcat.toml").write_text('[registry]\ndatabase = "registry.db"\n', encoding="utf-8")

    def command(*arguments: object) -> tuple[int, str]:
        status = main([str(each) for each in arguments])
        printed = capsys.readouterr()
        return status, printed.out + printed.err

    return command


@pytest.fixture
def field(run: Run) -> Run:
    """The same, with three functions, of which two run in a line."""
    assert run("publish", CORE, MPC, WHEELS)[0] == 0
    for name in ("CoreAcc", "EcoControlMpc"):
        assert run("registry", "record-deployment", "SUV-2025", f"{name}@1.0.0")[0] == 0
    return run


def edited(source: Path, name: str, *changes: tuple[str, str]) -> Path:
    text = source.read_text(encoding="utf-8")
    for pattern, replacement in changes:
        text, count = re.subn(pattern, replacement, text)
        assert count, pattern
    file = Path(name)
    file.write_text(text, encoding="utf-8")
    return file


def without_proposal(version: str) -> Path:
    return edited(
        MPC, "mpc.function.yaml", (r"version: 1.0.0", f"version: {version}"),
        (rf"          - path: {PROPOSAL}\n(            .*\n)*", ""),
    )  # fmt: skip


def test_without_a_registry_commands_say_how_to_add_one_and_create_no_file(run: Run, tmp_path: Path) -> None:
    Path("sigcat.toml").write_text("", encoding="utf-8")
    for arguments in (("publish", CORE), ("check", CORE), ("users", "Vehicle.Speed"), ("registry", "list"),
                      ("can-i-deploy", "CoreAcc@1.0.0", "--to", "SUV")):  # fmt: skip
        status, text = run(*arguments)
        assert (status, "[registry]" in text) == (2, True), arguments
    assert [each.name for each in tmp_path.iterdir()] == ["sigcat.toml"]


def test_an_overlay_that_breaks_published_functions_is_reported_with_function_call_owner_and_line(field: Run) -> None:
    Path("speed.vspec").write_text("Vehicle.Speed:\n  type: sensor\n  datatype: float\n  unit: m/s\n", encoding="utf-8")
    status, text = field("check", "speed.vspec")
    assert status == 1
    assert (
        "speed.vspec:4:9: error E006 Changing `unit` of Vehicle.Speed from km/h to m/s breaks CoreAcc 1.0.0, call"
        " CoreAcc_Step, owner Longitudinal control team, in line SUV-2025." in text
    )
    status, text = field("check", "speed.vspec", "--format", "sarif")
    results = json.loads(text)["runs"][0]["results"]
    assert status == 1
    assert {each["ruleId"] for each in results} == {"E006"}
    Path("speed.vspec").write_text(
        "Vehicle.Speed:\n  type: sensor\n  datatype: float\n  delete: true\n", encoding="utf-8"
    )
    status, text = field("check", "speed.vspec", "--format", "github")
    assert status == 1
    assert "Removing Vehicle.Speed breaks CoreAcc 1.0.0, call CoreAcc_Step" in text


def test_an_overlay_that_breaks_nothing_passes(field: Run) -> None:
    Path("new.vspec").write_text(
        "Vehicle.Own: {type: sensor, datatype: float, description: A new signal.}\n", encoding="utf-8"
    )
    assert field("check", "new.vspec")[0] == 0


def test_a_function_without_an_output_breaks_its_consumer_before_it_is_published(field: Run) -> None:
    status, text = field("check", without_proposal("2.0.0"))
    assert status == 1
    assert f"error E008 Removing {PROPOSAL} breaks CoreAcc 1.0.0" in text
    assert "owner Longitudinal control team" in text
    assert "in line SUV-2025" in text
    assert field("check", MPC, CORE)[0] == 0


def test_a_deployment_is_refused_while_vehicles_need_what_it_no_longer_provides(field: Run) -> None:
    assert field("publish", without_proposal("1.1.0"))[0] == 1
    assert field("publish", without_proposal("2.0.0"))[0] == 0
    status, text = field("can-i-deploy", "EcoControlMpc@2.0.0", "--to", "SUV-2025")
    assert (status, text.splitlines()[-1][:3]) == (1, "no:")
    core = edited(CORE, "core.function.yaml", ("version: 1.0.0", "version: 1.1.0"), (rf"          - path: {PROPOSAL}\n(            .*\n)*", ""), (r"          - interface: CoreAcc_ProposalTimeout_ErrorSts\n.*\n", ""))  # fmt: skip
    assert field("registry", "rule", "CoreAcc", "none")[0] == 0
    assert field("publish", core)[0] == 0
    assert field("can-i-deploy", "EcoControlMpc@2.0.0", "--to", "SUV-2025", "--with", "CoreAcc@1.1.0")[0] == 0
    assert field("registry", "record-release", "SUV-2025", "CoreAcc@1.1.0")[0] == 0
    assert field("can-i-deploy", "EcoControlMpc@2.0.0", "--to", "SUV-2025")[0] == 1  # cars that keep 1.0.0
    assert field("registry", "support-ended", "SUV-2025", "CoreAcc@1.0.0")[0] == 0
    status, text = field("can-i-deploy", "EcoControlMpc@2.0.0", "--to", "SUV-2025", "--format", "json")
    assert (status, json.loads(text)["decision"]) == (0, "yes")


def test_a_version_that_breaks_another_owner_waits_for_this_owner(field: Run) -> None:
    assert field("registry", "rule", "EcoControlMpc", "approval")[0] == 0
    assert field("registry", "pending") == (0, "No version is pending.\n")
    core = without_proposal("1.1.0")
    status, text = field("publish", core)
    lines = "  Longitudinal control team must approve it: it breaks CoreAcc 1.0.0\n"
    assert (status, text) == (1, f"function EcoControlMpc 1.1.0: pending\n{lines}")
    status, text = field("registry", "pending", "--owner", "Longitudinal control team")
    assert (status, text.endswith(lines)) == (0, True)
    assert field("registry", "pending", "--owner", "Cockpit team")[1] == "No version is pending.\n"
    decide = ("EcoControlMpc@1.1.0", "--owner", "Longitudinal control team")
    digest = text.split()[5]
    assert field("registry", "approve", *decide, "--sha256", "0" * 64)[0] == 1
    status, text = field("registry", "reject", *decide, "--reason", "\x1b[31mNot\nnow")
    assert (status, "\x1b" in text, text.count("\n")) == (0, False, 2)
    assert field("registry", "approve", *decide, "--sha256", digest)[0] == 0
    assert field("publish", core) == (0, "function EcoControlMpc 1.1.0: published\n")
    assert field("registry", "verify")[0] == 0


def test_an_incompatible_pair_is_named_with_function_version_owner_call_path_and_attribute(field: Run) -> None:
    Path("as_double.vspec").write_text(
        f"{PROPOSAL}:\n  type: sensor\n  datatype: double\n  unit: m/s^2\n", encoding="utf-8"
    )
    assert (
        field(
            "publish", edited(MPC, "mpc.function.yaml", ("version: 1.0.0", "version: 3.0.0")), "-l", "as_double.vspec"
        )[0]
        == 0
    )
    status, text = field("can-i-deploy", "EcoControlMpc@3.0.0", "--to", "SUV-2025", "--format", "json")
    answer = json.loads(text)
    assert (status, answer["decision"]) == (1, "no")
    (conflict,) = [each for each in answer["conflicts"] if each["severity"] == "error"]
    assert (conflict["path"], conflict["attribute"]) == (PROPOSAL, "datatype")
    assert sorted((each["function"], each["version"], *each["calls"]) for each in conflict["sides"]) == [
        ("CoreAcc", "1.0.0", "CoreAcc_Step"), ("EcoControlMpc", "3.0.0", "EcoControlMpc_Step"),
    ]  # fmt: skip
    assert {each["owner"] for each in conflict["sides"]} == {"Longitudinal control team", "Energy management team"}


def test_a_line_without_deployments_is_unknown_and_never_safe(field: Run) -> None:
    status, text = field("can-i-deploy", "CoreAcc@1.0.0", "--to", "SUV-2052")
    assert status == 1
    assert "Did you mean 'SUV-2025'?" in text
    assert text.splitlines()[-1] == "unknown: CoreAcc 1.0.0 in line SUV-2052"


@pytest.mark.parametrize(
    "arguments",
    [
        ("can-i-deploy", "CoreAc@1.0.0", "--to", "SUV-2025"),
        ("can-i-deploy", "CoreAcc@9.0.0", "--to", "SUV-2025"),
        ("can-i-deploy", "CoreAcc", "--to", "SUV-2025"),
        ("registry", "show", "CoreAcc@1.0"),
        ("registry", "record-release", "SUV-2025", "Nothing@1.0.0"),
        ("registry", "support-ended", "SUV", "CoreAcc@1.0.0"),
        ("registry", "rule", "Nothing", "full"),
        ("registry", "deprecate", "CoreAcc@1.0.0", "--successor", "7.0.0"),
    ],
)  # fmt: skip
def test_what_is_not_in_the_registry_is_a_finding(field: Run, arguments: Sequence[str]) -> None:
    status, text = field(*arguments)
    assert (status, "error E005" in text) == (1, True)


def test_users_are_direct_and_through_errors_reactions_and_modes(field: Run) -> None:
    status, text = field("users", "Vehicle.Chassis.Brake.CylP")
    assert status == 0
    lines = text.splitlines()
    assert lines[0].startswith(
        "CoreAcc 1.0.0 consumes Vehicle.Chassis.Brake.CylP, call CoreAcc_Step, C variable core_inputs"
    )
    assert [line.split(",")[0] for line in lines[1:]] == [
        "CoreAcc 1.0.0 reports CoreAcc_BrakePressureTimeout_ErrorSts",
        "CoreAcc 1.0.0 reacts to AccReqInvalid_SftyCondSts",
        "CoreAcc 1.0.0 sends CoreAcc_Mode_Out",
    ]
    _, text = field("users", "Vehicle.Function.CoreAcc.Error.BrakePressureTimeout", "--format", "json")
    assert json.loads(text)["users"][0]["name"] == "CoreAcc_BrakePressureTimeout_ErrorSts"
    assert field("users", "Vehicle.CurrentLocation.Altitude") == (
        0,
        "No published function uses Vehicle.CurrentLocation.Altitude.\n",
    )


def test_users_of_a_definition_are_those_of_its_instances(field: Run) -> None:
    wheels = "Vehicle.Chassis.Axle.Row1.Wheel.Left.AngularSpeed"
    status, text = field("users", wheels)
    assert (status, f"WheelSpeedCalculation 1.0.0 consumes {wheels}," in text) == (0, True), text
    status, text = field("users", "Vehicle.Chassis.Axle.Wheel.AngularSpeed")
    assert (status, f"WheelSpeedCalculation 1.0.0 consumes {wheels}," in text) == (0, True), text
    assert field("users", "Vehicle.Cabin.Door.IsOpen") == (0, "No published function uses Vehicle.Cabin.Door.IsOpen.\n")


def test_a_path_that_is_unknown_everywhere_is_not_one_that_nobody_uses(field: Run) -> None:
    for form in ("text", "json"):
        status, text = field("users", "Vehicle.Spede", "--format", form)
        assert (status, "error E005 No published catalogue or function has 'Vehicle.Spede'" in text) == (1, True), text
        assert "Did you mean 'Vehicle.Speed'?" in text
    Path("own.vspec").write_text("Vehicle.Own: {type: sensor, datatype: float, description: Own.}\n", encoding="utf-8")
    assert field("users", "Vehicle.Own")[0] == 1
    assert field("publish", "own.vspec", "--version", "1.0.0")[0] == 0
    assert field("users", "Vehicle.Own") == (0, "No published function uses Vehicle.Own.\n")


def test_users_of_a_branch_are_those_of_the_nodes_below_it(field: Run) -> None:
    _, text = field("users", "Vehicle.ADAS.EcoControl", "--format", "json")
    assert PROPOSAL in {each["path"] for each in json.loads(text)["users"]}
    status, text = field("users", "Vehicle.ADAS.EcoCont")
    assert (status, "error E005" in text) == (1, True)


def test_a_published_file_is_shown_byte_for_byte_and_a_list_has_owners_and_lines(field: Run) -> None:
    assert field("registry", "show", "CoreAcc@1.0.0")[1] == CORE.read_text(encoding="utf-8")
    assert field("registry", "list", "--line", "SUV-2025")[1].splitlines() == [
        "function CoreAcc 1.0.0: published, owner Longitudinal control team, in line SUV-2025",
        "function EcoControlMpc 1.0.0: published, owner Energy management team, in line SUV-2025",
    ]


def test_a_faulty_function_is_not_published_and_none_of_the_others(run: Run) -> None:
    faulty = edited(MPC, "mpc.function.yaml", (PROPOSAL, "Vehicle.ADAS.EcoControl.AcelerationProposal"))
    status, text = run("publish", CORE, faulty)
    assert (status, "error F0" in text) == (1, True)
    assert "nothing is published in registry.db" in run("registry", "list")[1]
    assert not Path("registry.db").exists()


STRUCT = """
Types: {type: branch, description: Types.}
Types.Lane: {type: struct, description: A lane.}
Types.Lane.Width: {type: property, datatype: float, description: Width., unit: m}
Types.Lane.Quality: {type: property, datatype: uint8, description: Quality.}
"""


def test_a_property_of_a_struct_has_the_users_of_its_signals(run: Run) -> None:
    Path("types.vspec").write_text(STRUCT, encoding="utf-8")
    Path("lane.vspec").write_text(
        "Vehicle.Lane: {type: sensor, datatype: Types.Lane, description: The lane.}\n", encoding="utf-8"
    )
    Path("sigcat.toml").write_text(
        'types = ["types.vspec"]\n[registry]\ndatabase = "registry.db"\n[[catalogue]]\nid = "own"\nrelease = "shipped"\n'
        'overlays = ["lane.vspec"]\n', encoding="utf-8",
    )  # fmt: skip
    function = _lane_function()
    assert run("publish", function)[0] == 0
    _, text = run("users", "Types.Lane.Width")
    assert "Lanes 1.0.0 consumes Types.Lane.Width, call Lanes_Step, through Vehicle.Lane" in text
    Path("types.vspec").write_text(STRUCT.replace("unit: m}", "unit: cm}"), encoding="utf-8")
    Path("lane2.vspec").write_text(
        "Vehicle.Other: {type: sensor, datatype: float, description: Other.}\n", encoding="utf-8"
    )
    status, text = run("check", "lane2.vspec")
    assert status == 1
    assert "Changing `unit` of Types.Lane.Width from m to cm breaks Lanes 1.0.0" in text


def _lane_function() -> Path:
    file = Path("lanes.function.yaml")
    file.write_text(
        "function: Lanes\ndescription: Lanes.\nresponsible: Lane team\nversion: 1.0.0\n"
        "define: {scheduling: {Step: {cycleTime: 10, priority: 1, asil: QM, description: Runs.}}}\n"
        "components: [{name: Lanes, runnables: [{interface: Lanes_Step, data: [{path: Vehicle.Lane, role: consumed}]}]}]\n",
        encoding="utf-8",
    )  # fmt: skip
    return file


TREE = "Vehicle: {type: branch, description: A vehicle.}\nVehicle.Speed: {type: sensor, datatype: float, unit: km/h, description: Speed.}\n"


def test_a_catalogue_is_published_with_its_overlays_and_the_same_bytes_from_any_folder(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    Path("sigcat.toml").write_text(
        '[registry]\ndatabase = "registry.db"\n[[catalogue]]\nid = "fleet"\nspec = "Fleet.vspec"\noverlays = ["own.vspec"]\n',
        encoding="utf-8",
    )
    Path("Fleet.vspec").write_bytes(TREE.replace("\n", "\r\n").encode())
    overlay = Path("own.vspec")
    overlay.write_text(
        "Vehicle.Own: {type: sensor, datatype: float, unit: km/h, description: Own.}\n", encoding="utf-8"
    )
    assert run("publish", "Fleet.vspec", "--version", "1.0.0") == (0, "catalogue fleet 1.0.0: published\n")
    _, text = run("registry", "show", "fleet@1.0.0", "--kind", "catalogue")
    files = json.loads(text)["files"]
    assert list(files)[:2] == ["Fleet.vspec", "own.vspec"]
    assert files["Fleet.vspec"].encode() == Path("Fleet.vspec").read_bytes()
    assert not [name for name in files if Path(name).is_absolute()]
    Path("below").mkdir()
    monkeypatch.chdir("below")
    assert run("publish", "../Fleet.vspec", "--version", "1.0.0") == (0, "catalogue fleet 1.0.0: unchanged\n")
    monkeypatch.chdir(tmp_path)
    overlay.write_text(overlay.read_text(encoding="utf-8").replace("km/h", "m/s"), encoding="utf-8")
    status, text = run("publish", "Fleet.vspec", "--version", "1.1.0")
    assert (status, "Publish it as 2.0.0." in text) == (1, True)


def test_a_tree_that_breaks_a_published_function_is_reported(field: Run) -> None:
    Path("Other.vspec").write_text(TREE.replace("km/h", "m/s"), encoding="utf-8")
    status, text = field("check", "Other.vspec")
    assert status == 1
    assert "Other.vspec:2:" in text
    assert "Removing Vehicle.Mass breaks CoreAcc 1.0.0" in text


def test_an_overlay_is_compared_with_its_version_before(run: Run) -> None:
    overlay = Path("own.vspec")
    overlay.write_text("Vehicle.Own: {type: sensor, datatype: float, description: Own.}\n", encoding="utf-8")
    assert run("publish", overlay)[0] == 2  # an overlay has no version
    assert run("publish", overlay, "--version", "1.0.0", "--owner", "Platform team")[0] == 0
    overlay.write_text("Vehicle.Other: {type: sensor, datatype: float, description: Other.}\n", encoding="utf-8")
    status, text = run("publish", overlay, "--version", "1.1.0")
    assert (status, "Removing Vehicle.Own is breaking" in text) == (1, True)
    assert run("publish", overlay, "--version", "2.0.0")[0] == 0


def test_an_answer_is_bounded(field: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sigcat.cli.registry.REGISTRY_ROWS", 1)
    monkeypatch.setattr("sigcat.cli.registry_options.REGISTRY_ROWS", 1)
    monkeypatch.setattr("sigcat.registry.users.REGISTRY_ROWS", 1)
    assert field("registry", "list")[1].splitlines()[1:] == ["2 more are not shown"]
    assert field("users", "Vehicle.Speed")[1].splitlines()[1:] == ["1 more are not shown"]


def test_a_key_is_made_once_and_its_owner_alone_reads_it(field: Run) -> None:
    assert field("registry", "new-key", "registry.key")[0] == 0
    assert Path("registry.key").stat().st_mode & 0o777 == 0o600
    assert field("registry", "new-key", "registry.key")[0] == 2
    Path("link.key").symlink_to("other.key")
    assert field("registry", "new-key", "link.key")[0] == 2
    assert not Path("other.key").exists()
    with Path("sigcat.toml").open("a", encoding="utf-8") as project:
        project.write('key = "registry.key"\n')
    status, text = field("registry", "verify")
    assert (status, "The last entry of the log is not signed." in text) == (1, True)
    status, text = field("registry", "deprecate", "CoreAcc@1.0.0")
    head = text.split()[-1]
    assert field("registry", "verify", "--public-key", "registry.key.pub", "--head", head)[0] == 0
    assert field("registry", "verify", "--head", "0" * 64)[0] == 1


def test_an_export_and_an_import_of_a_project_are_the_same(field: Run) -> None:
    assert field("registry", "export", "-o", "all.jsonl")[0] == 0
    status, text = field("registry", "export", "-o", "registry.db")
    assert (status, "would be lost" in text) == (2, True)
    project = Path("sigcat.toml")
    project.write_text('[registry]\ndatabase = "second.db"\n', encoding="utf-8")
    assert field("registry", "import", "all.jsonl")[0] == 0
    assert field("registry", "export", "-o", "again.jsonl")[0] == 0
    assert Path("again.jsonl").read_bytes() == Path("all.jsonl").read_bytes()


@pytest.mark.parametrize(
    "text",
    [
        "registry = 1\n",
        "[registry]\n",
        '[registry]\nbase = "x"\n',
        "[registry]\ndatabase = 1\n",
        '[registry]\ndatabase = ""\n',
    ],
)
def test_a_wrong_table_of_the_project_is_a_finding_with_its_line(run: Run, text: str) -> None:
    Path("sigcat.toml").write_text(text, encoding="utf-8")
    status, printed = run("registry", "list")
    assert (status, printed.startswith("sigcat.toml:")) == (2, True)
    assert "Traceback" not in printed


def test_config_shows_the_registry(run: Run) -> None:
    assert re.search(r"^registry.database = registry.db +# sigcat.toml:2$", run("config", "--show")[1], re.MULTILINE)


@pytest.mark.parametrize(
    "arguments",
    [("check", str(CORE)), ("users", "Vehicle.Speed"), ("registry", "list"), ("registry", "verify"), ("registry", "export"),
     ("can-i-deploy", "CoreAcc@1.0.0", "--to", "SUV")],
)  # fmt: skip
def test_an_empty_registry_answers_nothing(run: Run, arguments: tuple[str, ...]) -> None:
    Path("cut.jsonl").write_text("", encoding="utf-8")
    for _ in range(2):
        status, text = run(*arguments)
        assert (status, "nothing is published in registry.db" in text) == (2, True)
        assert run("registry", "import", "cut.jsonl")[0] == 1  # it leaves no database


def git(*arguments: str) -> "subprocess.CompletedProcess[str]":
    person = ("-c", "user.name=A", "-c", "user.email=a@example.org")
    environment = {**os.environ, "GIT_CONFIG_GLOBAL": os.devnull}
    return subprocess.run(["git", *person, *arguments], env=environment, capture_output=True, text=True, check=False)


def test_the_hook_of_the_page_refuses_the_push_of_a_breaking_change(field: Run, tmp_path: Path) -> None:
    page = (Path(__file__).parents[2] / "docs/how-to/registry.md").read_text(encoding="utf-8")
    (hook,) = re.findall(r'```text title=".git/hooks/pre-push"\n(.*?)```', page, re.DOTALL)
    for command in (("init", "-q", "--bare", "remote.git"), ("init", "-q"), ("remote", "add", "origin", "remote.git")):
        assert git(*command).returncode == 0
    called = f"{shlex.quote(sys.executable)} -m sigcat.cli check signals.vspec"
    file = tmp_path / ".git/hooks/pre-push"
    file.write_text(hook.replace("sigcat check signals.vspec functions/*.yaml", called), encoding="utf-8")
    file.chmod(0o755)
    for unit, is_pushed in (("km/h", True), ("m/s", False)):
        Path("signals.vspec").write_text(
            f"Vehicle.Speed: {{type: sensor, datatype: float, unit: {unit}}}\n", encoding="utf-8"
        )
        git("add", "signals.vspec")
        assert git("commit", "-q", "--allow-empty", "-m", unit).returncode == 0
        pushed = git("push", "-q", "origin", "HEAD:main")
        assert ((pushed.returncode == 0), ("E006" in pushed.stdout + pushed.stderr)) == (is_pushed, not is_pushed)


def test_a_clock_that_jumps_back_leaves_a_log_that_verifies(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    assert run("publish", CORE)[0] == 0
    monkeypatch.setattr("sigcat.registry.storing.ledger.now", lambda: "2001-01-01T00:00:00.000+00:00")
    assert run("publish", WHEELS)[0] == 0
    status, text = run("registry", "verify")
    assert (status, "verified: 2 entries" in text) == (0, True)
    assert run("users", "Vehicle.Speed")[0] == 0


def test_a_question_about_two_lines_is_refused(field: Run) -> None:
    status, text = field("can-i-deploy", "CoreAcc@1.0.0", "--to", "SUV-2025", "--to", "OTHER")
    assert (status, "--to must be given once" in text) == (2, True)


@pytest.mark.parametrize("owner", ["", " "])
def test_a_token_of_an_empty_owner_is_refused(field: Run, owner: str) -> None:
    status, text = field("registry", "token", "create", "ci", "--scope", "publish", "--owner", owner)
    assert (status, "--owner must be the name of a team" in text, "sigcat_" in text) == (2, True, False)


@pytest.mark.parametrize(
    ("option", "value", "said"),
    [
        ("--expires", "2001-01-01", "--expires must be today or later, not 2001-01-01"),
        (
            "--owner",
            "L\u043engitudinal control team",
            "The owner must be 'Longitudinal control team', as it is published",
        ),
    ],
)
def test_a_token_that_nobody_can_use_is_refused(field: Run, option: str, value: str, said: str) -> None:
    status, text = field("registry", "token", "create", "ci", "--scope", "publish", option, value)
    assert (status, said in text, "sigcat_" in text) == (2, True, False), text


def test_a_token_of_an_owner_that_is_nearly_one_of_the_registry_is_a_warning(field: Run) -> None:
    create = ("registry", "token", "create")
    status, text = field(*create, "one", "--scope", "publish", "--owner", "Longitudnal control team")
    assert "has published nothing. Did you mean 'Longitudinal control team'?" in text
    assert (status, "sigcat_" in text) == (0, True)
    for name, owner in (("two", "Longitudinal control team"), ("three", "Gearbox")):
        assert "warning" not in field(*create, name, "--scope", "publish", "--owner", owner)[1]


@pytest.mark.parametrize("version", ["9.0.0", "CoreAcc@1.0.0", "1.0"])
def test_an_unknown_version_is_reported_with_those_that_there_are(field: Run, version: str) -> None:
    status, text = field("registry", "deprecate", "CoreAcc@1.0.0", "--successor", version)
    assert (status, f"The registry has no version '{version}' of CoreAcc. Published versions are 1.0.0." in text) == (
        1,
        True,
    )


def test_a_record_warns_of_a_new_line_and_of_a_version_that_does_not_fit(field: Run) -> None:
    assert run_warnings(field("registry", "record-deployment", "SUV-2026", "CoreAcc@1.0.0")) == (
        0, ["warning: line SUV-2026 is new. Did you mean 'SUV-2025'?"]
    )  # fmt: skip
    field("registry", "rule", "EcoControlMpc", "none")
    assert field("publish", without_proposal("2.0.0"))[0] == 0
    assert field("can-i-deploy", "EcoControlMpc@2.0.0", "--to", "SUV-2025")[0] == 1
    advice = "see `sigcat can-i-deploy EcoControlMpc@2.0.0 --to SUV-2025`"
    assert run_warnings(field("registry", "record-deployment", "SUV-2025", "EcoControlMpc@2.0.0")) == (
        0, [f"warning: EcoControlMpc 2.0.0 does not fit what line SUV-2025 runs: {advice}"]
    )  # fmt: skip
    assert run_warnings(field("registry", "record-release", "SUV-2025", "CoreAcc@1.0.0"))[0] == 0


def run_warnings(outcome: tuple[int, str]) -> tuple[int, list[str]]:
    return outcome[0], [line for line in outcome[1].splitlines() if line.startswith("warning: ")]


def test_a_question_that_is_refused_does_not_say_that_nothing_was_changed(field: Run) -> None:
    for arguments in (("can-i-deploy", "CoreAcc@9.0.0", "--to", "SUV-2025"), ("registry", "show", "CoreAcc@9.0.0")):
        status, text = field(*arguments)
        assert (status, "nothing was changed" in text, "the registry has no answer" in text) == (1, False, True)
    status, text = field("registry", "record-deployment", "SUV-2025", "CoreAcc@9.0.0")
    assert (status, "nothing was changed" in text) == (1, True)


def test_support_does_not_end_in_the_past_and_a_successor_is_supported(field: Run) -> None:
    field("publish", without_proposal("2.0.0"))
    status, text = field("registry", "deprecate", "EcoControlMpc@1.0.0", "--until", "")
    assert (status, "--until must not be empty" in text) == (2, True)
    status, text = field("registry", "deprecate", "EcoControlMpc@1.0.0", "--until", "2020-01-31")
    assert (status, "The date must be today or later, not 2020-01-31" in text) == (1, True)
    assert field("registry", "deprecate", "EcoControlMpc@1.0.0", "--until", "2040-01-31")[0] == 0
    status, text = field("registry", "deprecate", "EcoControlMpc@2.0.0", "--successor", "1.0.0")
    assert (status, "must be supported; 1.0.0 is deprecated." in text) == (1, True)


def test_a_day_that_does_not_exist_is_reported_as_such(field: Run) -> None:
    status, text = field("registry", "deprecate", "CoreAcc@1.0.0", "--until", "2026-02-30")
    assert (status, "The date must be a day that exists, not 2026-02-30." in text) == (1, True)
    status, text = field("registry", "deprecate", "CoreAcc@1.0.0", "--until", "30.2.2026")
    assert (status, "The date must be written as 2027-01-31" in text) == (1, True)


def test_a_question_without_a_version_says_that_there_is_no_answer(field: Run) -> None:
    status, text = field("can-i-deploy", "CoreAcc", "--to", "SUV-2025")
    assert status == 1
    assert "A version must be named as NAME@VERSION, not 'CoreAcc'" in text
    assert "the registry has no answer" in text


@pytest.mark.parametrize("owner", ["", " "])
def test_an_owner_without_a_name_is_refused(run: Run, tmp_path: Path, owner: str) -> None:
    """A variable of a pipeline that is not set would remove the owner."""
    (tmp_path / "signals.vspec").write_text("Vehicle.Own: {type: branch, description: Own.}\n")
    status, said = run("publish", "signals.vspec", "--version", "1.0.0", "--owner", owner)
    assert (status, "--owner must be the name of a team" in said) == (2, True), said
