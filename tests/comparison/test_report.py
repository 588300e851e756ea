"""The report of a comparison: evaluated, as JSON and back, as Markdown, as a page that needs nothing from outside."""

import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

import sigcat
from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.host.shapes import Number
from sigcat.comparison.effort import Counted
from sigcat.comparison.recording import Built, CallTime, ProcessLoad, Recording
from sigcat.comparison.report.drawing import SERIES, traces
from sigcat.comparison.report.html import html_page
from sigcat.comparison.report.markdown import markdown
from sigcat.comparison.report.model import Line, Trace, read_report, to_json
from sigcat.comparison.report.style import STYLE
from sigcat.comparison.running.table import RUNNERS
from sigcat.comparison.telling.material import Material, Played, PlayedFault, WrittenLines
from sigcat.comparison.telling.report import report_of
from sigcat.comparison.telling.targets import WAITING
from sigcat.errors import InputRefused
from sigcat.limits import COMPARISON_BYTES
from sigcat.runs.columns import Column

STYLESHEET = Path(sigcat.__file__).parent / "web/static/sigcat.css"

SITE = Path(__file__).parents[2] / "app/sigcat/web/static/sigcat.css"
END = 600 * 10**9
CYCLE = 50_000_000
REQUEST, FAILED, REACTION = "Vehicle.Request", "Acc_Late_ErrorSts", "Acc_Invalid_SftyCondSts"
STATUS = Number("uint8", (("PASSED", 0), ("FAILED", 1)))
COLUMNS = {
    REQUEST: Column(REQUEST, "signal", Number("float"), "m/s^2", True, True, None),
    FAILED: Column(FAILED, "error", STATUS, "", True, True, 0),
    REACTION: Column(REACTION, "safety reaction", STATUS, "", True, False, 0),
}
SENT = {
    REQUEST: tuple((time, str(time % 7 / 10)) for time in range(0, END + 1, CYCLE * 10)),
    FAILED: ((0, "PASSED"), (CYCLE, "FAILED")),
    REACTION: ((0, "PASSED"),),
}


def calls(adapter, logic=1000, count=200):
    return tuple(CallTime("Acc", "Acc_Step", index * CYCLE, adapter + logic, logic) for index in range(count))


def played(name, adapter=1000, sent=SENT, cpu=1.0, memory=40_000_000, **more):
    built = Built(name, Path(), (), 0.5, 12.0, more.pop("notes", ()))
    processes = (ProcessLoad("acc", cpu, memory, 100_000), ProcessLoad("player", 9.0, memory, 0, True))
    fields = {key: more.pop(key) for key in ("silent", "last_words") if key in more}
    recording = Recording(name, "lock step", built, sent, calls(adapter), processes, **fields)
    return Played(name, name.upper(), built=built, lock_step=recording, **more)


def material(*others, **more):
    platforms = (played("simulate"), *others)
    return Material("Set", ("Acc",), "drive.csv", END, COLUMNS, CYCLE, platforms, **{"seconds": 100.0, **more})


def told(*others, **more):
    return report_of(material(*others, **more))


def target(report, beginning):
    return next(each for each in report.targets if each.what.startswith(beginning))


def changed(name, place, value):
    values = list(SENT[name])
    values[place] = (values[place][0], value)
    return {**SENT, name: tuple(values)}


# -- what must hold -----------------------------------------------------------------------------------------------


def test_generated_lines_are_those_that_a_user_gets():
    """Files that a comparison writes next to them are not counted."""
    files = (GeneratedFile("core/a.c", b"/* A. */\nint a;\nint b;\n"), GeneratedFile("README.md", b"A.\n"))
    own = played("ros2-cpp")
    own = own._replace(built=own.built._replace(generated=files))
    (found,) = [each for each in told(own).effort if each.by == "sigcat"]
    assert (found.platform, found.files, found.total) == ("ros2-cpp", 2, 4)


def test_equal_outputs_of_ten_minutes_hold():
    report = told(played("ros2-cpp"))
    assert target(report, "outputs equal").holds is True
    assert report.is_equal


def test_one_bit_in_one_step_of_one_platform_does_not_hold_and_is_told_with_its_time():
    report = told(played("autosar-adaptive"), played("ros2-cpp", sent=changed(REQUEST, 3, "0.10000001")))
    assert target(report, "outputs equal").holds is False
    assert not report.is_equal
    assert "0.10000001 instead of" in markdown(report)


def test_a_shorter_drive_says_nothing_of_the_whole_one():
    short = material(played("ros2-cpp"))._replace(end_ns=60 * 10**9)
    found = target(report_of(short), "outputs equal")
    assert (found.holds, found.note) == (None, "the drive has 60 s")


