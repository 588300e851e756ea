"""Material to a report."""

from collections.abc import Iterator, Sequence

from sigcat import __version__
from sigcat.comparison.report import model
from sigcat.comparison.telling.behaviours import behaviours, faults, free_runs, traces
from sigcat.comparison.telling.beside_paper import beside_paper
from sigcat.comparison.telling.figures import effort, ends_to_ends, processes, supervisions, timings, translations
from sigcat.comparison.telling.material import Material, Played
from sigcat.comparison.telling.targets import other_work, targets


def report_of(material: Material) -> model.Report:
    """Everything that was measured, then what it means."""
    measured = model.Report(
        sigcat=__version__,
        name=material.name,
        functions=material.functions,
        trace=material.trace,
        machine=material.machine,
        reference=material.reference.name,
        platforms=tuple(_platform(each) for each in material.platforms),
        seconds=material.seconds,
        phases=material.phases,
        behaviour=tuple(behaviours(material)),
        free_run=tuple(free_runs(material)),
        traces=tuple(traces(material)),
        faults=tuple(faults(material)),
        timing=tuple(timings(material)),
        supervision=tuple(supervisions(material)),
        measured=(*translations(material), *ends_to_ends(material)),
        processes=tuple(processes(material)),
        effort=tuple(effort(material)),
    )
    return judged(measured, material.notes)


def judged(measured: model.Report, notes: Sequence[str] = ()) -> model.Report:
    """Add the conclusions to a report: acceptance criteria, the paper's figures, and notes for readers."""
    held = tuple(targets(measured))
    told = (*_notes(measured, held), *notes)
    return measured.model_copy(update={"targets": held, "paper": tuple(beside_paper(measured)), "notes": told})


def _platform(played: Played) -> model.Platform:
    built, recordings = played.built, played.recordings
    return model.Platform(
        name=played.name,
        title=played.title,
        notes=built.notes if built else (),
        left_out=played.left_out,
        build_error=played.build_error,
        last_words=tuple(each.last_words[:2000] for each in recordings if each.last_words),
        silent=tuple(dict.fromkeys(name for each in recordings for name in each.silent)),
        generate_s=built.generate_s if built else 0.0,
        build_s=built.build_s if built else 0.0,
        play_s=sum(each.play_s for each in recordings),
        is_by_hand=played.is_by_hand,
    )


def _notes(measured: model.Report, held: Sequence[model.Target]) -> Iterator[str]:
    """Yield notes to read before the table."""
    failing = [each.what for each in held if each.holds is False]
    unknown = [each.what for each in held if each.holds is None and not each.measured]
    open_ones = [each.what for each in held if each.holds is None and each.measured]
    if failing:
        yield f"Failed: {'; '.join(failing)}."
    if unknown:
        yield f"Not measured: {'; '.join(unknown)}."
    if open_ones:
        yield f"Inconclusive: {'; '.join(open_ones)}."
    if not (failing or unknown or open_ones):
        yield f"All {len(held)} acceptance criteria were measured and passed."
    doubt = other_work(measured)
    if doubt:
        yield f"Of timing and load the report says little: {doubt}."
    for each in measured.platforms:
        if each.left_out:
            yield f"{each.title} is left out: {each.left_out}"
