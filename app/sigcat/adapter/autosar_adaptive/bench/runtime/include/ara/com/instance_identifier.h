// An instance of a service, as this platform writes it: `SOME/IP:<service>:<instance>` (SWS_CM_00302).
#ifndef ARA_COM_INSTANCE_IDENTIFIER_H_
#define ARA_COM_INSTANCE_IDENTIFIER_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "ara/core/result.h"

namespace ara::com {

class InstanceIdentifier final {
public:
    // Throws ComException if it is none.
    explicit InstanceIdentifier(std::string_view text);

    static ara::core::Result<InstanceIdentifier> Create(std::string_view text);

    std::string_view ToString() const noexcept { return text_; }

    bool operator==(const InstanceIdentifier& other) const noexcept { return text_ == other.text_; }
    bool operator<(const InstanceIdentifier& other) const noexcept { return text_ < other.text_; }

    // The ids, for the runtime.
    std::uint16_t ServiceId() const noexcept { return service_; }
    std::uint16_t InstanceId() const noexcept { return instance_; }

private:
    std::string text_;
    std::uint16_t service_;
    std::uint16_t instance_;
};

}  // namespace ara::com

#endif  // ARA_COM_INSTANCE_IDENTIFIER_H_
