"""Words that languages and libraries keep for themselves, so that no generated name may be one of them."""

import keyword
import re

C_KEYWORDS = frozenset(
    (
        "alignas", "alignof", "asm", "auto", "bool", "break", "case", "char", "const", "constexpr", "continue",
        "default", "do", "double", "else", "enum", "extern", "false", "float", "for", "goto", "if", "inline", "int",
        "long", "nullptr", "register", "restrict", "return", "short", "signed", "sizeof", "static", "static_assert",
        "struct", "switch", "thread_local", "true", "typedef", "typeof", "typeof_unqual", "union", "unsigned", "void",
        "volatile", "while",
    )
)  # fmt: skip
"""Keywords of C up to C23, and those that GNU C adds."""
CPP_KEYWORDS = frozenset(
    (
        "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break", "case", "catch",
        "char", "char8_t", "char16_t", "char32_t", "class", "co_await", "co_return", "co_yield", "compl", "concept",
        "const", "const_cast", "consteval", "constexpr", "constinit", "continue", "decltype", "default", "delete", "do",
        "double", "dynamic_cast", "else", "enum", "explicit", "export", "extern", "false", "float", "for", "friend",
        "goto", "if", "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq", "nullptr",
        "operator", "or", "or_eq", "private", "protected", "public", "register", "reinterpret_cast", "requires",
        "restrict", "return", "short", "signed", "sizeof", "static", "static_assert", "static_cast", "struct", "switch",
        "template", "this", "thread_local", "throw", "true", "try", "typedef", "typeid", "typename", "union",
        "unsigned", "using", "virtual", "void", "volatile", "wchar_t", "while", "xor", "xor_eq",
    )
)  # fmt: skip
PYTHON_KEYWORDS = frozenset((*keyword.kwlist, *keyword.softkwlist))
IDL_KEYWORDS = frozenset(
    (
        "abstract", "any", "attribute", "boolean", "component", "const", "context", "custom", "exception", "factory",
        "fixed", "home", "import", "in", "inout", "interface", "local", "map", "module", "multiple", "native", "octet",
        "oneway", "out", "port", "primarykey", "provides", "publishes", "raises", "readonly", "sequence", "string",
        "supports", "switch", "truncatable", "typeprefix", "union", "unsigned", "uses", "valuebase", "valuetype",
        "wchar", "wstring",
    )
)  # fmt: skip

