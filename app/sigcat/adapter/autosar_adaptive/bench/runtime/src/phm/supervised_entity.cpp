#include "ara/phm/supervised_entity.h"

#include "ara/log/logger.h"

namespace ara::phm {

void SupervisedEntity::Report(std::uint32_t checkpoint) noexcept {
    static const auto& logger = ara::log::CreateLogger("PHM", "Platform health management");
    logger.LogVerbose() << instance_ << " reports checkpoint " << checkpoint;
}

}  // namespace ara::phm
