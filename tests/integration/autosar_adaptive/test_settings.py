"""Settings of the deployment file for AUTOSAR adaptive, and the places of findings about invalid ones."""

import pytest

from sigcat.errors import InputRefused
from sigcat.platforms.deployment_file import read_deployment

BAD = {
    "release: R19-11": (2, "`release` must be 'R20-11', 'R21-11'"),
    "namespace: 'eco.control'": (2, "`namespace` must be C++ namespaces such as eco::control, not 'eco.control'."),
    "namespace: 'eco::class'": (2, "`namespace` must not contain keywords of C++, and not begin with ara or std"),
    "typeNamespace: 'std::eco'": (2, "`typeNamespace` must not contain keywords of C++, and not begin with ara or std"),
    "transformation: {byteOrder: big}": (2, "`byteOrder` must be 'big-endian' or 'little-endian', not 'big'."),
    "transformation: {stringLength: 0}": (2, "`stringLength` must be 1, 2 or 4, not 0."),
    "transformation: {alignment: 7}": (2, "`alignment` must be 8, 16, 32, 64, 128 or 256, not 7."),
    "serviceDiscovery:\n    initialDelayMin: 500\n    initialDelayMax: 50": (
        4, "`initialDelayMax` must be at least `initialDelayMin`, 500 ms, not 50 ms.",
    ),
    "serviceDiscovery:\n    responseDelayMin: 500": (3, "`responseDelayMax` must be at least `responseDelayMin`, 500 ms"),
    "serviceDiscovery:\n    repetitionsBaseDelay: 0": (3, "`repetitionsBaseDelay` must be more than 0"),
    "serviceDiscovery:\n    offerCyclicDelay: 5000": (3, "`offerTimeToLive` must be longer than `offerCyclicDelay`, 5000 ms, not 3 s"),
    "serviceDiscovery: {offerTimeToLive: 0}": (2, "`offerTimeToLive` must be 1 or more, not 0."),
    "components: {Acc: {startup: {policy: SCHED_OTHER, priority: 5}}}": (2, "`priority` must be 0 for SCHED_OTHER, not 5."),
    "components: {Acc: {startup: {policy: SCHED_RR, priority: 0}}}": (2, "`priority` must be from 1 to 99 for SCHED_RR, not 0."),
    "components: {Acc: {startup: {priority: 100}}}": (2, "`priority` must be 99 or less, not 100."),
    "units: {knots: {factor: 0}}": (2, "`factor` must not be 0."),
    "units: {knots: {length: 1}}": (2, "'factor' is missing."),
    "components: {Acc: {startup: {policy: FIFO}}}": (2, "`policy` must be 'SCHED_FIFO', 'SCHED_RR' or 'SCHED_OTHER'"),
}  # fmt: skip


@pytest.mark.parametrize("text", BAD)
def test_what_cannot_be_is_told_at_its_line(text):
    line, message = BAD[text]
    with pytest.raises(InputRefused) as refused:
        read_deployment(f"autosarAdaptive:\n  {text}\n".encode(), "deployment.yaml")
    (finding,) = refused.value.findings
    assert finding.message.startswith(message)
    assert finding.line == line
