"""Words that languages and libraries keep for themselves, so that no generated name may be one of them."""

import keyword

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
C_MACROS = frozenset(
    (
        "BUFSIZ", "EOF", "ERROR", "FALSE", "INFINITY", "INT_MAX", "INT_MIN", "NAN", "NULL", "TRUE", "assert", "errno",
        "stderr", "stdin", "stdout",
    )
)  # fmt: skip
IDL_KEYWORDS = frozenset(
    (
        "abstract", "any", "attribute", "boolean", "component", "const", "context", "custom", "exception", "factory",
        "fixed", "home", "import", "in", "inout", "interface", "local", "map", "module", "multiple", "native", "octet",
        "oneway", "out", "port", "primarykey", "provides", "publishes", "raises", "readonly", "sequence", "string",
        "supports", "switch", "truncatable", "typeprefix", "union", "unsigned", "uses", "valuebase", "valuetype",
        "wchar", "wstring",
    )
)  # fmt: skip
