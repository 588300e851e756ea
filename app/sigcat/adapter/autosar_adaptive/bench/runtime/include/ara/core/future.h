// A value that comes later (SWS_CORE_00321).
#ifndef ARA_CORE_FUTURE_H_
#define ARA_CORE_FUTURE_H_

#include <chrono>
#include <memory>
#include <type_traits>
#include <utility>

#include "ara/core/future_error_domain.h"
#include "ara/core/future_state.h"
#include "ara/core/result.h"

namespace ara::core {

enum class future_status : std::uint8_t { ready = 1, timeout = 2 };

template <typename T, typename E>
class Promise;

template <typename T, typename E = ErrorCode>
class Future final {
public:
    using PromiseType = Promise<T, E>;

    Future() noexcept = default;
    Future(const Future&) = delete;
    Future& operator=(const Future&) = delete;
    Future(Future&&) noexcept = default;
    Future& operator=(Future&&) noexcept = default;
    ~Future() = default;

    bool valid() const noexcept { return state_ != nullptr; }
    bool is_ready() const { return state_->IsReady(); }
    void wait() const { state_->Wait(); }

    template <typename Rep, typename Period>
    future_status wait_for(const std::chrono::duration<Rep, Period>& duration) const {
        return wait_until(std::chrono::steady_clock::now() + duration);
    }

    template <typename Clock, typename Duration>
    future_status wait_until(const std::chrono::time_point<Clock, Duration>& deadline) const {
        return state_->WaitUntil(deadline) ? future_status::ready : future_status::timeout;
    }

    // Waits; the value is gone afterwards.
    Result<T, E> GetResult() noexcept {
        if (!valid()) {
            return Result<T, E>::FromError(future_errc::no_state);
        }
        return std::exchange(state_, nullptr)->Take();
    }

    // Waits; throws the error.
    T get() { return GetResult().ValueOrThrow(); }

    // What `func` makes of this future when it is ready: called by whoever sets the value, or at once. Where it gives
    // a result, the error of that is the error of the returned future.
    template <typename F>
    auto then(F&& func) {
        using Made = std::decay_t<std::invoke_result_t<std::decay_t<F>, Future>>;
        using Next = typename future_detail::Unwrapped<Made, E>::type;
        auto state = std::exchange(state_, nullptr);
        auto next = std::make_shared<future_detail::State<Next, E>>();
        // The state holds its continuation only until it runs, so that the two do not keep each other alive.
        auto& waited = *state;
        waited.Then([next, own = std::move(state), call = std::decay_t<F>{std::forward<F>(func)}]() mutable {
            if constexpr (std::is_void_v<Made>) {
                call(Future{std::move(own)});
                next->Set(Result<void, E>{});
            } else {
                next->Set(Result<Next, E>{call(Future{std::move(own)})});
            }
        });
        return Future<Next, E>{std::move(next)};
    }

private:
    friend class Promise<T, E>;
    template <typename, typename>
    friend class Future;

    explicit Future(std::shared_ptr<future_detail::State<T, E>> state) noexcept : state_{std::move(state)} {}

    std::shared_ptr<future_detail::State<T, E>> state_;
};

}  // namespace ara::core

#endif  // ARA_CORE_FUTURE_H_
