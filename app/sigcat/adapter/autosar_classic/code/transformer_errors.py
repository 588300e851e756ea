"""The result of end-to-end protection, as the RTE returns it: whether the core receives or rejects a message.

docs/explanation/autosar-classic.md states the rule. SWS_Rte says when data are delivered, SWS_E2ETransformer what an
error code means.
"""

from collections.abc import Sequence

from sigcat.adapter.autosar_classic.code.names import at_core, static
from sigcat.adapter.autosar_classic.code.plan import DataEnd, SwcPlan
from sigcat.adapter.core.c.lines import Lines, block, joined, lines

_SAFETY = "2U"
"""Class of the end-to-end transformer: vendors call it STD_TRANSFORMER_SAFETY or RTE_TRANSFORMER_SAFETY."""


def functions(taken: Sequence[DataEnd], swc: SwcPlan) -> list[Lines]:
    """The rule, once for all ports that a component reads with transformer errors."""
    return [_verdict(swc)] if any(end.has_transformer_errors for end in taken) else []


def _constant(name: str, swc: SwcPlan) -> str:
    return static(swc, f"MESSAGE_{name}")


def _verdict(swc: SwcPlan) -> Lines:
    none, accepted, rejected = (_constant(each, swc) for each in ("NONE", "ACCEPTED", "REJECTED"))
    type_ = static(swc, "Verdict")
    return lines(f"""
        typedef enum {{ {none}, {accepted}, {rejected} }} {type_};

        /* Whether a message was received and may be used. An error code of the safety class is a state and a check. */
        static {type_} {static(swc, "CheckMessage")}(Std_ReturnType status, Std_TransformerError error)
        {{
            const uint8 state = (uint8)(error.errorCode & 0xF0U);
            const uint8 check = (uint8)(error.errorCode & 0x0FU);
            const boolean is_soft = (status == RTE_E_SOFT_TRANSFORMER_ERROR) ? TRUE : FALSE;
            {type_} verdict = {none};

            if (status == RTE_E_HARD_TRANSFORMER_ERROR) {{
                verdict = {rejected};
            }} else if ((is_soft != FALSE) && (error.transformerClass == {_SAFETY})) {{
                if (check == 5U) {{
                    verdict = {none}; /* no new data */
                }} else if (check != 0U) {{
                    verdict = {rejected}; /* repeated, wrong sequence, wrong CRC, or not checked */
                }} else if ((state == 0x00U) || (state == 0x60U)) {{
                    verdict = {accepted}; /* VALID, or no state machine */
                }} else if ((state == 0x20U) || (state == 0x30U)) {{
                    verdict = {none}; /* NODATA, INIT: too few messages yet; the time-out of the core decides */
                }} else {{
                    verdict = {rejected}; /* INVALID */
                }}
            }} else if ((status == RTE_E_OK) || (is_soft != FALSE)) {{
                verdict = {accepted};
            }} else {{
                verdict = {none};
            }}
            return verdict;
        }}
    """)


def _rejected(end: DataEnd, swc: SwcPlan) -> Lines:
    if not end.tells_of_rejection:
        return ()
    reject = lines(f"{swc.core.type_name}_Reject_{end.place}({at_core(swc)}, t);")
    return block(f"if (verdict == {_constant('REJECTED', swc)})", [reject])


def read(end: DataEnd, value: str, given: Lines, swc: SwcPlan) -> Lines:
    """Ask for the update flag first, since reading resets it, and read in any case: an error may leave the flag unset."""
    accepted = f"verdict == {_constant('ACCEPTED', swc)}"
    flag = f"const boolean is_updated = Rte_IsUpdated_{end.name}();\n" if end.has_update else ""
    return joined([
        lines(f"Std_TransformerError error = {{0U, 0U}};\n{flag}"
              f"const Std_ReturnType status = Rte_Read_{end.name}({value}, &error);\n"
              f"const {_declared(swc, 'status')}\n"),
        block(f"if (({accepted}) && (is_updated != FALSE))" if end.has_update else f"if ({accepted})", [given]),
        _rejected(end, swc),
    ])  # fmt: skip


def drained(end: DataEnd, value: str, given: Lines, swc: SwcPlan) -> Lines:
    """Take all values that wait, at most as many as the queue holds: an error that stays does not block the runnable.

    A queue of the RTE that has lost values reports it with the next value, which is good all the same. A value with a
    transformer error does not end the loop.
    """
    lose = lines(f"{swc.core.type_name}_Lose_{end.place}({at_core(swc)}, t);")
    checked = end.has_transformer_errors
    accepted = f"verdict == {_constant('ACCEPTED', swc)}" if checked else "found == RTE_E_OK"
    return joined([
        lines("Std_TransformerError error = {0U, 0U};") if checked else (),
        lines("boolean has_more = TRUE;\n"),
        block(f"for (uint32 k = 0U; (k < {end.room}U) && (has_more != FALSE); k++)", [
            lines(f"const Std_ReturnType status = Rte_Receive_{end.name}({value}{', &error' if checked else ''});\n"
                  "const Std_ReturnType found = (Std_ReturnType)(status & 0xBFU);"),
            lines(f"const {_declared(swc, 'found')}") if checked else (),
            lines(""),
            block("if (Rte_HasOverlayedError(status))", [lose]) if end.tells_of_loss else (),
            block(f"if ({accepted})", [given]),
            _rejected(end, swc) if checked else (),
            lines("has_more = ((found == RTE_E_OK) || (found == RTE_E_HARD_TRANSFORMER_ERROR) || "
                  "(found == RTE_E_SOFT_TRANSFORMER_ERROR)) ? TRUE : FALSE;"),
        ]),
    ])  # fmt: skip


def _declared(swc: SwcPlan, status: str) -> str:
    return f"{static(swc, 'Verdict')} verdict = {static(swc, 'CheckMessage')}({status}, error);"