def test_a_platform_that_died_is_not_equal_whatever_it_sent():
    report = told(played("ros2-cpp", last_words="terminate called"))
    assert not report.is_equal
    assert target(report, "outputs equal").holds is False
    assert "terminate called" in html_page(report)


def test_a_platform_that_is_there_and_cannot_be_built_is_told_with_what_the_compiler_says():
    error = "acc.c: In function 'step':\nacc.c:3:10: error: 'x' undeclared\n    3 |   return x;\n      |          ^"
    report = told(
        played("ros2-cpp"), Played("autosar-adaptive", "Adaptive", "it cannot be built: acc.c:3:10: …", error)
    )
    assert not report.is_equal
    assert "\n    acc.c:3:10: error: 'x' undeclared\n        3 |   return x;\n" in markdown(report)
    assert "acc.c:3:10: error: &#x27;x&#x27; undeclared\n    3 |   return x;\n" in html_page(report)


def test_what_a_platform_has_no_message_for_is_told_and_not_compared():
    sent = {name: values for name, values in SENT.items() if name != REACTION}
    report = told(played("autosar-adaptive", sent=sent, silent=(REACTION,)))
    assert report.is_equal
    assert f"no message for {REACTION}" in html_page(report)


ALONE, LEFT_OUT = material(), Played("autosar-adaptive", "Adaptive", left_out="get it")
UNMEASURED = {
    "the simulation alone": ALONE,
    "a platform that is left out": material(LEFT_OUT),
    "without faults or figures of its calls": material(
        played("ros2-cpp")._replace(lock_step=played("ros2-cpp").lock_step._replace(calls=(), processes=()))
    ),
    "a short drive with few calls": material(played("ros2-cpp"))._replace(end_ns=10**9),
}


@pytest.mark.parametrize("compared", UNMEASURED.values(), ids=UNMEASURED)
def test_what_is_not_measured_says_why(compared):
    unmeasured = [each for each in report_of(compared).targets if each.holds is None]
    assert unmeasured
    assert [each.what for each in unmeasured if not each.note] == []


@pytest.mark.parametrize(("adapter", "holds"), [(10_000, True), (11_100, False)])
def test_an_adapter_is_checked_beyond_the_loop_without_transport(adapter, holds):
    report = told(played("ros2-cpp", adapter=adapter))
    assert target(report, "adapter of ROS2-CPP").holds is holds


@pytest.mark.parametrize(("adapter", "holds"), [(1_000, None), (11_100, False)])
def test_few_calls_have_no_p99_that_an_adapter_could_be_checked_by(adapter, holds):
    few = played("ros2-cpp")
    few = few._replace(lock_step=few.lock_step._replace(calls=calls(adapter, count=99)))
    found = target(told(few), "adapter of ROS2-CPP")
    assert found.holds is holds
    assert found.note == "99 calls in lock step are too few for a p99"


def preempted(count, adapter=50_000):
    """A platform whose calls take a microsecond, but for some that something else interrupted."""
    disturbed = [each._replace(is_preempted=True) for each in calls(adapter, count=count)]
    own = played("ros2-cpp")
    return own._replace(lock_step=own.lock_step._replace(calls=(*calls(1_000, count=200 - count), *disturbed)))


def test_what_the_machine_did_in_the_middle_of_a_call_is_not_counted_for_the_adapter():
    found = target(told(preempted(5)), "adapter of ROS2-CPP")
    assert found.holds is True
    assert "5 of 200 calls in lock step were preempted and are excluded: with them, p99 is 49 µs" in found.note


def test_a_long_call_that_kept_its_processor_is_checked():
    own = preempted(5)
    kept = tuple(each._replace(is_preempted=False) for each in own.lock_step.calls)
    assert (
        target(told(own._replace(lock_step=own.lock_step._replace(calls=kept))), "adapter of ROS2-CPP").holds is False
    )


def test_calls_that_were_all_preempted_are_all_checked():
    assert target(told(preempted(200)), "adapter of ROS2-CPP").holds is False


def test_calls_that_were_preempted_are_in_the_distributions():
    (row,) = [each for each in told(preempted(5)).timing if each.platform == "ros2-cpp"]
    assert (row.preempted, row.t_adapter.total, row.t_adapter.worst) == (5, 200, 50_000)
    assert (row.t_adapter_alone.total, row.t_adapter_alone.worst) == (195, 1_000)
    assert "t_adapter, not preempted" in html_page(told(preempted(5)))


