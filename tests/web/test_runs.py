"""The page of a function shows its stored runs, and no file of its folder breaks it."""

import re
from collections.abc import Callable
from html import unescape
from pathlib import Path

import pytest

from sigcat import limits
from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.data import EXAMPLES
from sigcat.function.hosting import FunctionLibrary, function_over
from sigcat.web.site import create_site
from sigcat.web.views import run_view
from tests.api.conftest import Ask, asker

REQUEST, STATUS = "Vehicle.ADAS.EcoControl.AccelerationRequest", "Vehicle.ADAS.EcoControl.Status"
PROPOSAL, MODE = "Vehicle.ADAS.EcoControl.AccelerationProposal", "CoreAcc_Mode_Out"
LATE = "CoreAcc_BrakePressureTimeout_ErrorSts"
HEADER = f"time,call,{STATUS},{REQUEST},{PROPOSAL},{LATE},{MODE}"
ROWS = (
    "0,CoreAcc_Init,,,,,OFF",
    "1,CoreAcc_Step,1,0.5,,PASSED,STANDBY",
    "1.01,EcoControlMpc_Step,,,-20.0,,",
    "1.05,CoreAcc_Step,2,nan,,FAILED,ACTIVE",
    "3,CoreAcc_Step,2,-0.5,,PASSED,",
    "4,CoreAcc_Terminate,,,,,",
)
RUN = "\n".join([HEADER, *ROWS, ""])
Shown = Callable[..., str]


@pytest.fixture(scope="module")
def library() -> Library:
    return Library([source for source in shipped_sources() if source.id == "interfaces"])


