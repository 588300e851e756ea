"""A library of many catalogues: each replaced whole, the last good state kept, readers never seeing a mix."""

import threading

import pytest

from sigcat import codes
from sigcat.catalogue.hosting import library as hosting
from sigcat.catalogue.hosting.library import Library, Source, Watch
from sigcat.errors import NotFound
from sigcat.function.hosting import FunctionLibrary
from tests.waiting import wait_until

ROOT = "Vehicle:\n  type: branch\n  description: A vehicle.\n"


def signal(name: str, text: str = "Something.") -> str:
    return f"Vehicle.{name}:\n  type: sensor\n  datatype: float\n  description: {text}\n"


@pytest.fixture
def tree(tmp_path):
    (tmp_path / "tree.vspec").write_text(f"{ROOT}#include part.vspec\n")
    (tmp_path / "part.vspec").write_text(signal("Speed"))
    (tmp_path / "overlay.vspec").write_text(signal("Height"))
    return tmp_path


@pytest.fixture
def library(tree):
    root = tree / "tree.vspec"
    return Library([Source("own", "Own", root, (tree / "overlay.vspec",)), Source("bare", "Bare", root)])


def leaves(library: Library, catalogue_id: str = "own") -> list[str]:
    return [node.name for node in library.get(catalogue_id).catalogue.nodes.values() if node.is_leaf]


def test_catalogues_stand_side_by_side_each_with_its_overlays(library):
    assert leaves(library, "own") == ["Speed", "Height"]
    assert leaves(library, "bare") == ["Speed"]
    assert library.default.source.id == "own"


def test_a_name_that_is_not_there_is_told_with_near_ones(library):
    with pytest.raises(NotFound) as missing:
        library.get("baer")
    assert missing.value.nearest == ("bare",)


def test_a_library_of_nothing_has_no_default():
    with pytest.raises(NotFound):
        _ = Library([]).default


def test_unchanged_files_are_not_read_again(library):
    before = library.get("own")
    assert library.reload_changed() == ()
    assert library.get("own") is before


@pytest.mark.parametrize("file", ["tree.vspec", "part.vspec"])
def test_a_changed_file_is_read_again_by_every_catalogue_that_includes_it(library, tree, file):
    with (tree / file).open("a") as opened:
        opened.write(signal("Width") if file == "tree.vspec" else "\n" + signal("Width"))
    assert library.reload_changed() == ("own", "bare")
    assert "Width" in leaves(library, "own")
    assert "Width" in leaves(library, "bare")
    assert library.reload_changed() == ()


def test_a_changed_overlay_concerns_its_catalogue_and_the_search_of_it(library, tree):
    bare = library.get("bare").catalogue
    (tree / "overlay.vspec").write_text(signal("Depth"))
    library.reload_changed()
    assert leaves(library) == ["Speed", "Depth"]
    assert [node.name for node in library.get("own").search_index.search("depth").nodes] == ["Depth"]
    assert library.get("bare").catalogue.nodes.keys() == bare.nodes.keys()


def test_units_that_appear_beside_the_tree_are_read(library, tree):
    (tree / "quantities.yaml").write_text("length:\n  definition: Extent.\n")
    (tree / "units.yaml").write_text(
        "m:\n  definition: Length.\n  unit: meter\n  quantity: length\n  allowed-datatypes: [numeric]\n"
    )
    assert library.reload_changed() == ("own", "bare")
    assert "m" in library.get("own").catalogue.vocabulary.units


def test_a_broken_edit_keeps_the_last_good_state_and_says_why(library, tree):
    good = library.get("own")
    (tree / "overlay.vspec").write_text("Vehicle.Height:\n  type: sensr\n")
    library.reload_changed()
    broken = library.get("own")
    assert broken.catalogue is good.catalogue
    assert broken.search_index is good.search_index
    assert [(f.rule, f.line) for f in broken.rejected] == [("V001", 2)]
    assert library.reload_changed() == ()


def test_a_mended_edit_takes_the_place_of_the_last_good_state(library, tree):
    (tree / "overlay.vspec").write_text("Vehicle.Height: [\n")
    library.reload_changed()
    (tree / "overlay.vspec").write_text(signal("Depth"))
    library.reload_changed()
    assert library.get("own").rejected == ()
    assert leaves(library) == ["Speed", "Depth"]