_MACROS = frozenset(
    (
        "BIG_ENDIAN", "BUFSIZ", "BYTE_ORDER", "CHAR_BIT", "CLOCKS_PER_SEC", "DECIMAL_DIG", "EOF", "ERROR",
        "EXIT_FAILURE", "EXIT_SUCCESS", "FALSE", "FILENAME_MAX", "FOPEN_MAX", "INFINITY", "LITTLE_ENDIAN", "LONG_BIT",
        "MAXFLOAT", "MAX_CANON", "MAX_INPUT", "MB_CUR_MAX", "MB_LEN_MAX", "MATH_ERREXCEPT", "MATH_ERRNO", "NAN",
        "NFDBITS", "NULL", "NZERO", "PATH_MAX", "PDP_ENDIAN", "PIPE_BUF", "RAND_MAX", "SNAN", "TIMER_ABSTIME",
        "TIME_UTC", "TMP_MAX", "TRUE", "WCONTINUED", "WEXITED", "WEXITSTATUS", "WIFCONTINUED", "WIFEXITED",
        "WIFSIGNALED", "WIFSTOPPED", "WNOHANG", "WNOWAIT", "WORD_BIT", "WSTOPPED", "WSTOPSIG", "WTERMSIG", "WUNTRACED",
        "alloca", "assert", "assert_perror", "be16toh", "be32toh", "be64toh", "errno", "fpclassify", "htobe16",
        "htobe32", "htobe64", "htole16", "htole32", "htole64", "i386", "isfinite", "isgreater", "isgreaterequal",
        "isinf", "isless", "islessequal", "islessgreater", "isnan", "isnormal", "issubnormal", "isunordered", "le16toh",
        "le32toh", "le64toh", "linux", "math_errhandling", "mips", "offsetof", "signbit", "sparc", "stderr", "stdin",
        "stdout", "strdupa", "strndupa", "unix", "unreachable",
    )
)  # fmt: skip
"""Macros of the standard headers, and those that compilers define in their GNU mode."""
_TYPES = frozenset(
    ("FILE", "clock_t", "div_t", "double_t", "float_t", "imaxdiv_t", "ldiv_t", "lldiv_t", "max_align_t", "nullptr_t",
     "ptrdiff_t", "size_t", "ssize_t", "time_t", "wint_t")
)  # fmt: skip
_INTEGERS = r"u?int(_fast|_least)?(8|16|32|64)_t|u?int(max|ptr)_t"
_OF_INTEGERS = re.compile(rf"{_INTEGERS}|U?INT(_?(FAST|LEAST))?(8|16|32|64)_(MAX|MIN|C)|U?INT(MAX|PTR)_(MAX|MIN|C)")
_FAMILIES = re.compile(
    r"_[A-Z_].*"
    r"|(U?INT(_?(FAST|LEAST))?(8|16|32|64)|U?INT(MAX|PTR)?|[SU]?CHAR|U?SHRT|U?L?LONG|U?LONG_LONG|PTRDIFF|WCHAR|WINT|SIG_ATOMIC|S?SIZE|BOOL)"
    r"_(MAX|MIN|WIDTH|C)"
    r"|L?(DBL|FLT)_[A-Z0-9_]+|(PRI|SCN)[diouxX](8|16|32|64|FAST\d+|LEAST\d+|MAX|PTR)"
    r"|M_[A-Z0-9_]+(f|l|f\d+x?)?|FP_[A-Z0-9_]+|HUGE_VAL\w*|SNAN[A-Z0-9]*|(ADJ|CLOCK|MOD|RENAME|SEEK|STA|XATTR)_[A-Z0-9_]+"
    r"|FD_(CLR|ISSET|SET|SETSIZE|ZERO)|L_(ctermid|cuserid|tmpnam)|P_tmpdir"
    r"|(NL|AIO|BC|COLL|EXPR|RE|IOV|LINE|LOGIN|HOST|TTY|MQ|NGROUPS|RTSIG|SEM|DELAYTIMER|PTHREAD|CHARCLASS|NAME)_[A-Z0-9_]*"
    r"(MAX|MIN|DELTA_MAX|ITERATIONS)"
    rf"|{_INTEGERS}"
)
"""Names that C and C++ reserve, and families of macros and types of the standard headers."""
_ERRORS = frozenset(
    (
        "E2BIG", "EACCES", "EADDRINUSE", "EADDRNOTAVAIL", "EADV", "EAFNOSUPPORT", "EAGAIN", "EALREADY", "EBADE",
        "EBADF", "EBADFD", "EBADMSG", "EBADR", "EBADRQC", "EBADSLT", "EBFONT", "EBUSY", "ECANCELED", "ECHILD", "ECHRNG",
        "ECOMM", "ECONNABORTED", "ECONNREFUSED", "ECONNRESET", "EDEADLK", "EDEADLOCK", "EDESTADDRREQ", "EDOM",
        "EDOTDOT", "EDQUOT", "EEXIST", "EFAULT", "EFBIG", "EHOSTDOWN", "EHOSTUNREACH", "EHWPOISON", "EIDRM", "EILSEQ",
        "EINPROGRESS", "EINTR", "EINVAL", "EIO", "EISCONN", "EISDIR", "EISNAM", "EKEYEXPIRED", "EKEYREJECTED",
        "EKEYREVOKED", "EL2HLT", "EL2NSYNC", "EL3HLT", "EL3RST", "ELIBACC", "ELIBBAD", "ELIBEXEC", "ELIBMAX", "ELIBSCN",
        "ELNRNG", "ELOOP", "EMEDIUMTYPE", "EMFILE", "EMLINK", "EMSGSIZE", "EMULTIHOP", "ENAMETOOLONG", "ENAVAIL",
        "ENETDOWN", "ENETRESET", "ENETUNREACH", "ENFILE", "ENOANO", "ENOBUFS", "ENOCSI", "ENODATA", "ENODEV", "ENOENT",
        "ENOEXEC", "ENOKEY", "ENOLCK", "ENOLINK", "ENOMEDIUM", "ENOMEM", "ENOMSG", "ENONET", "ENOPKG", "ENOPROTOOPT",
        "ENOSPC", "ENOSR", "ENOSTR", "ENOSYS", "ENOTBLK", "ENOTCONN", "ENOTDIR", "ENOTEMPTY", "ENOTNAM",
        "ENOTRECOVERABLE", "ENOTSOCK", "ENOTSUP", "ENOTTY", "ENOTUNIQ", "ENXIO", "EOPNOTSUPP", "EOVERFLOW",
        "EOWNERDEAD", "EPERM", "EPFNOSUPPORT", "EPIPE", "EPROTO", "EPROTONOSUPPORT", "EPROTOTYPE", "ERANGE", "EREMCHG",
        "EREMOTE", "EREMOTEIO", "ERESTART", "ERFKILL", "EROFS", "ESHUTDOWN", "ESOCKTNOSUPPORT", "ESPIPE", "ESRCH",
        "ESRMNT", "ESTALE", "ESTRPIPE", "ETIME", "ETIMEDOUT", "ETOOMANYREFS", "ETXTBSY", "EUCLEAN", "EUNATCH", "EUSERS",
        "EWOULDBLOCK", "EXDEV", "EXFULL",
    )
)  # fmt: skip
"""Macros of `<errno.h>`."""


def is_of_integers(word: str) -> bool:
    """Whether `<stdint.h>`, which every core includes, defines a word."""
    return bool(_OF_INTEGERS.fullmatch(word))


def is_reserved(word: str) -> bool:
    """Whether a word has a meaning in C or C++, in a mode of GNU, or after a standard header."""
    return word in C_KEYWORDS or word in CPP_KEYWORDS or is_of_headers(word)


def is_of_headers(word: str) -> bool:
    """Whether a standard header or the compiler defines a word, or reserves it."""
    return word in _MACROS or word in _TYPES or word in _ERRORS or bool(_FAMILIES.fullmatch(word))
