// Elements of another owner, one after the other (SWS_CORE_01901).
#ifndef ARA_CORE_SPAN_H_
#define ARA_CORE_SPAN_H_

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace ara::core {

template <typename T>
class Span {
public:
    using element_type = T;
    using value_type = std::remove_cv_t<T>;

    constexpr Span() noexcept = default;
    constexpr Span(T* data, std::size_t size) noexcept : data_{data}, size_{size} {}
    template <std::size_t N>
    constexpr Span(T (&elements)[N]) noexcept : data_{elements}, size_{N} {}
    template <std::size_t N>
    constexpr Span(const std::array<value_type, N>& elements) noexcept : data_{elements.data()}, size_{N} {}
    Span(const std::vector<value_type>& elements) noexcept : data_{elements.data()}, size_{elements.size()} {}

    constexpr T* data() const noexcept { return data_; }
    constexpr std::size_t size() const noexcept { return size_; }
    constexpr bool empty() const noexcept { return size_ == 0; }
    constexpr T& operator[](std::size_t index) const noexcept { return data_[index]; }
    constexpr T* begin() const noexcept { return data_; }
    constexpr T* end() const noexcept { return data_ + size_; }
    constexpr Span subspan(std::size_t offset) const noexcept { return {data_ + offset, size_ - offset}; }
    constexpr Span subspan(std::size_t offset, std::size_t count) const noexcept { return {data_ + offset, count}; }
    constexpr Span first(std::size_t count) const noexcept { return {data_, count}; }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace ara::core

#endif  // ARA_CORE_SPAN_H_