def test_an_edit_that_is_taken_back_clears_the_complaint_and_keeps_the_catalogue(library, tree):
    good = library.get("own")
    (tree / "overlay.vspec").write_text("Vehicle.Height: [\n")
    library.reload_changed()
    (tree / "overlay.vspec").write_text(signal("Height"))
    library.reload_changed()
    assert library.get("own").rejected == ()
    assert library.get("own").catalogue is good.catalogue


@pytest.mark.parametrize("file", ["part.vspec", "overlay.vspec", "tree.vspec"])
def test_a_file_that_goes_away_and_comes_back(library, tree, file):
    text = (tree / file).read_text()
    (tree / file).unlink()
    library.reload_changed()
    assert leaves(library) == ["Speed", "Height"]
    assert library.get("own").rejected
    (tree / file).write_text(text)
    library.reload_changed()
    assert library.get("own").rejected == ()


def test_a_file_that_an_edit_includes_before_it_exists_is_found_when_it_appears(library, tree):
    (tree / "tree.vspec").write_text(f"{ROOT}#include part.vspec\n#include more.vspec\n")
    library.reload_changed()
    assert [finding.rule for finding in library.get("own").rejected] == ["R008"]
    (tree / "more.vspec").write_text(signal("Width"))
    library.reload_changed()
    assert leaves(library) == ["Speed", "Width", "Height"]


def test_a_catalogue_that_was_never_good_shows_its_newest_state(tree):
    (tree / "tree.vspec").write_text("Vehicle:\n  type: brunch\n")
    library = Library([Source("own", "Own", tree / "tree.vspec")])
    (tree / "tree.vspec").write_text(f"{ROOT}Vehicle.Speed:\n  type: sensr\n")
    library.reload_changed()
    assert library.get("own").rejected == ()
    assert [f.path for f in library.get("own").catalogue.findings] == ["Vehicle.Speed"]
    (tree / "tree.vspec").write_text(ROOT)
    library.reload_changed()
    assert library.get("own").catalogue.findings == ()


def test_hosting_other_sources_keeps_the_catalogues_that_stay(library, tree):
    own = library.get("own")
    library.host([Source("new", "New", tree / "part.vspec"), own.source])
    assert [hosted.source.id for hosted in library] == ["new", "own"]
    assert library.get("own") is own


def test_of_a_changed_source_with_errors_the_last_good_state_stays_until_its_files_are_valid(library, tree):
    source = library.get("own").source
    (tree / "other.vspec").write_text("Vehicle.Height:\n  datatype: flaot\n")
    library.host([source._replace(overlays=(tree / "other.vspec",))])
    assert leaves(library) == ["Speed", "Height"]
    assert [finding.file for finding in library.get("own").rejected if finding.severity == "error"]
    (tree / "other.vspec").write_text(signal("Depth"))
    library.reload_changed()
    assert leaves(library) == ["Speed", "Depth"]
    assert library.get("own").rejected == ()


def test_refused_findings_are_shown_with_each_catalogue_until_they_are_taken_back(library, tree):
    finding = codes.NOT_TOML.finding("It is no TOML.", "sigcat.toml", 1)
    library.refuse((finding,))
    (tree / "overlay.vspec").write_text(signal("Depth"))
    library.reload_changed()
    assert leaves(library) == ["Speed", "Depth"]
    assert [hosted.rejected for hosted in library] == [(finding,)] * 2
    library.refuse(())
    assert [hosted.rejected for hosted in library] == [()] * 2


def test_findings_of_files_are_not_taken_back_with_those_that_are_refused(library, tree):
    (tree / "overlay.vspec").write_text("Vehicle.Height:\n  datatype: flaot\n")
    library.reload_changed()
    own = library.get("own").rejected
    library.refuse((codes.NOT_TOML.finding("It is no TOML.", "sigcat.toml", 1),))
    library.refuse(())
    assert library.get("own").rejected == own
    assert own


