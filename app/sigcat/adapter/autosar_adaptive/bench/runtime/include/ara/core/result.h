// A value, or the error that came instead (SWS_CORE_00701, SWS_CORE_00801).
#ifndef ARA_CORE_RESULT_H_
#define ARA_CORE_RESULT_H_

#include <type_traits>
#include <utility>
#include <variant>

#include "ara/core/error_code.h"

namespace ara::core {

template <typename T, typename E = ErrorCode>
class [[nodiscard]] Result final {
public:
    using value_type = T;
    using error_type = E;

    Result(const T& value) : held_{std::in_place_index<0>, value} {}
    Result(T&& value) : held_{std::in_place_index<0>, std::move(value)} {}
    explicit Result(const E& error) : held_{std::in_place_index<1>, error} {}
    explicit Result(E&& error) : held_{std::in_place_index<1>, std::move(error)} {}

    static Result FromValue(T value) { return Result{std::move(value)}; }
    static Result FromError(E error) { return Result{std::move(error)}; }
    template <typename... Args>
    static Result FromError(Args&&... args) {
        return Result{E{std::forward<Args>(args)...}};
    }

    template <typename... Args>
    void EmplaceValue(Args&&... args) {
        held_.template emplace<0>(std::forward<Args>(args)...);
    }
    template <typename... Args>
    void EmplaceError(Args&&... args) {
        held_.template emplace<1>(std::forward<Args>(args)...);
    }

    bool HasValue() const noexcept { return held_.index() == 0; }
    explicit operator bool() const noexcept { return HasValue(); }

    const T& operator*() const& noexcept { return *std::get_if<0>(&held_); }
    T&& operator*() && noexcept { return std::move(*std::get_if<0>(&held_)); }
    const T* operator->() const noexcept { return std::get_if<0>(&held_); }
    const T& Value() const& noexcept { return **this; }
    T&& Value() && noexcept { return *std::move(*this); }
    const E& Error() const& noexcept { return *std::get_if<1>(&held_); }
    E&& Error() && noexcept { return std::move(*std::get_if<1>(&held_)); }

    template <typename U>
    T ValueOr(U&& otherwise) const& {
        return HasValue() ? Value() : static_cast<T>(std::forward<U>(otherwise));
    }
    template <typename U>
    T ValueOr(U&& otherwise) && {
        return HasValue() ? std::move(*this).Value() : static_cast<T>(std::forward<U>(otherwise));
    }
    template <typename G>
    bool CheckError(G&& error) const {
        return !HasValue() && Error() == static_cast<E>(std::forward<G>(error));
    }

    const T& ValueOrThrow() const& {
        if (!HasValue()) {
            Error().ThrowAsException();
        }
        return Value();
    }
    T&& ValueOrThrow() && {
        if (!HasValue()) {
            Error().ThrowAsException();
        }
        return std::move(*this).Value();
    }

    // What `f` makes of the value, or the error.
    template <typename F>
    auto Bind(F&& f) const -> Result<std::decay_t<std::invoke_result_t<F, const T&>>, E> {
        using Bound = Result<std::decay_t<std::invoke_result_t<F, const T&>>, E>;
        return HasValue() ? Bound{std::forward<F>(f)(Value())} : Bound{Error()};
    }

private:
    std::variant<T, E> held_;
};

template <typename E>
class [[nodiscard]] Result<void, E> final {
public:
    using value_type = void;
    using error_type = E;

    Result() noexcept = default;
    explicit Result(const E& error) : held_{std::in_place_index<1>, error} {}
    explicit Result(E&& error) : held_{std::in_place_index<1>, std::move(error)} {}

    static Result FromValue() noexcept { return {}; }
    static Result FromError(E error) { return Result{std::move(error)}; }
    template <typename... Args>
    static Result FromError(Args&&... args) {
        return Result{E{std::forward<Args>(args)...}};
    }

    bool HasValue() const noexcept { return held_.index() == 0; }
    explicit operator bool() const noexcept { return HasValue(); }
    void Value() const noexcept {}
    const E& Error() const& noexcept { return *std::get_if<1>(&held_); }
    E&& Error() && noexcept { return std::move(*std::get_if<1>(&held_)); }
    template <typename G>
    bool CheckError(G&& error) const {
        return !HasValue() && Error() == static_cast<E>(std::forward<G>(error));
    }
    void ValueOrThrow() const {
        if (!HasValue()) {
            Error().ThrowAsException();
        }
    }

private:
    std::variant<std::monostate, E> held_;
};

}  // namespace ara::core

#endif  // ARA_CORE_RESULT_H_
