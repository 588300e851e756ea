"""Parts of system headers that declarations need, written here; other headers of the system are left out.

They include the types of Simulink, which many projects do not pass on. A file of the project takes precedence.
"""

from collections.abc import Mapping

_SIZED = "".join(
    f"typedef __{sign.upper()}INT{bits}_TYPE__ {sign}int{form}{bits}_t;\n"
    for sign in ("", "u")
    for form in ("", "_least", "_fast")
    for bits in (8, 16, 32, 64)
)
SYSTEM_HEADERS: Mapping[str, str] = {
    "stdint.h": f"#pragma once\n{_SIZED}typedef __INTPTR_TYPE__ intptr_t;\ntypedef __UINTPTR_TYPE__ uintptr_t;\n",
    "cstdint": "#include <stdint.h>\nnamespace std { using ::int8_t; using ::uint8_t; using ::int16_t; using ::uint16_t; "
    "using ::int32_t; using ::uint32_t; using ::int64_t; using ::uint64_t; }\n",
    "stddef.h": "#pragma once\ntypedef __SIZE_TYPE__ size_t;\ntypedef __PTRDIFF_TYPE__ ptrdiff_t;\n"
    "#ifdef __cplusplus\n#define NULL 0\n#else\n#define NULL ((void *)0)\n#endif\n",
    "cstddef": "#include <stddef.h>\n",
    "stdbool.h": "#ifndef __cplusplus\n#define bool _Bool\n#define true 1\n#define false 0\n#endif\n",
    "limits.h": "".join(
        f"#define {name} {value}\n"
        for name, value in (
            ("CHAR_BIT", "8"),
            ("SCHAR_MAX", "__SCHAR_MAX__"),
            ("SCHAR_MIN", "(-__SCHAR_MAX__-1)"),
            ("UCHAR_MAX", "(__SCHAR_MAX__*2+1)"),
            ("CHAR_MIN", "SCHAR_MIN"),
            ("CHAR_MAX", "SCHAR_MAX"),
            ("SHRT_MAX", "__SHRT_MAX__"),
            ("SHRT_MIN", "(-__SHRT_MAX__-1)"),
            ("USHRT_MAX", "(__SHRT_MAX__*2U+1U)"),
            ("INT_MAX", "__INT_MAX__"),
            ("INT_MIN", "(-__INT_MAX__-1)"),
            ("UINT_MAX", "(__INT_MAX__*2U+1U)"),
            ("LONG_MAX", "__LONG_MAX__"),
            ("LONG_MIN", "(-__LONG_MAX__-1L)"),
            ("ULONG_MAX", "(__LONG_MAX__*2UL+1UL)"),
            ("LLONG_MAX", "__LONG_LONG_MAX__"),
            ("LLONG_MIN", "(-__LONG_LONG_MAX__-1LL)"),
            ("ULLONG_MAX", "(__LONG_LONG_MAX__*2ULL+1ULL)"),
        )
    ),
    "climits": "#include <limits.h>\n",
    "float.h": "".join(
        f"#define {kind}_{name} __{kind}_{name}__\n"
        for kind in ("FLT", "DBL", "LDBL")
        for name in ("MANT_DIG", "DIG", "MIN_EXP", "MAX_EXP", "MIN_10_EXP", "MAX_10_EXP", "MAX", "MIN", "EPSILON")
    )
    + "#define FLT_RADIX 2\n",
    "cfloat": "#include <float.h>\n",
    "array": "#pragma once\n#include <stddef.h>\n"
    "namespace std { template <typename T, size_t N> struct array { T elements[N]; "
    "T &operator[](size_t); const T &operator[](size_t) const; T *begin(); T *end(); T *data(); "
    "const T *begin() const; const T *end() const; const T *data() const; size_t size() const; void fill(const T &); }; }\n",
    "string.h": "#include <stddef.h>\n",
    "cstring": "#include <stddef.h>\n",
    "stdlib.h": "#include <stddef.h>\n",
    "rtwtypes.h": "#include <stdint.h>\n"
    + "".join(f"typedef {sign}int{bits}_t {sign}int{bits}_T;\n" for sign in ("", "u") for bits in (8, 16, 32, 64))
    + "typedef unsigned char boolean_T, byte_T, uchar_T;\ntypedef char char_T;\ntypedef int int_T;\n"
    "typedef unsigned int uint_T;\ntypedef unsigned long ulong_T;\ntypedef double real_T, real64_T, time_T;\n"
    "typedef float real32_T;\n",
}
