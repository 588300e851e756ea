"""The paper's figures, and what was measured here beside each."""

from collections.abc import Iterator

from sigcat.comparison.paper import FIGURES, Figure
from sigcat.comparison.report import model
from sigcat.comparison.report.words import duration, memory, percent
from sigcat.comparison.running.by_hand import NAME as BASELINE
from sigcat.comparison.running.table import RUNNERS


def beside_paper(told: model.Report) -> Iterator[model.PaperFigure]:
    """Figures of the paper that have a measured counterpart."""
    for figure in FIGURES.values():
        ours = _ours(figure, told)
        if ours:
            yield model.PaperFigure(
                what=figure.what, place=figure.place, paper=figure.text, ours=ours, differs=figure.differs
            )


def _ours(figure: Figure, told: model.Report) -> str:
    kind, _, function = figure.key.partition(" ")
    return {
        "behaviour": _behaviour,
        "adapter": _timing,
        "logic": _timing,
        "cpu": _load,
        "memory": _load,
        "lines": _lines,
        "hours": _generated,
        "gateway": _gateway,
    }[kind](told, kind, function)


def _behaviour(told: model.Report, _kind: str, _function: str) -> str:
    own = [each for each in told.behaviour if each.values]
    return "; ".join(f"{told.title_of(each.platform)}: {each.wrong:,} of {each.values:,} values differ" for each in own)


def _gateway(told: model.Report, kind: str, _function: str) -> str:
    found = [each for each in told.measured if each.name == kind]
    return "; ".join(f"{told.title_of(each.platform)}: {duration(each.durations.p50)}" for each in found)


def _timing(told: model.Report, kind: str, function: str) -> str:
    found = [each for each in told.timing if each.function == function and each.platform != told.reference]
    best: dict[str, model.Timing] = {each.platform: each for each in found}
    return "; ".join(
        f"{told.title_of(name)}: {duration(getattr(each, f't_{kind}').p50)}" for name, each in best.items()
    )


def _load(told: model.Report, kind: str, function: str) -> str:
    found = [each for each in told.processes if function.lower() in _bare(each.name) and not each.is_player]
    best: dict[str, model.Process] = {each.platform: each for each in found}
    return "; ".join(
        f"{told.title_of(name)}: {percent(each.share) + f' ({each.mode})' if kind == 'cpu' else memory(each.peak)}"
        for name, each in best.items()
    )


def _bare(name: str) -> str:
    return name.lower().replace("_", "")


def _lines(told: model.Report, _kind: str, platform: str) -> str:
    own = [name for name, runner in RUNNERS.items() if runner.paper_platform == platform]
    found = [each for each in told.effort if each.by == "sigcat" and each.platform in own]
    has_baseline = any(RUNNERS[name].has_baseline for name in own)
    by_hand = [each for each in told.effort if has_baseline and each.by == "person" and each.platform == BASELINE]
    texts = [f"{told.title_of(each.platform)}: 0 by hand, {each.code:,} generated" for each in found]
    return "; ".join([*texts, *(f"nodes by hand: {each.code:,}" for each in by_hand)])


def _generated(told: model.Report, _kind: str, _function: str) -> str:
    own = [name for name, runner in RUNNERS.items() if runner.paper_platform == "AUTOSAR"]
    found = [each for each in told.platforms if each.name in own and not each.left_out]
    return "; ".join(f"{each.title}: {each.generate_s:.2f} s to generate" for each in found)
