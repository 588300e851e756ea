"""The error domain of methods, as a vendor's generator would make it of the ARXML (SWS_CM_11266)."""

from sigcat.adapter.autosar_adaptive.arxml.method_errors import DOMAIN, DOMAIN_ID, METHOD_ERRORS
from sigcat.adapter.autosar_adaptive.bench.text import comment, header, within
from sigcat.adapter.autosar_adaptive.cpp_names import TypeNames
from sigcat.function.document.text_filters import c_string


def errors_header(names: TypeNames, namespace: tuple[str, ...]) -> str:
    """The header that the common header of a service with methods includes."""
    includes = ["ara/core/error_code.h", "ara/core/exception.h"]
    body = [_enumeration(), _exception(), _domain(), _functions()]
    return header(errors_path(names), "Errors of methods.", includes, within(namespace, body))


def errors_path(names: TypeNames) -> str:
    """The header as it is included."""
    return "/".join((*names.folders, f"{DOMAIN.lower()}_error_domain.h"))


def _enumeration() -> str:
    rows = "".join(f"{comment(each.description, 1)}\n    {each.name} = {each.code},\n" for each in METHOD_ERRORS)
    return f"enum class {DOMAIN}Errc : ara::core::ErrorDomain::CodeType {{\n{rows}}};"


def _exception() -> str:
    return f"class {DOMAIN}Exception : public ara::core::Exception {{\npublic:\n    using ara::core::Exception::Exception;\n}};"


def _domain() -> str:
    cases = "".join(
        f"            case {DOMAIN}Errc::{each.name}:\n                return {c_string(each.description)};\n"
        for each in METHOD_ERRORS
    )
    return f"""class {DOMAIN}ErrorDomain final : public ara::core::ErrorDomain {{
public:
    using Errc = {DOMAIN}Errc;
    using Exception = {DOMAIN}Exception;

    constexpr {DOMAIN}ErrorDomain() noexcept : ErrorDomain{{0x{DOMAIN_ID:016X}}} {{}}
    const char* Name() const noexcept override {{ return {c_string(DOMAIN)}; }}
    const char* Message(CodeType code) const noexcept override {{
        switch (static_cast<{DOMAIN}Errc>(code)) {{
{cases}        }}
        return "Unknown error of a method.";
    }}
    [[noreturn]] void ThrowAsException(const ara::core::ErrorCode& code) const noexcept(false) override {{
        throw {DOMAIN}Exception{{code}};
    }}
}};"""


def _functions() -> str:
    return f"""inline constexpr {DOMAIN}ErrorDomain k{DOMAIN}ErrorDomain{{}};

constexpr const ara::core::ErrorDomain& Get{DOMAIN}ErrorDomain() noexcept {{ return k{DOMAIN}ErrorDomain; }}

constexpr ara::core::ErrorCode MakeErrorCode({DOMAIN}Errc code, ara::core::ErrorDomain::SupportDataType data) noexcept {{
    return {{static_cast<ara::core::ErrorDomain::CodeType>(code), Get{DOMAIN}ErrorDomain(), data}};
}}"""
