// Who gives the value of a future (SWS_CORE_00340).
#ifndef ARA_CORE_PROMISE_H_
#define ARA_CORE_PROMISE_H_

#include <memory>
#include <utility>

#include "ara/core/future.h"

namespace ara::core {

template <typename T, typename E = ErrorCode>
class Promise final {
public:
    Promise() : state_{std::make_shared<future_detail::State<T, E>>()} {}
    Promise(const Promise&) = delete;
    Promise& operator=(const Promise&) = delete;
    Promise(Promise&&) noexcept = default;
    Promise& operator=(Promise&& other) noexcept {
        Promise{std::move(other)}.swap(*this);
        return *this;
    }
    ~Promise() {
        if (state_ != nullptr) {
            state_->Set(Result<T, E>{E{future_errc::broken_promise}});
        }
    }

    void swap(Promise& other) noexcept { state_.swap(other.state_); }

    Future<T, E> get_future() { return Future<T, E>{state_}; }

    template <typename... Value>
    void set_value(Value&&... value) {
        SetResult(Result<T, E>{std::forward<Value>(value)...});
    }
    void SetError(E error) { SetResult(Result<T, E>{std::move(error)}); }
    void SetResult(Result<T, E> result) { state_->Set(std::move(result)); }

private:
    std::shared_ptr<future_detail::State<T, E>> state_;
};

}  // namespace ara::core

#endif  // ARA_CORE_PROMISE_H_
