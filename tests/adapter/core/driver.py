"""The program that drives a generated core: it reads a script, and prints after each line all that can be seen."""

from collections.abc import Collection, Iterable
from pathlib import Path

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.plan import CLASS, GLOBALS, POINTERS
from tests.adapter.core.subject import Item, Leaf, Method, Subject

HELPERS = Path(__file__).with_name("driver.h")


OBJECT = "io"
"""The object that has all variables, where calls take a pointer to one."""
CLASS_NAME = "F_Code"


def header(subject: Subject, guard: str = "F_H") -> str:
    """Declarations of the function: its variables and its calls."""
    return f"""#ifndef {guard}
#define {guard}
#include <stdbool.h>
#include <stdint.h>
{chr(10).join(subject.structs)}
{_declared(subject)}
#endif
"""


def _declared(subject: Subject) -> str:
    members = "".join(f"    {item.declared};\n" for item in subject.variables) or "    int nothing;\n"
    heads = [head_of(subject, name) for name in subject.symbols]
    if subject.signature == CLASS:
        return f"class {CLASS_NAME} {{\npublic:\n{members}{''.join(f'    {head};{chr(10)}' for head in heads)}}};"
    if subject.signature == POINTERS:
        data = f"typedef struct {{\n{members}}} F_Io;\n"
    else:
        data = "".join(f"extern {item.declared};\n" for item in subject.variables)
    calls = "".join(f"{head};\n" for head in heads)
    return f'#ifdef __cplusplus\nextern "C" {{\n#endif\n{data}{calls}#ifdef __cplusplus\n}}\n#endif'


def head_of(subject: Subject, name: str, owner: str = "") -> str:
    """Head of a function of the code in C."""
    return f"{_result(subject, name)} {owner}{name}({f'F_Io *{OBJECT}' if subject.signature == POINTERS else 'void'})"


def _result(subject: Subject, symbol: str) -> str:
    has_result = any(call.symbol == symbol and call.success is not None for call in subject.function.calls)
    return "int32_t" if has_result else "void"


def silent_code(subject: Subject) -> str:
    """The function itself, in C: its variables, and calls that do nothing."""
    own = [f"{item.declared};" for item in subject.own_variables] if subject.signature == GLOBALS else []
    calls = [f"{head_of(subject, name)}\n{{\n{_nothing(subject, name)}}}" for name in subject.symbols]
    hooks = [f"void {name}({subject.plan.type_name} *hooked)\n{{\n    (void)hooked;\n}}" for name in subject.hooks]
    return "\n".join([*own, *calls, *hooks, ""])


def _nothing(subject: Subject, name: str) -> str:
    own = f"    (void){OBJECT};\n" if subject.signature == POINTERS else ""
    return own + ("    return 0;\n" if _result(subject, name) != "void" else "")


def code(subject: Subject) -> str:
    """The function itself: each of its calls prints what it sees, and does what the script said before."""
    variables = "".join(f"{item.declared};\n" for item in subject.own_variables) if subject.signature == GLOBALS else ""
    calls = "\n".join(_call(subject, name) for name in subject.symbols)
    hooks = "\n".join(
        f'void {name}({subject.plan.type_name} *hooked)\n{{\n    (void)hooked;\n    work("{name}");\n}}\n'
        for name in subject.hooks
    )
    return f"""{variables}

static void print_variables(void)
{{
{_indented(_printed(item.name, item, subject.place(item)) for item in subject.variables)}
}}

static void assign(int variable, const char *text)
{{
    (void)text;
    switch (variable) {{
{_cases((_taken(item.leaves, subject.place(item))) for item in subject.variables)}
    default: break;
    }}
}}

static void work(const char *symbol)
{{
    int index;
    printf("code %s", symbol);
    print_variables();
    printf("\\n");
    for (index = 0; index < pending_count; index++) {{
        assign(pending_variables[index], pending_texts[index]);
    }}
    pending_count = 0;
}}

{calls}
{hooks}
"""


def _call(subject: Subject, name: str) -> str:
    head = head_of(subject, name, f"{CLASS_NAME}::" if subject.signature == CLASS else "")
    own = f"    (void){OBJECT};\n" if subject.signature == POINTERS else ""
    end = "    return (int32_t)pending_result;\n" if _result(subject, name) != "void" else ""
    return f'{head}\n{{\n{own}    work("{name}");\n{end}}}\n'


# -- the program --------------------------------------------------------------------------------------------------


