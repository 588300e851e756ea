// The short-name path of a port: executable, root component, port (SWS_CORE_08001).
#ifndef ARA_CORE_INSTANCE_SPECIFIER_H_
#define ARA_CORE_INSTANCE_SPECIFIER_H_

#include <string>
#include <string_view>

#include "ara/core/result.h"

namespace ara::core {

class InstanceSpecifier final {
public:
    // Throws CoreException if the path is none.
    explicit InstanceSpecifier(std::string_view path);

    static Result<InstanceSpecifier> Create(std::string_view path);

    std::string_view ToString() const noexcept { return path_; }

    bool operator==(const InstanceSpecifier& other) const noexcept { return path_ == other.path_; }
    bool operator!=(const InstanceSpecifier& other) const noexcept { return path_ != other.path_; }
    bool operator<(const InstanceSpecifier& other) const noexcept { return path_ < other.path_; }

private:
    std::string path_;
};

}  // namespace ara::core

#endif  // ARA_CORE_INSTANCE_SPECIFIER_H_
