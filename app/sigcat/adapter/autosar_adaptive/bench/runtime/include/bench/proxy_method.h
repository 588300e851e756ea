// Method of a proxy (SWS_CM_00006).
#ifndef BENCH_PROXY_METHOD_H_
#define BENCH_PROXY_METHOD_H_

#include <cstdint>
#include <memory>

#include "bench/proxy_connection.h"

namespace bench {

template <typename Signature>
class ProxyMethod;

template <typename R, typename... Args>
class ProxyMethod<R(Args...)> {
public:
    ProxyMethod(const std::shared_ptr<ProxyConnection>& connection, std::uint16_t id) noexcept
        : connection_{connection}, id_{id} {}

    ara::core::Future<R> operator()(const Args&... arguments) const {
        Writer writer{connection_->Service().serialization};
        (Codec<Args>::Write(writer, arguments), ...);
        return connection_->template Call<R>(id_, writer);
    }

private:
    std::shared_ptr<ProxyConnection> connection_;
    std::uint16_t id_;
};

}  // namespace bench

#endif  // BENCH_PROXY_METHOD_H_
