// What a function keeps from one run to the next, in a key-value storage.

#ifndef APPLICATION_STORAGE_H
#define APPLICATION_STORAGE_H

#include <cstddef>
#include <utility>

#include "application/values.h"
#include "ara/core/array.h"
#include "ara/core/error_code.h"
#include "ara/core/instance_specifier.h"
#include "ara/core/optional.h"
#include "ara/core/result.h"
#include "ara/core/string.h"
#include "ara/core/string_view.h"
#include "ara/log/logger.h"
#include "ara/per/key_value_storage.h"
#include "ara/per/per_error_domain.h"

namespace application {

class Storage final {
public:
    Storage(const char* port, ara::log::Logger& logger) : port_{port}, logger_(logger) {
        auto opened = ara::per::OpenKeyValueStorage(ara::core::InstanceSpecifier{port});
        if (opened.HasValue()) {
            storage_.emplace(std::move(opened).Value());
        } else {
            logger_.LogError() << port << " cannot be opened: " << opened.Error().Message();
        }
    }

    /// False, and the value as it was, if nothing is stored under this key or it cannot be read. An error is logged.
    template <typename Value>
    bool Read(ara::core::StringView key, Value& value) const {
        using Stored = typename As<Value>::Type;
        if (!storage_.has_value()) {
            return false;
        }
        const auto stored = (*storage_)->template GetValue<Stored>(key);
        if (stored.HasValue()) {
            Assign(stored.Value(), value);
        } else if (stored.Error() != ara::core::ErrorCode{ara::per::PerErrc::kKeyNotFound}) {
            logger_.LogError() << port_ << ", key " << key << ": the value cannot be read: " << stored.Error().Message();
        }
        return stored.HasValue();
    }

    template <typename Value>
    void Write(ara::core::StringView key, const Value& value) {
        if (storage_.has_value()) {
            typename As<Value>::Type stored{};
            Assign(value, stored);
            Check((*storage_)->SetValue(key, stored));
        }
    }

    /// The counts of an error, each under its own key.
    template <typename Counts>
    void ReadCounts(ara::core::StringView error, Counts& counts) const {
        const ara::core::String name{error};
        Read(name + "_Occurrences", counts.occurrences);
        Read(name + "_IgnitionCycles", counts.ignition_cycles);
        Read(name + "_HasFailed", counts.has_failed);
        Read(name + "_IsTested", counts.is_tested);
    }

    template <typename Counts>
    void WriteCounts(ara::core::StringView error, const Counts& counts) {
        const ara::core::String name{error};
        Write(name + "_Occurrences", counts.occurrences);
        Write(name + "_IgnitionCycles", counts.ignition_cycles);
        Write(name + "_HasFailed", counts.has_failed);
        Write(name + "_IsTested", counts.is_tested);
    }

    /// Makes what was written permanent, all of it or nothing.
    void Save() {
        if (storage_.has_value()) {
            Check((*storage_)->SyncToStorage());
        }
    }

private:
    /// How a value is stored: an array of the core as one of the platform.
    template <typename Value>
    struct As final {
        using Type = Value;
    };
    template <typename Element, std::size_t size>
    struct As<Element[size]> final {
        using Type = ara::core::Array<Element, size>;
    };

    void Check(const ara::core::Result<void>& result) {
        if (!result.HasValue()) {
            logger_.LogError() << port_ << " cannot be written: " << result.Error().Message();
        }
    }

    const char* port_;
    ara::log::Logger& logger_;
    ara::core::Optional<ara::per::SharedHandle<ara::per::KeyValueStorage>> storage_;
};

}  // namespace application

#endif  // APPLICATION_STORAGE_H
