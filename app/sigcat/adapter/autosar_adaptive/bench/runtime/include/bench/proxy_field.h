// Fields of a proxy (SWS_CM_00008).
#ifndef BENCH_PROXY_FIELD_H_
#define BENCH_PROXY_FIELD_H_

#include <cstdint>

#include "bench/proxy_event.h"

namespace bench {

// An event that has a value from the beginning.
template <typename T>
class NotifiedProxyField : public ProxyEvent<T> {
public:
    using FieldType = T;

    using ProxyEvent<T>::ProxyEvent;
};

// It can be asked for its value too.
template <typename T>
class ProxyField : public NotifiedProxyField<T> {
public:
    ProxyField(const std::shared_ptr<ProxyConnection>& connection, const EventDescription& notifier,
               std::uint16_t getter)
        : NotifiedProxyField<T>{connection, notifier}, getter_{getter} {}

    ara::core::Future<T> Get() const {
        return this->connection_->template Call<T>(getter_, Writer{this->connection_->Service().serialization});
    }

private:
    std::uint16_t getter_;
};

// A field that its users can set.
template <typename T>
class WritableProxyField : public ProxyField<T> {
public:
    WritableProxyField(const std::shared_ptr<ProxyConnection>& connection, const EventDescription& notifier,
                       std::uint16_t getter, std::uint16_t setter)
        : ProxyField<T>{connection, notifier, getter}, setter_{setter} {}

    // The value that the field has then, which need not be the one that was asked for.
    ara::core::Future<T> Set(const T& value) const {
        Writer writer{this->connection_->Service().serialization};
        Codec<T>::Write(writer, value);
        return this->connection_->template Call<T>(setter_, writer);
    }

private:
    std::uint16_t setter_;
};

}  // namespace bench

#endif  // BENCH_PROXY_FIELD_H_
