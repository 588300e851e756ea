// What a skeleton has in common with its events, fields and methods: the instance that it offers.
#ifndef BENCH_SKELETON_CONNECTION_H_
#define BENCH_SKELETON_CONNECTION_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <tuple>
#include <utility>

#include "ara/com/types.h"
#include "ara/core/instance_specifier.h"
#include "ara/core/promise.h"
#include "bench/description.h"
#include "bench/reader.h"
#include "bench/writer.h"

namespace bench {

class ProvidedInstance;
struct Caller;

// The answer to one request: sent once, from any thread, or not at all if the service is no longer offered.
class Reply {
public:
    explicit Reply(std::shared_ptr<const Caller> caller) noexcept : caller_{std::move(caller)} {}

    void Send(const Writer& values) const;
    void Fail(const ara::core::ErrorCode& error) const;
    void FailMalformed() const;

private:
    std::shared_ptr<const Caller> caller_;
};

class SkeletonConnection {
public:
    using Handler = std::function<void(Reader& arguments, const Reply& reply)>;

    // Throws ComException if the service has no such instance.
    SkeletonConnection(const ServiceDescription& service, const ara::core::InstanceSpecifier& port,
                       ara::com::MethodCallProcessingMode mode);
    SkeletonConnection(const ServiceDescription& service, const ara::com::InstanceIdentifier& instance,
                       ara::com::MethodCallProcessingMode mode);
    SkeletonConnection(const SkeletonConnection&) = delete;
    SkeletonConnection& operator=(const SkeletonConnection&) = delete;
    ~SkeletonConnection();

    const ServiceDescription& Service() const noexcept { return service_; }

    ara::core::Result<void> OfferService();
    // No handler runs when this has returned, unless it is a handler that calls it.
    void StopOfferService();
    ara::core::Future<bool> ProcessNextMethodCall();

    ara::core::Result<void> Send(const EventDescription& event, const Writer& value);

    // A field: it has no value at first, and without one the service cannot be offered.
    void AddField(const EventDescription& notifier, std::uint16_t getter);
    bool Keep(const EventDescription& notifier, const Writer& value);
    void AddSetter(std::uint16_t setter);

    void SetHandler(std::uint16_t method, Handler handler);

    // A method: its arguments are read, `call` gives a future of the answer.
    template <typename R, typename... Args, typename F>
    void SetMethod(std::uint16_t method, F&& call) {
        SetHandler(method, [call = std::forward<F>(call)](Reader& reader, const Reply& reply) {
            std::tuple<Args...> arguments{};
            std::apply([&](Args&... each) { (Codec<Args>::Read(reader, each), ...); }, arguments);
            if (!reader.IsValid()) {
                reply.FailMalformed();
                return;
            }
            AnswerWith<R>(std::apply(call, std::move(arguments)), reply, reader.Settings());
        });
    }

private:
    // Answers when the value is there.
    template <typename R>
    static void AnswerWith(ara::core::Future<R> future, const Reply& reply, const Serialization& serialization) {
        future.then([reply, settings = &serialization](ara::core::Future<R> done) {
            auto result = done.GetResult();
            if (!result) {
                reply.Fail(result.Error());
                return;
            }
            Writer writer{*settings};
            if constexpr (!std::is_void_v<R>) {
                Codec<R>::Write(writer, result.Value());
            }
            reply.Send(writer);
        });
    }

    const ServiceDescription& service_;
    std::shared_ptr<ProvidedInstance> instance_;
};

}  // namespace bench

#endif  // BENCH_SKELETON_CONNECTION_H_
