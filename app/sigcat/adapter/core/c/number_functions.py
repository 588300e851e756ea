"""Small functions of C that put numbers into variables, scale, round and saturate them."""

from sigcat.adapter.core.c.lines import Lines, lines
from sigcat.adapter.core.c.literals import literal
from sigcat.adapter.core.numbers import NumberType


def put(prefix: str) -> Lines:
    """A number, put into a variable of the function that may be an enumeration."""
    return lines(f"""
        /* A number, put into a variable of the function that may be an enumeration. */
        template <typename T, typename N>
        static inline void {prefix}_Put(T &variable, N number)
        {{
            variable = static_cast<T>(number);
        }}
    """)


def is_set(prefix: str) -> Lines:
    """Whether a variable of the function, which may be an enumeration, is not 0."""
    return lines(f"""
        /* Whether a variable of the function, which may be an enumeration, is not 0. */
        template <typename T>
        static inline bool {prefix}_IsSet(const T &variable)
        {{
            return variable != static_cast<T>(0);
        }}
    """)


def scaled(prefix: str) -> Lines:
    """Two roundings, never one: the sum is a statement of its own."""
    return lines(f"""
        /* Two roundings, never one: the sum is a statement of its own. */
        static inline double {prefix}_Scaled(double value, double factor, double offset)
        {{
            const double product = value * factor;
            return product + offset;
        }}
    """)


def quiet(name: str, c: str, prefix: str) -> Lines:
    """A NaN gets the usual bits."""
    nan = "NAN" if c == "float" else "(double)NAN"
    return lines(f"""
        /* The number; of a NaN the one with the usual bits. */
        static inline {c} {prefix}_{name}({c} value)
        {{
            return (value == value) ? value : {nan};
        }}
    """)


def beyond_float(prefix: str) -> Lines:
    """What no float holds: too large, infinite, or no number."""
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


def to_float(prefix: str) -> Lines:
    """Rounded once; what is finite stays finite."""
    return lines(f"""
        /* Rounded once; what is finite stays finite. */
        static inline float {prefix}_ToFloat(double value)
        {{
            const bool is_usual = (value >= -(double)FLT_MAX) && (value <= (double)FLT_MAX);

            return is_usual ? (float)value : {prefix}_BeyondFloat(value);
        }}
    """)


def rounded(prefix: str) -> Lines:
    """The nearest whole number, ties to even."""
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


def to_integer(wanted: NumberType, prefix: str) -> Lines:
    """To the nearest whole number, ties to even, saturated."""
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


def from_signed(wanted: NumberType, prefix: str) -> Lines:
    """A signed number of 64 bits to another integer, saturated."""
    low, high = int(wanted.smallest), int(wanted.largest)
    if high > 2**63 - 1:
        body = f"({wanted.c})((value < 0) ? INT64_C(0) : value)"
    else:
        least, most = (f"INT64_C({low})", f"INT64_C({high})")
        body = f"({wanted.c})((value < {least}) ? {least} : ((value > {most}) ? {most} : value))"
    return _saturating("Int64", "int64_t", wanted, body, prefix)


def from_unsigned(wanted: NumberType, prefix: str) -> Lines:
    """An unsigned number of 64 bits to another integer, saturated."""
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
