"""Figures of the paper (section 5.6), with the place of each and the differences of the set-up."""

from typing import NamedTuple

RIG = (
    "the paper: open loop from a CAN log, gateway, two computers and a network between them, containers, commercial tools; "
    "here: one machine, one process for each function, loopback"
)


class Figure(NamedTuple):
    """One figure."""

    key: str
    what: str
    place: str
    text: str
    differs: str
    value: float | None = None
    """In the unit of the measured figure: ns, a share of a core, lines, seconds."""


_ALL = (
    Figure(
        "behaviour", "differences of the outputs between platforms", "5.6.1, figures 16 and 17",
        "no measurable difference, of two signals that are drawn",
        "the paper compares pictures of synchronized logs; here every bit of every value of every step",
    ),
    Figure(
        "adapter CoreAcc", "function adapter, CoreAcc, median", "5.6.2, figure 18, middle right", "about 300 µs on both platforms",
        RIG + "; what the paper counts as adapter is not said to the line", 300_000.0,
    ),
    Figure(
        "adapter EcoControlMpc", "function adapter, MPC, median", "5.6.2, figure 18, bottom", "about 200 µs", RIG, 200_000.0,
    ),
    Figure(
        "logic CoreAcc", "logic of CoreAcc, median", "5.6.2, figure 18, top right", "about 100 µs on all three",
        "another implementation of CoreAcc: the paper's is not public", 100_000.0,
    ),
    Figure(
        "gateway", "CAN to middleware, median", "5.6.2, figure 18, top left",
        "302 µs (AUTOSAR adaptive), 423 µs (ROS 2), 434 µs (baseline); up to 23,000 µs",
        "the paper: SocketCAN to one service on a gateway board; here: a log on the same machine", 302_000.0,
    ),
    Figure(
        "cpu CoreAcc", "processor load of CoreAcc, median", "5.6.2, figure 19, top right",
        "about 5 % (ROS 2 and baseline), 15 % (AUTOSAR adaptive)", RIG + "; the paper's computer has 20 cores", 0.05,
    ),
    Figure(
        "cpu EcoControlMpc", "processor load of MPC, median", "5.6.2, figure 19, bottom",
        "about 4 % (ROS 2 and baseline), 40 % (AUTOSAR adaptive)", RIG, 0.04,
    ),
    Figure(
        "memory CoreAcc", "memory of CoreAcc", "5.6.2, figure 20, top right", "about 0.2 % of 32 GB (64 MB)",
        "the paper: of a container", 64e6,
    ),
    Figure(
        "memory EcoControlMpc", "memory of MPC", "5.6.2, figure 20, bottom", "about 0.15 % of 32 GB (48 MB)",
        "the paper: of a container", 48e6,
    ),
    Figure(
        "lines ROS 2", "function adapter for ROS 2, lines by hand", "5.6.3", "1,250 (CoreAcc) and 600 (MPC); 95 % could be generated",
        "what the paper counts as a line is not said; here without blank lines and comments", 1850.0,
    ),
    Figure(
        "lines AUTOSAR", "AUTOSAR adaptive, lines by hand", "5.6.3",
        "1,000 of mapping, beside 3,500 that the Application Framework generates (162 events)",
        "the published set has 18 services with 162 events; the shipped example has fewer signals", 1000.0,
    ),
    Figure(
        "hours", "configuration of AUTOSAR adaptive", "5.6.3", "3 hours by hand, less than 1 minute with the Model Configurator",
        "the paper: a project in DaVinci Developer Adaptive; here ARXML and sources of the same set", 10_800.0,
    ),
)  # fmt: skip
FIGURES = {each.key: each for each in _ALL}