@pytest.fixture(scope="module")
def shipped(library: Library) -> Ask:
    return asker(create_site(library))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with CoreAcc."""
    (tmp_path / "core_acc").mkdir()
    (tmp_path / "core_acc" / "function.yaml").write_bytes((EXAMPLES / "core_acc" / "function.yaml").read_bytes())
    return tmp_path


@pytest.fixture
def ask(folder: Path, library: Library) -> Callable[[], Ask]:
    """A service over what is in the folder by then."""
    return lambda: asker(create_site(library, functions=FunctionLibrary([folder], has_shipped=False)))


@pytest.fixture
def shown(folder: Path, ask: Callable[[], Ask]) -> Shown:
    """The page of a run, from which tags are taken away."""

    def page(data: str | bytes = RUN, query: str = "") -> str:
        (folder / "drive.csv").write_bytes(data.encode() if isinstance(data, str) else data)
        answer = ask()(f"/functions/core_acc?view=run{query}")
        assert answer.status_code == 200, answer.text
        return answer.text

    return page


def words(page: str) -> str:
    return " ".join(
        unescape(re.sub(r"<wbr>|</?b>|</?code>", "", re.sub(r"<(?!/?b>|wbr|/?code)[^>]+>", " ", page))).split()
    )


# -- what it shows ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("function", "said"),
    [
        ("core_acc", "CoreAcc_Mode_Out mode 0 s OFF , 5 s STANDBY , 24 s ACTIVE"),
        ("eco_control_mpc", "EcoControlMpc_Step 110 5.01 s 59.51 s 0.5 s, from 5.01 s on"),
        ("wheel_speed_calculation", "33.052 s FAILED , 34.502 s PASSED"),
    ],
)
def test_every_shipped_function_shows_its_run(shipped: Ask, function: str, said: str) -> None:
    assert '?view=run">Run</a>' in shipped(f"/functions/{function}").text
    page = shipped(f"/functions/{function}?view=run").text
    assert said.replace(" ,", ",") in words(page).replace(" ,", ",")
    assert '<path class="line" d="M' in page
    assert "notice" not in page


def test_without_a_run_there_is_no_tab(ask: Callable[[], Ask]) -> None:
    assert "view=run" not in ask()("/functions/core_acc").text
    assert ask()("/functions/core_acc?view=run").status_code == 404


def test_signals_states_and_calls_are_there_in_words(shown: Shown) -> None:
    text = words(shown())
    assert f"{REQUEST} m/s² 3 0.5 −0.5 0.5 −0.5" in text
    assert f"{LATE} error 1 s PASSED, 1.05 s FAILED, 3 s PASSED" in text
    assert "CoreAcc_Step 3 1 s 3 s 1.95 s, from 1.05 s on" in text
    assert "EcoControlMpc_Step" not in text
    assert "4 s, 6 rows" in text


def test_states_are_bars_with_their_words(shown: Shown) -> None:
    page = shown()
    bars = re.findall(r'<title>([^<]*)</title><rect class="([^"]*)"', page)
    assert ("FAILED from 1.05 s to 3 s", "bad") in bars
    assert ("PASSED from 3 s to 4 s", "good") in bars
    assert ("ACTIVE from 1.05 s to 4 s", "tone-2") in bars
    picture = page.partition('<svg class="diagram run"')[2].partition("</svg>")[0]
    assert [picture.count(f">{word}</text>") for word in ("PASSED", "FAILED", "STANDBY", "ACTIVE")] == [1, 1, 1, 1]


def test_a_state_that_is_too_short_for_its_word_has_it_beside_the_title(shown: Shown) -> None:
    rows = (HEADER, "0,CoreAcc_Step,1,0,,PASSED,", "50,CoreAcc_Step,1,0,,FAILED,", "50.05,CoreAcc_Step,1,0,,PASSED,")
    picture = (
        shown("\n".join([*rows, "100,CoreAcc_Step,,,,,"]))
        .partition('<svg class="diagram run"')[2]
        .partition("</svg>")[0]
    )
    assert re.search(r'<rect class="bad" [^>]*width="10" height="10" /><text[^>]*>FAILED<', picture)


def test_states_that_change_within_a_pixel_are_one_bar(shown: Shown) -> None:
    changes = [f"{number / 100},CoreAcc_Step,1,0,,{('PASSED', 'FAILED')[number % 2]}," for number in range(20_000)]
    page = shown("\n".join([HEADER, *changes, ""]))
    assert "changes between PASSED and FAILED from 0 s to 199.9" in page
    assert "and 19,980\u00a0more changes" in unescape(page)
    assert len(page) < 100_000


def test_signals_are_chosen_in_the_address(shown: Shown) -> None:
    page = shown()
    first = re.findall(r'name="signal" value="([^"]+)" checked', page)
    assert first == [STATUS, REQUEST]
    chosen = shown(query=f"&signal={PROPOSAL}")
    assert re.findall(r'name="signal" value="([^"]+)" checked', chosen) == [PROPOSAL]
    assert re.findall(r'<text class="strong"[^>]*>([^<]*)<', chosen)[0] == f"{PROPOSAL} [m/s²]"
    assert "received" in words(chosen)


def test_more_signals_than_a_picture_has_are_cut_with_a_note(
    folder: Path, library: Library, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(run_view, "RUN_SIGNALS", 1)
    (folder / "drive.csv").write_text(RUN)
    functions = FunctionLibrary([folder], has_shipped=False)
    function = function_over(functions.files, library.default.catalogue, "core_acc")
    assert function.resolved is not None
    view = run_view.run_view(function.resolved, run_view.Asked(functions.runs[0], signals=(STATUS, PROPOSAL)))
    assert [each.name for each in view.choices if each.is_shown] == [STATUS]
    assert view.notes[-1] == "A picture has at most 1 signals: the first ones are shown."


def test_signals_that_the_run_does_not_have_are_told(shown: Shown) -> None:
    assert "no signal <code>Vehicle.&lt;b&gt;</code> that could be drawn" in shown(query="&signal=Vehicle.<b>")


def test_runs_are_chosen_by_links(folder: Path, ask: Callable[[], Ask]) -> None:
    for name in ("hills", "a & b"):
        (folder / f"{name}.csv").write_text(RUN.replace("0.5", "0.75" if name == "hills" else "0.25"))
    site = ask()
    page = site("/functions/core_acc?view=run").text
    assert ">Runs</a>" in page
    links = {
        unescape(text): unescape(link)
        for link, text in re.findall(r'<li><a href="([^"]+view=run[^"]+)"[^>]*>([^<]+)</a>', page)
    }
    assert list(links) == ["a & b", "hills"]
    assert "0.75" in words(site(links["hills"]).text)
    near = site("/functions/core_acc?view=run&run=hill")
    assert (near.status_code, "hills" in near.text) == (404, True)


def test_a_run_is_downloaded_as_it_is(folder: Path, ask: Callable[[], Ask]) -> None:
    (folder / "hügel 1.csv").write_text(RUN)
    page = ask()("/functions/core_acc?view=run").text
    address = next(unescape(link) for link in re.findall(r'href="(/functions/core_acc/runs/[^"]+)"', page))
    file = ask()(address)
    assert file.text == RUN
    assert file.headers["content-type"].startswith("text/csv")
    assert file.headers["content-disposition"].startswith("attachment")
    assert ask()("/functions/core_acc/runs/nope").status_code == 404
    assert ask()("/functions/core_acc/runs/..%2Fcore_acc%2Ffunction.yaml").status_code == 404


def test_runs_are_there_as_data(folder: Path, ask: Callable[[], Ask]) -> None:
    (folder / "drive.csv").write_text(RUN)
    (listed,) = ask()("/functions.json").json()["functions"]
    assert listed["runs"] == ["drive"]
    (run,) = ask()("/functions/core_acc/runs.json").json()["runs"]
    assert (run["id"], run["file"]) == ("drive", f"{folder.name}/drive.csv")
    assert run["columns"] == HEADER.split(",")
    assert ask()("/functions/core_acc.json?view=run").json()["FunctionInfo"]["FunctionName"] == "CoreAcc"


def test_a_run_that_comes_while_the_service_runs_is_shown(folder: Path, library: Library) -> None:
    functions = FunctionLibrary([folder], has_shipped=False)
    site = asker(create_site(library, functions=functions))
    assert site("/functions/core_acc?view=run").status_code == 404
    (folder / "drive.csv").write_text(RUN)
    assert functions.reload_changed()
    assert "0.75" not in words(site("/functions/core_acc?view=run").text)
    (folder / "drive.csv").write_text(RUN.replace("0.5", "0.75"))
    assert "0.75" in words(site("/functions/core_acc?view=run").text)
    (folder / "drive.csv").unlink()
    gone = site("/functions/core_acc?view=run")
    assert (gone.status_code, "cannot be read" in gone.text) == (200, True)
    assert site("/functions/core_acc/runs/drive").status_code == 404


# -- parts of a run, and others beside it ---------------------------------------------------------------------------


def picture_of(page: str) -> str:
    return page.partition('<svg class="diagram run"')[2].partition("</svg>")[0]


def test_a_window_of_the_picture_is_in_the_address(shown: Shown) -> None:
    page = shown(query="&from=1&to=2")
    assert 'data-first="1" data-last="2"' in page
    assert ("ACTIVE from 1.05 s to 2 s", "tone-2") in re.findall(r'<title>([^<]*)</title><rect class="([^"]*)"', page)
    assert f"{REQUEST} m/s² 3 0.5 −0.5 0.5 −0.5" in words(page)  # the table has the whole run
    links = dict(re.findall(r'<a href="([^"]+)" data-zoom="([^"]+)"', page))
    zooms = {title: unescape(link).partition("?")[2] for link, title in links.items()}
    assert zooms["Zoom in"] == "view=run&run=drive&from=1.25&to=1.75"
    assert zooms["Earlier"] == "view=run&run=drive&from=0.5&to=1.5"
    assert zooms["Whole run"] == "view=run&run=drive"


def test_a_value_that_holds_when_the_window_begins_is_drawn(shown: Shown) -> None:
    picture = picture_of(shown(query=f"&from=3.5&to=4&signal={REQUEST}"))
    assert '<path class="line" d="M110 ' in picture


@pytest.mark.parametrize(
    ("query", "said"),
    [
        ("&from=soon", "must be times in seconds"),
        ("&from=3&to=2", "must be times in seconds"),
        ("&from=-1", "must be times in seconds"),
        ("&from=70&to=80", "has no row from 70 s to 80 s"),
    ],
)
def test_a_window_that_cannot_be_shown_is_a_note(shown: Shown, query: str, said: str) -> None:
    assert said in words(shown(query=query))


def test_inputs_come_from_the_trace_in_the_folder_of_the_run(folder: Path, shown: Shown) -> None:
    (folder / "trace.csv").write_text(f"time,Vehicle.Speed,{LATE}_x\n0,10,\n2,20,\n9,30,")
    page = shown(query="&signal=Vehicle.Speed")
    assert "Vehicle.Speed km/h 3 10 10 30 30" in words(page)
    assert picture_of(page).count('<path class="line"') == 1
    assert 'data-last="4"' in page


def test_a_time_out_that_has_passed_is_drawn_and_counted(folder: Path, shown: Shown) -> None:
    (folder / "trace.csv").write_text("time,Vehicle.Chassis.Brake.CylP\n0,1\n0.01,1\n3,2\n")
    page = shown(query="&signal=Vehicle.Chassis.Brake.CylP")
    passed = re.findall(r"<title>time-out passed from ([^<]*)</title>", page)
    assert len(passed) == 2
    assert re.search(r"time-out [0-9.]+ s, passed 1.time", words(page))


def test_limits_are_drawn_where_values_come_near_them(shown: Shown) -> None:
    page = shown(query=f"&signal={REQUEST}")
    assert 'class="limit"' not in picture_of(page)
    wide = shown(RUN.replace(",0.5,", ",15,"), f"&signal={REQUEST}")
    assert 'class="limit"' in picture_of(wide)
    assert re.search(r"−\d+ to \d+", words(page))


def test_bad_states_are_bands_behind_the_signals(shown: Shown) -> None:
    (band,) = re.findall(r'<rect class="band" [^>]*><title>([^<]*)<', shown())
    assert band == "FAILED from 1.05 s to 3 s"


def test_expected_outputs_are_drawn_over_the_run(folder: Path, shown: Shown) -> None:
    (folder / "expected.csv").write_text(f"time,{REQUEST}\n1,0.25\n3,-0.75\n")
    assert '<option value="expected">' in shown()
    page = shown(query=f"&beside=expected&signal={REQUEST}")
    assert '<path class="beside" d="M' in picture_of(page)
    assert "Dashed: " in words(page)
    assert 'name="expected"' not in page


def test_what_is_drawn_is_there_as_data(folder: Path, ask: Callable[[], Ask]) -> None:
    (folder / "drive.csv").write_text(RUN)
    (folder / "expected.csv").write_text(f"time,{REQUEST}\n1,0.25\n3,-0.75\n")
    (line,) = ask()(f"/functions/core_acc/runs/drive/values.json?signal={REQUEST}&beside=expected&from=2&to=4").json()[
        "signals"
    ]
    assert (line["name"], line["unit"]) == (REQUEST, "m/s^2")
    assert line["points"] == [[2.0, "no number"], [3.0, "−0.5"]]
    assert line["beside"] == [[2.0, "0.25"], [3.0, "−0.75"]]
    assert ask()("/functions/core_acc/runs/nope/values.json").status_code == 404


def test_a_recording_that_is_not_there_is_not_found(shown: Shown, ask: Callable[[], Ask]) -> None:
    shown()
    assert ask()("/functions/core_acc?view=run&beside=expcted").status_code == 404


# -- files of any kind --------------------------------------------------------------------------------------------

NO_CORE_COLUMNS = f"time,call,{MODE}\n0,CoreAcc_Init,OFF\n"


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (RUN[: RUN.index("-0.5")], "it was cut"),
        (RUN.replace("0.5,,PASSED", "fast,,PASSED"), "must be a number, not 'fast'"),
        (RUN.replace("FAILED", "<b>"), "must be PASSED or FAILED, not '<b>'"),
        (RUN.replace("\n3,", "\nNaN,"), "must be in seconds"),
        (RUN.replace("\n3,", "\n0.5,"), "that of the row above"),
        (RUN.replace("\n3,", "\n1e99,"), "must be in seconds"),
        (RUN.encode()[:-30] + b"\xff\xfe\n", "must be in UTF-8"),
        (RUN.encode() + b"\0" * 1000 + b"\n", "must have 7 cells"),
        (RUN + "1" * (limits.TRACE_ROW_BYTES + 1), "must be shorter than 4 MiB"),
        (RUN.replace(f",{PROPOSAL}", f",{REQUEST}"), "must be in the header only once"),
        (NO_CORE_COLUMNS, "it has no"),
        (f"{HEADER}\n", "The run has no rows"),
        (f"{HEADER}", "it was cut"),
        (RUN.replace("\n", ",\n", 1), "must have 8 cells"),
    ],
    ids=[
        "cut", "a word", "a tag", "NaN as time", "back in time", "late", "no UTF-8", "zeros", "a long row", "a column twice",
        "another state", "no rows", "a header alone", "an empty column",
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_run_is_a_note_of_its_page(shown: Shown, data: str | bytes, said: str) -> None:
    page = shown(data)
    assert said in words(page)
    assert str(Path.cwd()) not in page
    assert "/tmp" not in page
    assert "<b>'" not in page


def test_one_moment_is_drawn(shown: Shown) -> None:
    assert '<path class="line" d="M' in shown(f"{HEADER}\n5,CoreAcc_Step,1,0.5,,PASSED,OFF\n")


@pytest.mark.parametrize("value", ["nan", "inf", "-inf", "1e308", "-1e-320", "3.4e38"])
def test_every_number_is_drawn(shown: Shown, value: str) -> None:
    page = shown(f"{HEADER}\n1,CoreAcc_Step,1,{value},,,\n9e9,CoreAcc_Step,1,0,,,\n")
    assert "nan" not in page.partition('<svg class="diagram run"')[2].partition("</svg>")[0]


def test_a_run_that_is_too_large_is_not_drawn(folder: Path, shown: Shown) -> None:
    page = shown(RUN + " " * limits.RUN_BYTES)
    assert "at most 16 MiB" in page
    assert '<svg class="diagram run' not in page
    assert "Download" in page


def test_very_many_columns_of_others_are_passed_over(shown: Shown) -> None:
    others = ",".join(f"x{number}" for number in range(30_000))
    assert "0.5" in words(shown(f"{HEADER},{others}\n0,CoreAcc_Step,1,0.5,,,{',' * 30_000}\n"))
