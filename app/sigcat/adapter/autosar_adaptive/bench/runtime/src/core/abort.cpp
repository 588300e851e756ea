#include "ara/core/abort.h"

#include <cstdio>
#include <cstdlib>

namespace ara::core {

void Abort(const char* text) noexcept {
    std::fprintf(stderr, "ara::core::Abort: %s\n", text);
    std::abort();
}

}  // namespace ara::core