def program(subject: Subject, sources: Iterable[str]) -> str:
    """One translation unit with the core (its file names), the function and the driver."""
    own = f"{subject.plan.type_name}"
    return f"""{"".join(f'#include "{name}"{chr(10)}' for name in sources)}
#include "driver.h"

static {own} adapter;
static {own}_Stored kept;
static {own} *const self = &adapter;

{code(subject)}
static int stages[{max(len(subject.calls), 1)}];

static int is_idle(void)
{{
    int index;
    for (index = 0; index < {len(subject.calls)}; index++) {{
        if (stages[index] != 0) {{
            return 0;
        }}
    }}
    return 1;
}}

{_times(subject, own)}
{_state(subject, own)}
{_receive(subject, own)}
{_told(subject, own, "reject", {port.name for port in subject.plan.ports if port.tells_of_rejection})}
{_told(subject, own, "lose", {port.name for port in subject.plan.ports if port.tells_of_loss})}
{_advance(subject, own)}
{_methods(subject, own)}
{_parameters(subject, own)}
{_MAIN.replace("OWN", own).replace("CALLS", _answers(subject))}
"""


def _answers(subject: Subject) -> str:
    scope = Scope(subject.plan)
    return "\n".join(
        f"        if (call == (int){scope.call(c)}) {{ stages[{index}] = 1; }}"
        for index, (_, c) in enumerate(subject.calls)
    )


def _indented(lines: Iterable[str]) -> str:
    return "\n".join(f"    {line}" for line in lines)


def _cases(bodies: Iterable[str]) -> str:
    return "\n".join(f"    case {index}: {body} break;" for index, body in enumerate(bodies))


def _taken(leaves: Iterable[Leaf], name: str) -> str:
    return " ".join(f"take(&text, &{name}{leaf.place}, sizeof({name}{leaf.place}));" for leaf in leaves)


def _printed(label: str, item: Item, name: str, *, is_sent: bool = False) -> str:
    """Print all numbers of a value; of a sent value, bit by bit."""
    parts = [f'printf(" {label}=");']
    for leaf in item.leaves:
        place = f"{name}{leaf.place}"
        is_floating = leaf.format.is_floating and not is_sent
        put = f"put_{leaf.format.name}(&{place});" if is_floating else f"put(&{place}, sizeof({place}));"
        parts.append(put)
    return " ".join(parts)


def _sent(item: Item) -> str:
    """Print what is sent; of a queue, how many values and then all of them."""
    if not item.length:
        return _printed(f"out.{item.name}", item, f"self->out.{item.c}", is_sent=True)
    place = f"self->out.{item.c}"
    each = "".join(
        f" put(&{place}.values[k]{leaf.place}, sizeof({place}.values[k]{leaf.place}));" for leaf in item.leaves
    )
    head = f'printf(" out.{item.name}=%u:", (unsigned){place}.count);'
    return f"{head} {{ unsigned k; for (k = 0U; k < {place}.count; k++) {{{each} }} }}"


def _times(subject: Subject, own: str) -> str:
    """Times of a script in those of the core, and back."""
    clock = subject.plan.clock
    text = _TICKS.replace("TICKS", f"Sigcat_{clock.unit}") if clock.is_in_ticks else _NANOSECONDS
    return text.replace("OWN", own)


def _state(subject: Subject, own: str) -> str:
    """Print all that can be seen."""
    times = "(unsigned long long)now(), (unsigned long long)next()"
    lines = [f'printf("now=%llu next=%llu", {times});', "print_variables();"]
    for item in subject.outs:
        lines.append(_sent(item))
        lines.append(f'if (self->publish.{item.c}) {{ printf("!"); }}')
    for name, c in subject.errors:
        lines.append(
            f'printf(" {name}:%d,%u,%u,%d", (int)self->error.{c}.state, (unsigned)self->stored.{c}.occurrences, '
            f"(unsigned)self->stored.{c}.ignition_cycles, (int)self->error.{c}.is_confirmed);"
        )
    steps = {call.name: call for call in subject.plan.steps}
    for name, c in subject.calls:
        missed = f"(unsigned)self->{c}.missed" if steps[c].cycle else "0U"
        lines.append(f'printf(" {name}:%u,%u", {missed}, (unsigned)self->{c}.dropped);')
    for item in subject.parameters:
        there = f"self->stored.{item.c}"
        lines.append(f"if ({there}.is_there) {{ {_printed('stored.' + item.name, item, there + '.value')} }}")
    for method in subject.used:
        lines.append(f'printf(" {method.name}:%u", (unsigned)self->method.{method.c}.number);')
        lines += [
            _printed(f"{method.name}.{item.name}", item, f"self->method.{method.c}.arguments.{item.c}", is_sent=True)
            for item in method.arguments
        ]
        lines.append(f'if (self->publish.{method.c}) {{ printf("!"); }}')
    return f'static void print_state(void)\n{{\n{_indented(lines)}\n    printf("\\n");\n}}\n'