def test_the_adapter_in_python_is_reported_and_not_checked():
    report = told(played("ros2-py", adapter=10**6))
    assert not [each for each in report.targets if each.what.startswith("adapter")]
    assert [each.t_adapter.p50 for each in report.timing if each.platform == "ros2-py"] == [10**6]


def repeated(name, *cpu, memory=40_000_000, **options):
    """A platform that was played to several times."""
    runs = [played(name, cpu=each, memory=memory, **options) for each in cpu]
    return runs[0]._replace(repeats=tuple(each.lock_step for each in runs[1:]))


BY_HAND = repeated("baseline", 1.0, 1.0, 1.0, is_by_hand=True)


@pytest.mark.parametrize(
    ("cpu", "memory", "holds"), [(1.08, 40_000_000, True), (1.2, 40_000_000, False), (1.0, 50_000_000, False)]
)
def test_processor_time_and_memory_are_checked_against_handwritten_nodes(cpu, memory, holds):
    report = told(repeated("ros2-cpp", cpu, cpu + 0.01, cpu - 0.005, memory=memory), BY_HAND)
    assert target(report, "ROS2-CPP, over").holds is holds


def test_the_load_is_a_median_with_its_spread():
    found = target(told(repeated("ros2-cpp", 0.5, 0.6, 0.9), BY_HAND), "ROS2-CPP, over")
    assert (found.holds, found.measured) == (True, "\u221240 % processor time, +0 % memory")
    assert found.note == "3 runs, of which the processor time spreads over 40 points"


def test_no_verdict_comes_of_one_run_or_of_a_spread_that_is_larger_than_the_difference():
    for own, note in (
        (repeated("ros2-cpp", 1.0), "one run: its spread is unknown"),
        (repeated("ros2-cpp", 0.9, 1.05, 1.2), "3 runs"),
    ):
        found = target(told(own, BY_HAND), "ROS2-CPP, over")
        assert found.holds is None
        assert found.note.startswith(note)
        assert "Inconclusive: ROS2-CPP, over" in " ".join(told(own, BY_HAND).notes)


def with_slow_call(own, adapter):
    """The same with a second call."""
    more = tuple(each._replace(call="Acc_Slow") for each in calls(adapter))
    return own._replace(lock_step=own.lock_step._replace(calls=(*own.lock_step.calls, *more)))


def test_a_call_that_misses_the_target_is_not_hidden_by_another():
    platforms = (with_slow_call(played("simulate"), 1_000), with_slow_call(played("ros2-cpp"), 50_000))
    report = report_of(material()._replace(platforms=platforms))
    assert target(report, "adapter of ROS2-CPP, Acc_Step").holds is True
    assert target(report, "adapter of ROS2-CPP, Acc_Slow").holds is False
    summary = html_page(report).partition('class="wide stacked summary"')[2].partition("</table>")[0]
    assert "1 of 2 fail" in summary


def test_a_negative_time_explains_the_subtraction():
    found = target(told(played("ros2-cpp", adapter=500)), "adapter of ROS2-CPP")
    assert found.measured.startswith("\u2212")
    assert "subtracted" in found.note


def test_a_page_shows_a_summary_then_pictures_then_folded_tables():
    page = html_page(whole())
    assert (
        page.index('class="wide stacked summary"') < page.index("<svg") < page.index("Outputs in lock step</summary>")
    )
    assert page.count("<table") == page.count("<details>") + 1


def test_without_nodes_by_hand_the_overhead_is_not_measured():
    assert target(told(played("ros2-cpp")), "ROS2-CPP, over").holds is None


def test_differences_of_what_was_written_by_hand_are_shown_and_not_checked():
    report = told(played("ros2-cpp"), played("baseline", sent=changed(REQUEST, 2, "9"), is_by_hand=True))
    assert report.is_equal
    assert [each.wrong for each in report.behaviour] == [0, 1]


def test_lines_for_one_platform_are_counted_against_it():
    written = (
        WrittenLines("declaration", "", Counted(1, 100, 120)),
        WrittenLines("glue", "ros2-cpp", Counted(1, 7, 9)),
    )
    assert target(told(played("ros2-cpp"), written=written), "lines written").measured == "7"
    assert target(told(played("ros2-cpp"), written=written[:1]), "lines written").holds is True


def test_the_time_counts_if_all_platforms_were_played_to():
    assert target(told(played("ros2-cpp")), "the whole").holds is True
    assert target(told(played("ros2-cpp"), seconds=301.0), "the whole").holds is False
    assert target(told(played("ros2-cpp"), Played("ros2-py", "Python", left_out="get it")), "the whole").holds is None


