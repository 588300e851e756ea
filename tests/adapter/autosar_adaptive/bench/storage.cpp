// A storage that an adapter uses: which reads are errors, and what is logged.

#include <cstdint>
#include <iostream>

#include "application/storage.h"
#include "ara/core/initialization.h"

int main() {
    if (!ara::core::Initialize().HasValue()) {
        return 1;
    }
    auto& logger = ara::log::CreateLogger("STOR", "storage");
    application::Storage storage{"Probe/Storage", logger};
    std::uint8_t count{7U};
    std::cout << "absent: " << storage.Read("Count", count) << ", " << static_cast<int>(count) << std::endl;
    storage.Write("Count", static_cast<std::uint8_t>(8U));
    std::cout << "there: " << storage.Read("Count", count) << ", " << static_cast<int>(count) << std::endl;
    double other{1.5};
    std::cout << "of another type: " << storage.Read("Count", other) << ", " << other << std::endl;
    storage.Save();
    return ara::core::Deinitialize().HasValue() ? 0 : 1;
}
