// Values that outlive the process (SWS_PER_00339). In the bench, those of a port are a file in the folder that
// BENCH_STORAGE names; without one they are kept in memory only. A file is replaced whole, or not at all.
#ifndef ARA_PER_KEY_VALUE_STORAGE_H_
#define ARA_PER_KEY_VALUE_STORAGE_H_

#include <cstddef>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <type_traits>

#include "ara/core/instance_specifier.h"
#include "ara/core/result.h"
#include "ara/core/string.h"
#include "ara/core/string_view.h"
#include "ara/core/vector.h"
#include "ara/per/per_error_domain.h"
#include "ara/per/shared_handle.h"

namespace ara::per {

class KeyValueStorage final {
public:
    explicit KeyValueStorage(std::string file) : file_{std::move(file)} {}
    KeyValueStorage(const KeyValueStorage&) = delete;
    KeyValueStorage& operator=(const KeyValueStorage&) = delete;

    ara::core::Result<ara::core::Vector<ara::core::String>> GetAllKeys() const noexcept;
    ara::core::Result<bool> KeyExists(ara::core::StringView key) const noexcept;
    ara::core::Result<void> RemoveKey(ara::core::StringView key) noexcept;
    ara::core::Result<void> RemoveAllKeys() noexcept;

    template <typename T>
    ara::core::Result<T> GetValue(ara::core::StringView key) const noexcept {
        static_assert(std::is_trivially_copyable_v<T>, "the bench stores numbers, and arrays and structs of them");
        T value{};
        const auto got = Get(key, &value, sizeof value);
        return got ? ara::core::Result<T>{value} : ara::core::Result<T>{got.Error()};
    }

    template <typename T>
    ara::core::Result<void> SetValue(ara::core::StringView key, const T& value) noexcept {
        static_assert(std::is_trivially_copyable_v<T>, "the bench stores numbers, and arrays and structs of them");
        return Set(key, &value, sizeof value);
    }

    // Until then, what was set can be discarded.
    ara::core::Result<void> SyncToStorage() const noexcept;
    ara::core::Result<void> DiscardPendingChanges() noexcept;

private:
    using Values = std::map<std::string, std::string, std::less<>>;

    ara::core::Result<void> Get(ara::core::StringView key, void* value, std::size_t size) const noexcept;
    ara::core::Result<void> Set(ara::core::StringView key, const void* value, std::size_t size) noexcept;

    mutable std::mutex mutex_;
    std::string file_;
    Values values_;
};

ara::core::Result<SharedHandle<KeyValueStorage>> OpenKeyValueStorage(const ara::core::InstanceSpecifier& kvs) noexcept;

}  // namespace ara::per

#endif  // ARA_PER_KEY_VALUE_STORAGE_H_
