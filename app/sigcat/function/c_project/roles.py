"""Role of a variable: input, output, parameter, or none. Names of Simulink tell it, or words in a name."""

import re
from typing import Literal

from sigcat.names import words

Role = Literal["input", "output", "parameter", "model", "internal", ""]

_TYPES: tuple[tuple[Role, "re.Pattern[str]"], ...] = (
    ("input", re.compile(r"(?:ExtU|ExternalInputs?)(?:_\w*)?")),
    ("output", re.compile(r"(?:ExtY|ExternalOutputs?)(?:_\w*)?")),
    ("parameter", re.compile(r"(?:P|Parameters|InstP)(?:_\w*)?_?")),
    ("model", re.compile(r"(?:RT_MODEL|tag_RTM|rtModel)(?:_\w*)?")),
    (
        "internal",
        re.compile(
            r"(?:B|DW|D_Work|X|XDot|XDis|PeriodicIndX|PeriodicRngX|ConstP|ConstB|ConstInitP|ConstParam\w*|ConstBlockIO|"
            r"BlockIO|PrevZCX|PrevZCSigStates|ZCE|ZCV|ZCSigState|ContinuousStates|StateDerivatives|StateDisabled|"
            r"MdlrefDW|rtDW|rtB)(?:_\w*)?"
        ),
    ),
)
"""Types as Simulink names them, in the order in which they are tried."""
_HEADINGS: tuple[tuple[Role, "re.Pattern[str]"], ...] = (
    ("input", re.compile(r"External inputs|root inports? signals", re.IGNORECASE)),
    ("output", re.compile(r"External outputs|root outports? fed", re.IGNORECASE)),
    ("internal", re.compile(r"Constant parameters|Invariant block signals|constant block i/o", re.IGNORECASE)),
    ("parameter", re.compile(r"\bparameters? \((?:auto|default)|block parameters|tunable parameters", re.IGNORECASE)),
    ("model", re.compile(r"Real-time Model (?:object|Data)", re.IGNORECASE)),
    (
        "internal",
        re.compile(
            r"Block signals \((?:auto|default)|^Block (?:signals and )?states|Continuous states|zero-crossing|"
            r"State derivatives|model-wide|^Block signals$|^Block states$",
            re.IGNORECASE,
        ),
    ),
)
"""Comments of Simulink above a group of declarations."""
_WORDS: dict[Role, frozenset[str]] = {
    "input": frozenset(("in", "input", "inputs", "inp", "inport", "inports", "u", "inbus")),
    "output": frozenset(("out", "output", "outputs", "outp", "outport", "outports", "y", "outbus")),
    "parameter": frozenset(
        ("par", "pars", "param", "params", "parameter", "parameters", "cal", "calib", "calibration", "cfg", "config",
         "configuration", "tunables", "p")
    ),
    "internal": frozenset(("dw", "dwork", "state", "states", "work", "internal", "b", "priv", "private")),
    "model": frozenset(("m", "self", "this", "instance", "inst", "ctx", "context", "handle", "me", "obj", "model")),
}  # fmt: skip
_NOT_A_NUMBER = re.compile(r"rt(?:Inf|MinusInf|NaN)F?|rtX|rt_\w+")


def is_model_of_the_generator(type_name: str) -> bool:
    """Whether a type is the one that Simulink makes for a model, with its timing and its error status."""
    return any(role == "model" and pattern.fullmatch(type_name) for role, pattern in _TYPES)


def is_of_the_generator(name: str) -> bool:
    """Whether a variable has a name of Simulink for what no model has as an input or an output."""
    return bool(_NOT_A_NUMBER.fullmatch(name))


def role_of(name: str, type_name: str, heading: str = "") -> Role:
    """The role of a variable, a member or a parameter by its type, the comment above it, or its own name."""
    for rules, text in ((_TYPES, type_name.rpartition("::")[2]), (_HEADINGS, heading)):
        for role, pattern in rules:
            if pattern.fullmatch(text) if rules is _TYPES else pattern.search(text):
                return role
    return role_of_words(name) or role_of_words(re.sub(r"_(?:T|t|s|st|type|Type)$", "", type_name))


def role_of_words(name: str) -> Role:
    """The role that the last word of a name tells, or else the first one: `core_inputs`, `in_speed` is none."""
    found = [word.lower() for word in words(name.rpartition("::")[2])]
    for word in found[-1:]:
        for role, known in _WORDS.items():
            if word in known:
                return role
    return ""