@pytest.mark.parametrize(("waiting", "is_told"), [("0.4", False), ("7.5", True)])
def test_a_machine_that_did_other_work_is_told_before_all_figures(waiting, is_told):
    machine = (("cores", "2"), (WAITING, waiting))
    notes = told(played("ros2-cpp"), machine=machine).notes
    assert any("7.5 processes wanted to run on 2 cores" in each for each in notes) is is_told


def test_a_platform_that_is_not_there_is_left_out_with_how_to_get_it():
    report = told(Played("ros2-cpp", "ROS 2, C++", left_out="source its setup.bash"))
    assert report.is_equal
    assert "ROS 2, C++ is left out: source its setup.bash" in report.notes
    assert target(report, "outputs equal").holds is None


# -- faults -------------------------------------------------------------------------------------------------------


def fault(name, ours, theirs):
    return PlayedFault(name, f"title of {name}", "", {"simulate": ours.lock_step, "ros2-cpp": theirs.lock_step})


def test_faults_hold_if_twenty_of_them_are_the_same_everywhere():
    faults = tuple(fault(f"f{n}", played("simulate"), played("ros2-cpp")) for n in range(20))
    assert target(told(played("ros2-cpp"), faults=faults), "faults").holds is True
    assert target(told(played("ros2-cpp"), faults=faults[1:]), "faults").holds is None
    other = fault("other", played("simulate"), played("ros2-cpp", sent=changed(REQUEST, 1, "9")))
    held = target(told(played("ros2-cpp"), faults=(*faults, other)), "faults")
    assert (held.holds, held.measured, held.note) == (False, "20 of 21, 1 platform", "ROS2-CPP: 1 otherwise")


def test_what_comes_at_other_times_is_counted_once_at_each_time_and_told_of_its_platform():
    late = {name: tuple((time + 1, value) for time, value in values) for name, values in SENT.items()}
    report = told(played("ros2-cpp", sent=late), played("autosar-adaptive"))
    (found,) = [each for each in report.behaviour if each.platform == "ros2-cpp"]
    assert found.wrong == found.values == 2 * sum(map(len, SENT.values()))
    note = target(report, "outputs").note
    assert f"ROS2-CPP: {found.wrong:,} of {found.values:,} differ" in note
    assert "AUTOSAR" not in note


def test_an_error_one_step_later_is_another_behaviour_and_the_change_is_told():
    ours = played("simulate", sent={**SENT, FAILED: (*SENT[FAILED], (3 * CYCLE, "PASSED"))})
    theirs = played("ros2-cpp", sent={**SENT, FAILED: (*SENT[FAILED], (4 * CYCLE, "PASSED"))})
    report = told(played("ros2-cpp"), faults=(fault("late", ours, theirs),))
    (found,) = report.faults
    assert [(each.time, each.value) for each in found.changes] == [(3 * CYCLE, "PASSED")]
    assert (found.outcomes[0].wrong, found.outcomes[0].name) == (2, FAILED)
    assert not report.is_equal


def test_who_died_in_a_later_fault_of_the_same_drive_has_done_the_same_before():
    report = told(
        played("ros2-cpp"), faults=(fault("early", played("simulate"), played("ros2-cpp", last_words="died")),)
    )
    assert report.faults[0].outcomes[0].is_same


# -- forms --------------------------------------------------------------------------------------------------------


def whole():
    faults = (fault("late <b>", played("simulate"), played("ros2-cpp", sent=changed(REQUEST, 1, "<i>"))),)
    return told(
        played("ros2-cpp", notes=("rclcpp: a subset",)),
        played("ros2-py", sent=changed(REQUEST, 5, "nan")),
        faults=faults,
    )


def test_json_has_everything_that_the_pages_tell():
    report = whole()
    assert read_report(to_json(report), "comparison.json") == report


@pytest.mark.parametrize(
    "data", [b"", b"[]", b"{}", b'{"sigcat": 1}', b"\xff", b"{" * 100_000, b" " * (COMPARISON_BYTES + 1)]
)
def test_what_is_no_comparison_is_refused_in_one_line(data):
    with pytest.raises(InputRefused) as refused:
        read_report(data, "comparison.json")
    assert "comparison.json" in str(refused.value)
    assert "\n" not in str(refused.value)


class _Tags(HTMLParser):
    VOID = frozenset(("meta", "link", "wbr", "br", "path", "rect"))

    def __init__(self):
        super().__init__()
        self.open, self.seen, self.classes = [], set(), set()

    def handle_starttag(self, tag, attrs):
        self.seen.add(tag)
        self.classes.update((dict(attrs).get("class") or "").split())
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag not in self.VOID:
            assert self.open.pop() == tag


