"""A function to start from: a function.yaml that names its JSON Schema and defines an interface of every category, and C code."""

import json
import re
from collections.abc import Mapping

from sigcat.errors import UsageError
from sigcat.function.declaration.declaration import declaration_schema
from sigcat.names import camel_case

SCHEMA_FILE = "function.schema.json"
"""Name of the schema beside the scaffold."""

_NAME = re.compile(r"[A-Z][A-Za-z0-9]{0,99}")
_ADDRESS = re.compile(r"[!-~]+")
_MARK = "__NAME__"

_TEXT = """\
# yaml-language-server: $schema=__SCHEMA__

function: __NAME__
description: Says in one sentence what the function does.
responsible: Name of a team
version: 0.1.0

# How the C code is compiled and called: by pointers or as members of a C++ class, too.
code:
  signature: globals
  sources: [__NAME__.c]
  headers: [__NAME__.h]

# Interfaces that the catalogue does not have yet. `sigcat function overlay` makes an overlay of them for others.
define:
  parameters:
    Gain:
      datatype: float
      min: 0.0
      max: 1.0
      default: 0.5
      asil: QM
      description: Gain of the controller.
  errors:
    SpeedTimeout:
      maturationTime: 100
      severity: The function is off until the speed is received again.
      resetTime: 500
      resetCondition: The speed is received in every cycle again.
      asil: QM
      description: The speed has not been received in time.
    AliveError:
      maturationTime: 0
      severity: The function is off until the next start.
      resetTime: 0
      resetCondition: The function has been restarted.
      asil: QM
      description: The step ran too seldom or too often.
  safetyReactions:
    __NAME__Invalid:
      errorList: [SpeedTimeout, AliveError]
      asil: QM
      description: The outputs of the function are not valid.
  modes:
    in: {allowed: ['OFF', 'ON'], description: Mode that the function has to take.}
    out: {allowed: ['OFF', 'ON', 'FAULT'], description: Mode that the function is in.}
  scheduling:
    Init:
      priority: 20
      scheduling: NonPreemptive
      asil: QM
      description: Sets the outputs to their start values.
    Step:
      cycleTime: 20
      priority: 10
      scheduling: Preemptive
      asil: QM
      aliveSupervision: {minIndications: 9, referenceIndications: 10, maxIndications: 11, error: AliveError}
      stackSize: 4096
      description: Computes the outputs.
    Terminate:
      priority: 30
      scheduling: NonPreemptive
      asil: QM
      description: Gives resources back.

components:
  - name: __NAME__
    runnables:
      - __NAME___Init
      - interface: __NAME___Step
        # Datatype, unit, range and description come from the catalogue: `sigcat show Vehicle.Speed`.
        data:
          - path: Vehicle.Speed
            role: consumed
            variable: __NAME___in.speed
            asil: QM
            timeout: 100
            timeoutError: __NAME___SpeedTimeout_ErrorSts
            rangeErrorAction: Init
            init: 0.0
        parameters:
          - path: Vehicle.Function.__NAME__.Parameter.Gain
            variable: __NAME___par.gain
        errors: [__NAME___SpeedTimeout_ErrorSts, {interface: __NAME___AliveError_ErrorSts, reset: restart}]
        safetyReactions: [{interface: __NAME__Invalid_SftyCondSts, variable: __NAME___in.isInvalid}]
      - __NAME___Terminate

modes:
  interfaces: [__NAME___Mode_In, __NAME___Mode_Out]
  in: {variable: __NAME___in.mode, initial: 'OFF'}
  out: {variable: __NAME___out.mode}
  active:
    - mode: 'OFF'
      description: The function is not used.
      runnables: []
    - mode: 'ON'
      description: The function runs.
      runnables: [__NAME___Step]
"""
_HEADER = """\
/* The variables and calls that function.yaml declares. An adapter writes the inputs before each call, and reads the
   outputs after it. */
#ifndef __NAME___H
#define __NAME___H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { __NAME___IN_OFF, __NAME___IN_ON };
enum { __NAME___OUT_OFF, __NAME___OUT_ON, __NAME___OUT_FAULT };

typedef struct {
  float speed;    /* Vehicle.Speed, km/h */
  bool isInvalid; /* __NAME__Invalid_SftyCondSts: the outputs are not valid */
  uint8_t mode;   /* __NAME___Mode_In */
} __NAME___Inputs;

typedef struct {
  float gain; /* Vehicle.Function.__NAME__.Parameter.Gain, 0 to 1 */
} __NAME___Parameters;

typedef struct {
  uint8_t mode; /* __NAME___Mode_Out */
} __NAME___Outputs;

extern __NAME___Inputs __NAME___in;
extern __NAME___Parameters __NAME___par;
extern __NAME___Outputs __NAME___out;

void __NAME___Init(void);
void __NAME___Step(void); /* every 20 ms */
void __NAME___Terminate(void);

#ifdef __cplusplus
}
#endif

#endif
"""
_SOURCE = """\
#include "__NAME__.h"

__NAME___Inputs __NAME___in;
__NAME___Parameters __NAME___par = {0.5f};
__NAME___Outputs __NAME___out;

void __NAME___Init(void)
{
  __NAME___out.mode = __NAME___OUT_OFF;
}

void __NAME___Step(void)
{
  if (__NAME___in.isInvalid) {
    __NAME___out.mode = __NAME___OUT_FAULT;
    return;
  }
  __NAME___out.mode = __NAME___in.mode == __NAME___IN_ON ? __NAME___OUT_ON : __NAME___OUT_OFF;
  /* To do: compute the outputs from __NAME___in.speed and __NAME___par.gain. */
}

void __NAME___Terminate(void)
{
}
"""
_CODE = {".h": _HEADER, ".c": _SOURCE}


def code_scaffold(name: str) -> Mapping[str, str]:
    """Return the C code for the same function, by the name of its file. Raises UsageError."""
    return {f"{checked_name(name)}{ending}": text.replace(_MARK, name) for ending, text in _CODE.items()}


def scaffold(name: str, schema: str = SCHEMA_FILE) -> str:
    """The text for a function of this name; `schema` is the address of its JSON Schema. Raises UsageError."""
    return _TEXT.replace("__SCHEMA__", checked_schema(schema)).replace(_MARK, checked_name(name))


def checked_name(name: str) -> str:
    """A name that a function may have. Raises UsageError."""
    if not _NAME.fullmatch(name):
        better = camel_case(name)
        hint = f": {better!r}, for example" if _NAME.fullmatch(better) else ""
        raise UsageError(f"The name of a function must be CamelCase, not {name!r}{hint}")
    return name


def checked_schema(schema: str) -> str:
    """An address that the first line of the file may have. Raises UsageError."""
    if not _ADDRESS.fullmatch(schema):
        raise UsageError(f"The address of a schema must be printable ASCII without spaces, not {schema!r}")
    return schema


def schema_text() -> str:
    """The JSON Schema of function.yaml."""
    return json.dumps(declaration_schema(), indent=2, ensure_ascii=False) + "\n"
