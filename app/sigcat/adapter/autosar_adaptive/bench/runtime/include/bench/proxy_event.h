// Event of a proxy (SWS_CM_00005).
#ifndef BENCH_PROXY_EVENT_H_
#define BENCH_PROXY_EVENT_H_

#include <limits>
#include <memory>
#include <utility>

#include "ara/com/com_error_domain.h"
#include "bench/event_receiver.h"

namespace bench {

template <typename T>
class ProxyEvent : public EventReceiver {
public:
    using SampleType = T;
    using EventReceiver::EventReceiver;

    // Gives what has come since to `f`, as `SamplePtr<SampleType const>`, and says how many there were.
    template <typename F>
    ara::core::Result<std::size_t> GetNewSamples(
        F&& f, std::size_t maxNumberOfSamples = std::numeric_limits<std::size_t>::max()) {
        if (GetFreeSampleCount() == 0) {
            return ara::core::Result<std::size_t>::FromError(ara::com::ComErrc::kMaxSamplesExceeded);
        }
        std::size_t count = 0;
        while (count < maxNumberOfSamples) {
            auto received = Next();
            if (!received.has_value()) {
                break;
            }
            if (auto sample = Read(std::move(*received)); sample) {
                std::forward<F>(f)(std::move(sample));
                ++count;
            }
        }
        return count;
    }

private:
    struct Held {
        T value;
        std::shared_ptr<void> place;
    };

    ara::com::SamplePtr<const T> Read(Received received) {
        auto held = std::make_shared<Held>(Held{T{}, std::move(received.place)});
        if (received.status == ara::com::e2e::ProfileCheckStatus::kError) {
            return {std::shared_ptr<const T>{held, &held->value}, received.status, received.sent_at};  // its bytes mean nothing
        }
        Reader reader{received.payload, connection_->Service().serialization};
        Codec<T>::Read(reader, held->value);
        if (!reader.IsValid()) {
            TellMalformed();
            return nullptr;
        }
        return {std::shared_ptr<const T>{held, &held->value}, received.status, received.sent_at};
    }
};

}  // namespace bench

#endif  // BENCH_PROXY_EVENT_H_