def test_a_file_that_may_be_half_written_is_read_once_it_is_the_same_at_two_looks(library, tree):
    """Each look sees another state of a file that is truncated, and then written line by line; all of them are valid."""
    library.reload_settled()
    good, overlay = library.get("own"), tree / "overlay.vspec"
    for text in ("", signal("Depth"), signal("Depth") + signal("Width")):
        overlay.write_text(text)
        assert library.reload_settled() == ()
        assert library.get("own") is good
    assert library.reload_settled() == ("own",)
    assert leaves(library) == ["Speed", "Depth", "Width"]
    assert library.reload_settled() == ()


def test_a_file_that_changes_while_it_is_read_is_read_again(library, tree, monkeypatch):
    library.reload_settled()
    good, overlay, load = library.get("own"), tree / "overlay.vspec", hosting.load
    overlay.write_text(signal("Depth"))

    def write_meanwhile(*arguments):
        catalogue = load(*arguments)
        overlay.write_text(signal("Depth") + signal("Width"))
        return catalogue

    monkeypatch.setattr(hosting, "load", write_meanwhile)
    assert library.reload_settled() == library.reload_settled() == ()
    assert library.get("own") is good
    monkeypatch.undo()
    assert library.reload_settled() == ()
    assert library.reload_settled() == ("own",)
    assert leaves(library) == ["Speed", "Depth", "Width"]


@pytest.mark.parametrize("file", ["part.vspec", "overlay.vspec"])
def test_a_file_that_is_emptied_is_an_error_and_the_last_good_state_stays(library, tree, file):
    """An interrupted save leaves an empty file, which is valid."""
    good, text = library.get("own"), (tree / file).read_text()
    (tree / file).write_text("")
    library.reload_changed()
    emptied = library.get("own")
    assert emptied.catalogue is good.catalogue
    found = [(each.rule, each.severity, each.file) for each in emptied.rejected]
    assert found == [("R013", "error", str(tree / file))]
    library.host([good.source._replace(title="Another")])
    assert leaves(library) == ["Speed", "Height"]
    (tree / file).write_text(text)
    library.reload_changed()
    assert library.get("own").rejected == ()


def test_a_watch_reads_changed_files_again(library, tree):
    with Watch(library, seconds=0.02):
        (tree / "overlay.vspec").write_text(signal("Depth"))
        wait_until(lambda: leaves(library) == ["Speed", "Depth"], "the changed overlay is read")


def test_a_watch_looks_at_each_of_several(library, tree, tmp_path):
    functions = FunctionLibrary([tmp_path / "functions"], has_shipped=False)
    with Watch(library, functions, seconds=0.02):
        (tmp_path / "functions").mkdir()
        (tmp_path / "functions" / "a.function.yaml").write_text("function: A\n")
        wait_until(lambda: [file.id for file in functions.files] == ["a"], "the new function is read")


def test_a_watch_outlives_what_goes_wrong(library, tree, monkeypatch, caplog):
    def fail():
        raise RuntimeError("disk on fire")

    monkeypatch.setattr(library, "reload_settled", fail)
    with Watch(library, seconds=0.01):
        wait_until(lambda: "disk on fire" in caplog.text, "the failure is logged")
        monkeypatch.undo()
        (tree / "overlay.vspec").write_text(signal("Depth"))
        wait_until(lambda: leaves(library) == ["Speed", "Depth"], "the changed overlay is read")


def test_readers_never_see_a_mix(library, tree):
    """Two signals change together, again and again; whoever reads sees both of one state."""
    faults = []
    done = threading.Event()

    def read():
        while not done.is_set():
            hosted = library.get("bare")
            texts = {n.values["description"] for n in hosted.catalogue.nodes.values() if n.is_leaf}
            found = {n.values["description"] for n in hosted.search_index.search("signal").nodes if n.is_leaf}
            if len(texts) != 1 or (found and found != texts):
                faults.append((texts, found))

    part = tree / "part.vspec"
    part.write_text(signal("SignalA", "State 0.") + signal("SignalB", "State 0."))
    library.reload("bare")
    readers = [threading.Thread(target=read) for _ in range(4)]
    for reader in readers:
        reader.start()
    for state in range(1, 30):
        part.write_text(signal("SignalA", f"State {state}.") + signal("SignalB", f"State {state}."))
        library.reload("bare")
    done.set()
    for reader in readers:
        reader.join()
    assert faults == []
    assert library.get("bare").catalogue.nodes["Vehicle.SignalA"].values["description"] == "State 29."