def _passed(item: Item) -> str:
    return "&value" if item.leaves[0].place.startswith(".") else "value"


def _told(subject: Subject, own: str, word: str, ports: Collection[str]) -> str:
    """Inputs of the core for a port, in addition to values."""
    bodies = [f"{own}_{word.title()}_{item.c}(self, at(t));" if item.c in ports else "" for item in subject.ports]
    return f"""static void {word}(int port, uint64_t t)
{{
    (void)t;
    switch (port) {{
{_cases(bodies)}
    default: break;
    }}
}}
"""


def _receive(subject: Subject, own: str) -> str:
    bodies = [
        f"{{ {item.declared}; memset(&value, 0, sizeof(value)); {_taken(item.leaves, 'value')} "
        f"{own}_Receive_{item.c}(self, {_passed(item)}, at(t)); }}"
        for item in subject.ports
    ]
    return f"""static void receive(int port, const char *text, uint64_t t)
{{
    (void)text;
    (void)t;
    switch (port) {{
{_cases(bodies)}
    default: break;
    }}
}}
"""


def _advance(subject: Subject, own: str) -> str:
    bodies = [
        f"""
        switch (stages[{index}]) {{
        case 1: {own}_SetInput_{c}(self, at(t)); stages[{index}] = 2; break;
        case 2: {own}_Begin_{c}(self, at(t)); stages[{index}] = 3; break;
        case 3: {own}_Run_{c}(self); stages[{index}] = 4; break;
        case 4: {own}_GetOutput_{c}(self, at(t)); stages[{index}] = 0; break;
        default: break;
        }}"""
        for index, (_, c) in enumerate(subject.calls)
    ]
    return f"""static void advance(int call, uint64_t t)
{{
    switch (call) {{
{_cases(bodies)}
    default: break;
    }}
}}
"""


def _methods(subject: Subject, own: str) -> str:
    """Requests and answers."""
    offered = [_offered(method, own) for method in subject.offered]
    answers = [
        f"{{ {own}_{method.c}_Results results; memset(&results, 0, sizeof(results)); "
        f"{_members(method.results, 'results')} {own}_Answer_{method.c}(self, number, is_ok != 0, &results, at(t)); }}"
        if method.results
        else f"{own}_Answer_{method.c}(self, number, is_ok != 0, at(t));"
        for method in subject.used
    ]
    return f"""static void request(int method, const char *text)
{{
    (void)text;
    switch (method) {{
{_cases(offered)}
    default: break;
    }}
}}

static void answer(int method, uint32_t number, int is_ok, const char *text, uint64_t t)
{{
    (void)number;
    (void)is_ok;
    (void)text;
    (void)t;
    switch (method) {{
{_cases(answers)}
    default: break;
    }}
}}
"""


def _members(items: Iterable[Item], name: str) -> str:
    return " ".join(_taken(item.leaves, f"{name}.{item.c}") for item in items)


def _offered(method: Method, own: str) -> str:
    passed = ["self"]
    parts = []
    if method.arguments:
        parts.append(f"{own}_{method.c}_Arguments arguments; memset(&arguments, 0, sizeof(arguments));")
        parts.append(_members(method.arguments, "arguments"))
        passed.append("&arguments")
    if method.results:
        parts.append(f"{own}_{method.c}_Results results; memset(&results, 0, sizeof(results));")
        passed.append("&results")
    results = " ".join(_printed(item.name, item, f"results.{item.c}", is_sent=True) for item in method.results)
    call = f"{own}_Method_{method.c}({', '.join(passed)})"
    return (
        f'{{ {" ".join(parts)} {{ int reply = (int){call}; printf("reply=%d", reply); '
        f'if (reply == 0) {{ {results} }} printf("\\n"); }} }}'
    )


