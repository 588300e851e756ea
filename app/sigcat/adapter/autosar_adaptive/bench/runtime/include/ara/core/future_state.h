// What a future and its promise share. Not for applications.
#ifndef ARA_CORE_FUTURE_STATE_H_
#define ARA_CORE_FUTURE_STATE_H_

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "ara/core/result.h"

namespace ara::core::future_detail {

// What a future is of whose continuation gives a value, or a result.
template <typename T, typename E>
struct Unwrapped {
    using type = T;
};
template <typename T, typename E>
struct Unwrapped<Result<T, E>, E> {
    using type = T;
};

// A continuation that is moved, as what it captures may be.
class Continuation {
public:
    Continuation() noexcept = default;
    template <typename F, typename = std::enable_if_t<!std::is_same_v<std::decay_t<F>, Continuation>>>
    explicit Continuation(F&& call) : call_{std::make_unique<Held<std::decay_t<F>>>(std::forward<F>(call))} {}

    explicit operator bool() const noexcept { return call_ != nullptr; }
    void operator()() { call_->Call(); }

private:
    struct Callable {
        virtual ~Callable() = default;
        virtual void Call() = 0;
    };
    template <typename F>
    struct Held final : Callable {
        explicit Held(F&& call) : call_{std::move(call)} {}
        void Call() override { call_(); }
        F call_;
    };
    std::unique_ptr<Callable> call_;
};

template <typename T, typename E>
class State {
public:
    // False if there is one already.
    bool Set(Result<T, E> result) {
        Continuation next;
        {
            std::lock_guard<std::mutex> lock{mutex_};
            if (result_.has_value()) {
                return false;
            }
            result_.emplace(std::move(result));
            next = std::move(continuation_);
        }
        ready_.notify_all();
        if (next) {
            next();
        }
        return true;
    }

    bool IsReady() const {
        std::lock_guard<std::mutex> lock{mutex_};
        return result_.has_value();
    }

    void Wait() const {
        std::unique_lock<std::mutex> lock{mutex_};
        ready_.wait(lock, [this] { return result_.has_value(); });
    }

    template <typename TimePoint>
    bool WaitUntil(const TimePoint& deadline) const {
        std::unique_lock<std::mutex> lock{mutex_};
        return ready_.wait_until(lock, deadline, [this] { return result_.has_value(); });
    }

    Result<T, E> Take() {
        Wait();
        std::lock_guard<std::mutex> lock{mutex_};
        return std::move(*result_);
    }

    template <typename F>
    void Then(F&& call) {
        Continuation next{std::forward<F>(call)};
        {
            std::lock_guard<std::mutex> lock{mutex_};
            if (!result_.has_value()) {
                continuation_ = std::move(next);
                return;
            }
        }
        next();
    }

private:
    mutable std::mutex mutex_;
    mutable std::condition_variable ready_;
    std::optional<Result<T, E>> result_;
    Continuation continuation_;
};

}  // namespace ara::core::future_detail

#endif  // ARA_CORE_FUTURE_STATE_H_
