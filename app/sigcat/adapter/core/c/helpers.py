"""Small functions of C that conversions and errors need. A source has those that it uses."""

from sigcat.adapter.core.c.lines import Lines, lines
from sigcat.adapter.core.c.literals import literal
from sigcat.adapter.core.numbers import NumberType, number_type
from sigcat.catalogue.model.datatypes import INTEGER_RANGES


def used_helpers(text: str, prefix: str, macro: str) -> list[Lines]:
    """The helpers that a text calls, and those that they call, each before its first use."""
    table = _helpers(prefix, macro)
    wanted: dict[str, None] = {}
    for name in reversed(table):
        callers = [text, *("\n".join(line.text for line in table[known]) for known in wanted)]
        if any(f"{prefix}_{name}(" in each for each in callers):
            wanted[name] = None
    return [table[name] for name in table if name in wanted]


def _helpers(prefix: str, macro: str) -> dict[str, Lines]:
    """Every helper by its name, each after those that it calls."""
    integers = [found for name in INTEGER_RANGES if (found := number_type(name))]
    return {
        "Put": _put(prefix),
        "IsSet": _is_set(prefix),
        "Now": _now(prefix),
        "Earlier": _earlier(prefix),
        "Added": _added(prefix),
        "Worse": _worse(prefix),
        "HasFailed": _has_failed(prefix, macro),
        "Suspend": _suspend(prefix, macro),
        "Later": _later(prefix),
        "Judge": _judge(prefix, macro),
        "Scaled": _scaled(prefix),
        "QuietFloat": _quiet("QuietFloat", "float", prefix),
        "QuietDouble": _quiet("QuietDouble", "double", prefix),
        "BeyondFloat": _beyond_float(prefix),
        "ToFloat": _to_float(prefix),
        "RoundedToEven": _rounded(prefix),
        **{f"To{each.name.capitalize()}": _to_integer(each, prefix) for each in integers},
        **{f"Int64To{each.name.capitalize()}": _from_signed(each, prefix) for each in integers},
        **{f"Uint64To{each.name.capitalize()}": _from_unsigned(each, prefix) for each in integers},
    }


def _put(prefix: str) -> Lines:
    return lines(f"""
        /* A number, put into a variable of the function that may be an enumeration. */
        template <typename T, typename N>
        static inline void {prefix}_Put(T &variable, N number)
        {{
            variable = static_cast<T>(number);
        }}
    """)


def _is_set(prefix: str) -> Lines:
    return lines(f"""
        /* Whether a variable of the function, which may be an enumeration, is not 0. */
        template <typename T>
        static inline bool {prefix}_IsSet(const T &variable)
        {{
            return variable != static_cast<T>(0);
        }}
    """)


def _now(prefix: str) -> Lines:
    return lines(f"""
        /* The time: one before the last one counts as the last one. */
        static inline uint64_t {prefix}_Now({prefix} *self, uint64_t t)
        {{
            if (t > self->now) {{
                self->now = t;
            }}
            return self->now;
        }}
    """)


def _earlier(prefix: str) -> Lines:
    return lines(f"""
        static uint64_t {prefix}_Earlier(uint64_t a, uint64_t b)
        {{
            return (a < b) ? a : b;
        }}
    """)


def _added(prefix: str) -> Lines:
    return lines(f"""
        /* A sum that stays at the largest number. */
        static uint32_t {prefix}_Added(uint32_t sum, uint64_t more)
        {{
            return (more > ((uint64_t)UINT32_MAX - sum)) ? UINT32_MAX : (sum + (uint32_t)more);
        }}
    """)


def _worse(prefix: str) -> Lines:
    return lines(f"""
        /* The worse of two verdicts: present, absent, not judged. */
        static {prefix}_Verdict {prefix}_Worse({prefix}_Verdict a, {prefix}_Verdict b)
        {{
            return (a > b) ? a : b;
        }}
    """)


def _has_failed(prefix: str, macro: str) -> Lines:
    return lines(f"""
        /* Whether an error is reported as failed. */
        static bool {prefix}_HasFailed(const {prefix}_Error *error)
        {{
            return (error->state == {macro}_FAILED) || (error->state == {macro}_HEALING);
        }}
    """)


def _suspend(prefix: str, macro: str) -> Lines:
    return lines(f"""
        /* What was under way ends. */
        static void {prefix}_Suspend({prefix}_Error *error)
        {{
            if (error->state == {macro}_PREFAILED) {{
                error->state = error->before;
            }} else if (error->state == {macro}_HEALING) {{
                error->state = {macro}_FAILED;
            }} else {{
                /* as it is */
            }}
        }}
    """)


def _later(prefix: str) -> Lines:
    return lines(f"""
        static uint64_t {prefix}_Later(uint64_t a, uint64_t b)
        {{
            return (a > b) ? a : b;
        }}
    """)