def _parameters(subject: Subject, own: str) -> str:
    stored = [
        f"if (*text == '-') {{ kept.{item.c}.is_there = false; }} "
        f"else {{ {_taken(item.leaves, f'kept.{item.c}.value')} kept.{item.c}.is_there = true; }}"
        for item in subject.parameters
    ]
    settable = [item for item in subject.parameters if item.name in subject.settable]
    body = (
        f"{own}_Parameters parameters; memset(&parameters, 0, sizeof(parameters)); {_members(settable, 'parameters')} "
        f'printf("set=%d\\n", (int){own}_SetParameters(self, &parameters));'
        if settable
        else ""
    )
    return f"""static void store(int parameter, const char *text)
{{
    (void)text;
    switch (parameter) {{
{_cases(stored)}
    default: break;
    }}
}}

static void set_parameters(const char *text)
{{
    (void)text;
    {{ {body} }}
}}
"""


_NANOSECONDS = """static uint64_t at(uint64_t t)
{
    return t;
}

static uint64_t now(void)
{
    return self->now;
}

static uint64_t next(void)
{
    return OWN_NextTime(self);
}
"""

_TICKS = """/* Ticks at the time 0 of a script. */
#ifndef FIRST
#define FIRST 0U
#endif

static uint64_t given_last;

static Sigcat_Time at(uint64_t t)
{
    given_last = t / SIGCAT_TICK_NS;
    return TICKS((uint32_t)given_last + FIRST);
}

/* The nearest time to the one that was given last. */
static uint64_t from(uint32_t ticks)
{
    return (given_last + (uint64_t)(int64_t)(int32_t)(ticks - FIRST - (uint32_t)given_last)) * SIGCAT_TICK_NS;
}

static uint64_t now(void)
{
    return self->has_time ? from(self->now) : 0U;
}

static uint64_t next(void)
{
    return now() + (uint64_t)(OWN_NextTime(self).ticks - self->now) * SIGCAT_TICK_NS;
}
"""

_MAIN = """static void execute(const char *word)
{
    if (strcmp(word, "receive") == 0) {
        const int port = (int)next_number();
        const char *text = next_word();
        receive(port, text, next_number());
    } else if (strcmp(word, "reject") == 0) {
        const int port = (int)next_number();
        reject(port, next_number());
    } else if (strcmp(word, "lose") == 0) {
        const int port = (int)next_number();
        lose(port, next_number());
    } else if (strcmp(word, "next") == 0) {
        const int call = (int)OWN_NextCall(self, at(next_number()));
        printf("call=%d\\n", call);
CALLS
    } else if (strcmp(word, "advance") == 0) {
        const int call = (int)next_number();
        advance(call, next_number());
    } else if (strcmp(word, "finish") == 0) {
        const int call = (int)next_number();
        const uint64_t begin = next_number();
        const uint64_t end = next_number();
        while (stages[call] != 0) {
            advance(call, stages[call] == 4 ? end : begin);
        }
    } else if (strcmp(word, "set") == 0) {
        const int variable = (int)next_number();
        assign(variable, next_word());
    } else if (strcmp(word, "then") == 0) {
        pending_variables[pending_count] = (int)next_number();
        (void)strcpy(pending_texts[pending_count], next_word());
        pending_count++;
    } else if (strcmp(word, "returns") == 0) {
        pending_result = atoi(next_word());
    } else if (strcmp(word, "supervise") == 0) {
        OWN_Supervise(self, at(next_number()));
    } else if (strcmp(word, "published") == 0) {
        OWN_Published(self);
    } else if (strcmp(word, "start") == 0) {
        OWN_Start(self, at(next_number()));
    } else if (strcmp(word, "keep") == 0) {
        kept = self->stored;
    } else if (strcmp(word, "store") == 0) {
        const int parameter = (int)next_number();
        store(parameter, next_word());
    } else if (strcmp(word, "parameters") == 0) {
        set_parameters(next_word());
    } else if (strcmp(word, "answer") == 0) {
        const int method = (int)next_number();
        const uint32_t number = (uint32_t)next_number();
        const int is_ok = (int)next_number();
        const char *text = next_word();
        answer(method, number, is_ok, text, next_number());
    } else if (is_idle()) {
        if (strcmp(word, "init") == 0) {
            const int is_kept = (int)next_number();
            const int is_good = (int)OWN_Init(self, is_kept ? &kept : NULL, (uint32_t)next_number());
            printf("good=%d\\n", is_good);
        } else if (strcmp(word, "terminate") == 0) {
            OWN_Terminate(self, at(next_number()));
        } else if (strcmp(word, "request") == 0) {
            const int method = (int)next_number();
            request(method, next_word());
        }
    }
}

int main(void)
{
    static char line[65536];
    while (fgets(line, (int)sizeof(line), stdin) != NULL) {
        execute(strtok(line, " \\n"));
        print_state();
    }
    return 0;
}
"""
