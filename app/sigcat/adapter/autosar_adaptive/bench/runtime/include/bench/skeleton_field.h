// Field of a skeleton (SWS_CM_00007).
#ifndef BENCH_SKELETON_FIELD_H_
#define BENCH_SKELETON_FIELD_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "bench/skeleton_connection.h"

namespace bench {

template <typename T>
class SkeletonField {
public:
    using FieldType = T;

    // Without a getter, 0: it only notifies.
    SkeletonField(const std::shared_ptr<SkeletonConnection>& connection, const EventDescription& notifier,
                  std::uint16_t getter = 0)
        : connection_{connection}, notifier_{&notifier}, getter_{getter} {
        connection_->AddField(notifier, getter);
    }

    // Sends the value, and keeps it for who subscribes or asks later.
    ara::core::Result<void> Update(const T& value) {
        Changed(*connection_, *notifier_, value);
        return {};
    }

    // Asked instead of the kept value.
    ara::core::Result<void> RegisterGetHandler(std::function<ara::core::Future<T>()> handler) {
        connection_->SetMethod<T>(getter_, std::move(handler));
        return {};
    }

protected:
    static void Changed(SkeletonConnection& connection, const EventDescription& notifier, const T& value) {
        Writer writer{connection.Service().serialization};
        Codec<T>::Write(writer, value);
        if (connection.Keep(notifier, writer)) {
            // Before the service is offered, the value is only kept.
            static_cast<void>(connection.Send(notifier, writer));
        }
    }

    std::shared_ptr<SkeletonConnection> connection_;
    const EventDescription* notifier_;

private:
    std::uint16_t getter_;
};

// A field that its users can set: the service is offered only with a handler that says which value it gets.
template <typename T>
class WritableSkeletonField : public SkeletonField<T> {
public:
    WritableSkeletonField(const std::shared_ptr<SkeletonConnection>& connection, const EventDescription& notifier,
                          std::uint16_t getter, std::uint16_t setter)
        : SkeletonField<T>{connection, notifier, getter}, setter_{setter} {
        connection->AddSetter(setter);
    }

    ara::core::Result<void> RegisterSetHandler(std::function<ara::core::Future<T>(const T& value)> handler) {
        // Weak, as the value may arrive after the end of the skeleton.
        std::weak_ptr<SkeletonConnection> weak = this->connection_;
        this->connection_->template SetMethod<T, T>(
            setter_, [weak, notifier = this->notifier_, handler = std::move(handler)](const T& wanted) {
                return handler(wanted).then([weak, notifier](ara::core::Future<T> set) {
                    auto result = set.GetResult();
                    if (auto connection = weak.lock(); connection != nullptr && result) {
                        SkeletonField<T>::Changed(*connection, *notifier, result.Value());
                    }
                    return result;
                });
            });
        return {};
    }

private:
    std::uint16_t setter_;
};

}  // namespace bench

#endif  // BENCH_SKELETON_FIELD_H_
