"""Timing, load and effort of platforms, as a report tells them."""

from collections import Counter
from collections.abc import Iterator, Sequence

from sigcat.comparison.effort import count_lines
from sigcat.comparison.recording import Built, CallTime, Recording
from sigcat.comparison.report import model
from sigcat.comparison.telling.material import Material
from sigcat.comparison.timing import Distribution, distribution

SUPERVISION_TOLERANCE_NS = 1_000_000
"""Added to the longest period of `Supervise` (docs/reference/adapter.md, §10)."""


def timings(material: Material) -> Iterator[model.Timing]:
    """Each call of each platform, in each run."""
    for each in material.platforms:
        for recording in each.recordings:
            for call in dict.fromkeys(time.call for time in recording.calls):
                yield from _timing(recording, [time for time in recording.calls if time.call == call])


def _timing(recording: Recording, times: Sequence[CallTime]) -> Iterator[model.Timing]:
    t_exec = distribution(each.t_exec_ns for each in times)
    t_adapter = distribution(each.t_adapter_ns for each in times)
    t_logic = distribution(each.t_logic_ns for each in times)
    alone = [each for each in times if not each.is_preempted]
    t_alone = distribution(each.t_adapter_ns for each in alone) if len(alone) < len(times) else None
    if t_exec and t_adapter and t_logic:
        yield model.Timing(
            platform=recording.platform,
            mode=recording.mode,
            function=times[0].function,
            call=times[0].call,
            t_exec=_durations(t_exec),
            t_adapter=_durations(t_adapter),
            t_logic=_durations(t_logic),
            preempted=len(times) - len(alone),
            t_adapter_alone=_durations(t_alone) if t_alone else None,
        )


def _durations(found: Distribution) -> model.Durations:
    return model.Durations(**found._asdict())


def supervisions(material: Material) -> Iterator[model.Supervision]:
    """Times between calls of `Supervise`, on each platform, in each run."""
    for played in material.platforms:
        for recording in played.recordings:
            for each in recording.supervised:
                if each.gaps_ns:
                    yield model.Supervision(
                        platform=played.name,
                        mode=recording.mode,
                        function=each.function,
                        call=each.call,
                        period=each.period_ns,
                        gaps=len(each.gaps_ns),
                        over=sum(gap > each.period_ns + SUPERVISION_TOLERANCE_NS for gap in each.gaps_ns),
                        longest=max(each.gaps_ns),
                    )


def translations(material: Material) -> Iterator[model.Measured]:
    """Yield the times of the gateway, for a drive that was logged on CAN."""
    found = distribution(material.translation_ns)
    if found:
        yield model.Measured(
            name="gateway",
            platform="sigcat gateway",
            description="from a frame of CAN to its row of the trace",
            durations=_durations(found),
        )


def ends_to_ends(material: Material) -> Iterator[model.Measured]:
    """From rows of the drive to what depends on them, on each platform that kept its own time."""
    for each in material.platforms:
        for function, ages in (each.free_run.end_to_end if each.free_run else {}).items():
            found = distribution(ages)
            if found:
                yield model.Measured(
                    name=f"end to end, {function}",
                    platform=each.name,
                    description="from the newest row of the drive that a call has seen, to its value at the player; in free run",
                    durations=_durations(found),
                )


def processes(material: Material) -> Iterator[model.Process]:
    """Each process of each platform, in each run."""
    for each in material.platforms:
        seen: Counter[str] = Counter()
        for recording in (*each.recordings, *each.repeats):
            run = seen[recording.mode]
            seen[recording.mode] += 1
            for process in recording.processes:
                yield model.Process(
                    platform=each.name,
                    mode=recording.mode,
                    name=process.name,
                    cpu_s=process.cpu_s,
                    drive_s=driven_seconds(recording, material),
                    peak=process.peak_rss_bytes,
                    size=process.executable_bytes,
                    is_player=process.is_player,
                    run=run,
                )


def driven_seconds(recording: Recording, material: Material) -> float:
    """Return the seconds of the drive until the run ended."""
    if recording.mode == "lock step" and not recording.last_words:
        return material.drive_seconds
    return max((values[-1][0] for values in recording.sent.values() if values), default=0) / 1e9


def effort(material: Material) -> Iterator[model.Lines]:
    """Lines that people wrote, then those that were generated for each platform."""
    for each in material.written:
        yield _lines(each.what, "person", each.platform, tuple(each.lines))
    for played in material.platforms:
        if played.built and played.built.generated and not played.is_by_hand:
            yield _lines("generated files", "sigcat", played.name, tuple(count_lines(_texts(played.built))))


def _lines(what: str, by: str, platform: str, counted: tuple[int, ...]) -> model.Lines:
    files, code, total = counted
    return model.Lines(what=what, by=by, platform=platform, files=files, code=code, total=total)  # type: ignore[arg-type]


def _texts(built: Built) -> Iterator[tuple[str, str]]:
    for file in built.generated:
        yield file.name, file.data.decode("utf-8", "replace")
