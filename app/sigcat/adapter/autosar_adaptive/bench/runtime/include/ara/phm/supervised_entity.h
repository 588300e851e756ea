// What an application reports to the health management (SWS_PHM_00321). In the bench, a checkpoint is a line of the log.
#ifndef ARA_PHM_SUPERVISED_ENTITY_H_
#define ARA_PHM_SUPERVISED_ENTITY_H_

#include <cstdint>
#include <type_traits>

#include "ara/core/instance_specifier.h"

namespace ara::phm {

class SupervisedEntity final {
public:
    explicit SupervisedEntity(const ara::core::InstanceSpecifier& instance) : instance_{instance} {}
    SupervisedEntity(const SupervisedEntity&) = delete;
    SupervisedEntity& operator=(const SupervisedEntity&) = delete;

    template <typename EnumT>
    void ReportCheckpoint(EnumT checkpointId) noexcept {
        static_assert(std::is_enum_v<EnumT>, "a checkpoint is one of an enumeration");
        Report(static_cast<std::uint32_t>(checkpointId));
    }

private:
    void Report(std::uint32_t checkpoint) noexcept;

    ara::core::InstanceSpecifier instance_;
};

}  // namespace ara::phm

#endif  // ARA_PHM_SUPERVISED_ENTITY_H_
