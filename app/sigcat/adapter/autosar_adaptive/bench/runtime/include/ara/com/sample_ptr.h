// A received sample, which is freed with its pointer (SWS_CM_00306).
#ifndef ARA_COM_SAMPLE_PTR_H_
#define ARA_COM_SAMPLE_PTR_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "ara/com/e2e/types.h"

namespace ara::com {

template <typename T>
class SamplePtr final {
public:
    constexpr SamplePtr() noexcept = default;
    constexpr SamplePtr(std::nullptr_t) noexcept {}
    SamplePtr(const SamplePtr&) = delete;
    SamplePtr& operator=(const SamplePtr&) = delete;
    SamplePtr(SamplePtr&&) noexcept = default;
    SamplePtr& operator=(SamplePtr&&) noexcept = default;
    SamplePtr& operator=(std::nullptr_t) noexcept {
        sample_.reset();
        return *this;
    }
    ~SamplePtr() noexcept = default;

    T& operator*() const noexcept { return *sample_; }
    T* operator->() const noexcept { return sample_.get(); }
    explicit operator bool() const noexcept { return sample_ != nullptr; }
    T* Get() const noexcept { return sample_.get(); }
    void Swap(SamplePtr& other) noexcept { std::swap(*this, other); }
    void Reset(std::nullptr_t) noexcept { sample_.reset(); }
    e2e::ProfileCheckStatus GetProfileCheckStatus() const noexcept { return status_; }

    // For the runtime: what frees the sample also gives its place back to the event.
    SamplePtr(std::shared_ptr<T> sample, e2e::ProfileCheckStatus status,
              std::optional<std::uint64_t> sent_at = std::nullopt) noexcept
        : sample_{std::move(sample)}, status_{status}, sent_at_{sent_at} {}

    // For who records at a bench, and of no platform: in ns of the machine's steady clock, if its sender tells it.
    std::optional<std::uint64_t> BenchSentAt() const noexcept { return sent_at_; }

private:
    std::shared_ptr<T> sample_;
    e2e::ProfileCheckStatus status_ = e2e::ProfileCheckStatus::kNotAvailable;
    std::optional<std::uint64_t> sent_at_;
};

}  // namespace ara::com

#endif  // ARA_COM_SAMPLE_PTR_H_