def _judge(prefix: str, macro: str) -> Lines:
    return lines(f"""
        /* Whether a value is late, judged in each snapshot. What is late stays so until enough new values have come. */
        static void {prefix}_Judge({prefix}_Clock *clock, const {prefix}_Reception *reception, uint64_t entered,
            uint64_t time_out, uint32_t recovery, bool starts_with_first, uint64_t t)
        {{
            const bool is_there = reception->is_there;
            const uint64_t last = (is_there && (reception->time > entered)) ? reception->time : entered;

            if ((is_there || !starts_with_first) && ((t - last) > time_out)) {{
                clock->is_late = true;
                clock->count = reception->count;
            }} else if (clock->is_late && ((reception->count - clock->count) >= recovery)) {{
                clock->is_late = false;
            }} else {{
                /* as before */
            }}
            if (clock->is_late) {{
                clock->verdict = {macro}_PRESENT;
            }} else {{
                clock->verdict = is_there ? {macro}_ABSENT : {macro}_NOT_JUDGED;
            }}
        }}
    """)


def _scaled(prefix: str) -> Lines:
    return lines(f"""
        /* Two roundings, never one: the sum is a statement of its own. */
        static inline double {prefix}_Scaled(double value, double factor, double offset)
        {{
            const double product = value * factor;
            return product + offset;
        }}
    """)


def _quiet(name: str, c: str, prefix: str) -> Lines:
    nan = "NAN" if c == "float" else "(double)NAN"
    return lines(f"""
        /* The number; of a NaN the one with the usual bits. */
        static inline {c} {prefix}_{name}({c} value)
        {{
            return (value == value) ? value : {nan};
        }}
    """)


def _beyond_float(prefix: str) -> Lines:
    return lines(f"""
        /* What no float holds: too large, infinite, or no number. */
        static float {prefix}_BeyondFloat(double value)
        {{
            float found;

            if (value > DBL_MAX) {{
                found = INFINITY;
            }} else if (value < -DBL_MAX) {{
                found = -INFINITY;
            }} else if (value > 0.0) {{
                found = FLT_MAX;
            }} else if (value < 0.0) {{
                found = -FLT_MAX;
            }} else {{
                found = NAN;
            }}
            return found;
        }}
    """)


def _to_float(prefix: str) -> Lines:
    return lines(f"""
        /* Rounded once; what is finite stays finite. */
        static inline float {prefix}_ToFloat(double value)
        {{
            const bool is_usual = (value >= -(double)FLT_MAX) && (value <= (double)FLT_MAX);

            return is_usual ? (float)value : {prefix}_BeyondFloat(value);
        }}
    """)


def _rounded(prefix: str) -> Lines:
    return lines(f"""
        /* The nearest whole number, ties to even. */
        static int64_t {prefix}_RoundedToEven(double value)
        {{
            int64_t whole = (int64_t)value;
            const double rest = value - (double)whole;
            const bool is_odd = (whole % 2) != 0;
            if ((rest > 0.5) || ((rest == 0.5) && is_odd)) {{
                whole++;
            }} else if ((rest < -0.5) || ((rest == -0.5) && is_odd)) {{
                whole--;
            }} else {{
                /* it is the nearest one */
            }}
            return whole;
        }}
    """)


def _to_integer(wanted: NumberType, prefix: str) -> Lines:
    low, high = literal(int(wanted.smallest), wanted), literal(int(wanted.largest), wanted)
    middle = f"({wanted.c}){prefix}_RoundedToEven(value)"
    if wanted.name == "uint64":
        middle = f"(value < 9223372036854775808.0) ? {middle} : (uint64_t)value"
    return lines(f"""
        /* To the nearest whole number, ties to even, saturated. */
        static {wanted.c} {prefix}_To{wanted.name.capitalize()}(double value, {wanted.c} instead_of_nan)
        {{
            {wanted.c} rounded;
            if (value != value) {{
                rounded = instead_of_nan;
            }} else if (value <= {float(wanted.smallest)!r}) {{
                rounded = {low};
            }} else if (value >= {float(wanted.largest)!r}) {{
                rounded = {high};
            }} else {{
                rounded = {middle};
            }}
            return rounded;
        }}
    """)


def _from_signed(wanted: NumberType, prefix: str) -> Lines:
    low, high = int(wanted.smallest), int(wanted.largest)
    if high > 2**63 - 1:
        body = f"({wanted.c})((value < 0) ? INT64_C(0) : value)"
    else:
        least, most = (f"INT64_C({low})", f"INT64_C({high})")
        body = f"({wanted.c})((value < {least}) ? {least} : ((value > {most}) ? {most} : value))"
    return _saturating("Int64", "int64_t", wanted, body, prefix)


def _from_unsigned(wanted: NumberType, prefix: str) -> Lines:
    most = f"UINT64_C({int(wanted.largest)})"
    return _saturating("Uint64", "uint64_t", wanted, f"({wanted.c})((value > {most}) ? {most} : value)", prefix)


def _saturating(name: str, c: str, wanted: NumberType, body: str, prefix: str) -> Lines:
    return lines(f"""
        /* Saturated. */
        static {wanted.c} {prefix}_{name}To{wanted.name.capitalize()}({c} value)
        {{
            return {body};
        }}
    """)
