// What a proxy has in common with its events, fields and methods: the instance that it is connected to.
#ifndef BENCH_PROXY_CONNECTION_H_
#define BENCH_PROXY_CONNECTION_H_

#include <functional>
#include <memory>

#include "ara/core/promise.h"
#include "bench/handle.h"
#include "bench/reader.h"
#include "bench/writer.h"

namespace bench {

class ProxyConnection {
public:
    explicit ProxyConnection(const Handle& handle) noexcept : handle_{handle} {}

    const Handle& GetHandle() const noexcept { return handle_; }
    const ServiceDescription& Service() const noexcept { return handle_.Service(); }

    // Sends a request; the future has the answer, or why there is none.
    template <typename Output>
    ara::core::Future<Output> Call(std::uint16_t method, const Writer& arguments) const {
        auto promise = std::make_shared<ara::core::Promise<Output>>();
        auto future = promise->get_future();
        Request(method, arguments.Payload(),
                [promise, settings = &Service().serialization](const ara::core::Result<ByteView>& answer) {
                    Give(*promise, answer, *settings);
                });
        return future;
    }

private:
    using Answer = std::function<void(const ara::core::Result<ByteView>&)>;

    template <typename Output>
    static void Give(ara::core::Promise<Output>& promise, const ara::core::Result<ByteView>& answer,
                     const Serialization& settings) {
        if (!answer) {
            promise.SetError(answer.Error());
        } else if constexpr (std::is_void_v<Output>) {
            promise.set_value();
        } else {
            Reader reader{answer.Value(), settings};
            Output output{};
            Codec<Output>::Read(reader, output);
            reader.IsValid() ? promise.set_value(std::move(output)) : promise.SetError(Malformed());
        }
    }

    static ara::core::ErrorCode Malformed() noexcept;
    void Request(std::uint16_t method, const Bytes& arguments, Answer answer) const;

    Handle handle_;
};

}  // namespace bench

#endif  // BENCH_PROXY_CONNECTION_H_
