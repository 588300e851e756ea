// The end of a process that cannot continue (SWS_CORE_00052).
#ifndef ARA_CORE_ABORT_H_
#define ARA_CORE_ABORT_H_

namespace ara::core {

[[noreturn]] void Abort(const char* text) noexcept;

}  // namespace ara::core

#endif  // ARA_CORE_ABORT_H_