def test_the_page_is_whole_and_needs_neither_a_script_nor_anything_from_outside():
    page = html_page(whole())
    tags = _Tags()
    tags.feed(page)
    assert not tags.open
    assert not tags.seen & {"script", "link", "img", "iframe", "object", "b", "i"}
    assert not re.search(r"https?://|url\(|@import|\son\w+=|\sstyle=", page)


@pytest.mark.parametrize("style", [SITE.read_text("utf-8"), STYLE], ids=["of the service", "of the page"])
def test_every_class_of_a_table_and_a_picture_is_known_to_both_styles(style):
    tags = _Tags()
    tags.feed(html_page(whole()))
    assert {each for each in tags.classes if f".{each}" not in style} - {"wide", "picture"} == set()


def test_markup_in_names_and_values_shows_as_text():
    page, text = html_page(whole()), markdown(whole())
    assert "late &lt;b&gt;" in page
    assert "late &lt;b&gt;" in text


def test_markdown_has_tables_whose_rows_have_as_many_cells_as_their_heads():
    tables = re.findall(r"(?:^\|.*\n)+", markdown(whole()), re.MULTILINE)
    assert len(tables) > 5
    for table in tables:
        assert len({len(re.findall(r"(?<!\\)\|", line)) for line in table.splitlines()}) == 1


def test_traces_of_all_platforms_lie_over_each_other_and_leave_a_gap_where_there_is_no_number():
    report = whole()
    (trace, *_) = report.traces
    assert [line.platform for line in trace.lines] == ["simulate", "ros2-cpp", "ros2-py"]
    assert None in [value for _, value in trace.lines[2].points]
    assert html_page(report).count('class="trace series-1" d="M') >= 2


@pytest.mark.parametrize("style", [STYLE, STYLESHEET.read_text("utf-8")], ids=["own page", "service"])
def test_each_platform_has_a_colour_and_a_kind_of_line(style):
    colours = re.findall(r"--series-(\d): ([^;]+);", style)
    lines = re.findall(r"\.trace\.series-(\d) \{([^}]+)\}", style)
    for found in (colours, lines):
        assert len({number for number, _ in found}) == len({look for _, look in found}) == SERIES
    assert len(RUNNERS) + 1 == SERIES  # a platform by hand


def test_titles_of_many_platforms_are_within_the_drawing():
    lines = tuple(Line(platform=f"platform{number}", points=((0, 1.0), (10, 2.0))) for number in range(7))
    names = {line.platform: "A platform with a long name" for line in lines}
    drawn = traces([Trace(name="Vehicle.Speed", lines=lines)], names)
    ((width, _),) = re.findall(r'viewBox="0 0 (\d+) (\d+)"', drawn)
    titles = re.findall(r'<text x="(\d+)" y="(\d+)">A platform', drawn)
    assert (len(titles), len(set(titles))) == (7, 7)
    assert all(int(x) + 7 * len("A platform with a long name") <= int(width) for x, _ in titles)


# -- how long it took ---------------------------------------------------------------------------------------------


def test_the_time_of_each_phase_is_told():
    report = told(played("ros2-cpp"), phases=(("build", 60.4), ("lock step", 20.0)))
    assert "The whole comparison took 100 s: build 60 s, lock step 20 s." in markdown(report)


@pytest.mark.parametrize(("steps", "said"), [(3, "as many"), (2, "1 fewer"), (4, "1 more")])
def test_steps_of_a_free_run_are_fewer_or_more(steps, said):
    values = tuple((time * CYCLE, "1.0") for time in range(3))
    freely = tuple((time * CYCLE // 2, "1.0") for time in range(steps))
    sound = played("simulate", sent={REQUEST: values})
    other = played("ros2-cpp", sent={REQUEST: values})
    recording = other.lock_step._replace(
        mode="free run", sent={REQUEST: ((0, "1.0"), *freely[1:-1], (2 * CYCLE, "1.0"))}
    )
    found = material(other._replace(free_run=recording))
    report = report_of(found._replace(platforms=(sound, *found.platforms[1:])))
    assert f"| {said} |" in markdown(report)


def test_a_criterion_with_too_few_figures_is_inconclusive_and_one_without_is_not_measured():
    short = report_of(material(played("ros2-cpp"))._replace(end_ns=END // 100))
    assert target(short, "outputs equal").measured
    assert target(short, "outputs equal").verdict == "inconclusive"
    assert re.search(r"outputs equal on all platforms.*\| inconclusive \|", markdown(short))
    missing = told(Played("ros2-cpp", "ROS 2, C++", left_out="get it"))
    assert target(missing, "outputs equal").verdict == "not measured"
    assert re.search(r"outputs equal on all platforms.*\| not measured \|", markdown(missing))
