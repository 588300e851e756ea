// What several parts of a process hold together (SWS_PER_00362). A const handle can only read.
#ifndef ARA_PER_SHARED_HANDLE_H_
#define ARA_PER_SHARED_HANDLE_H_

#include <memory>
#include <utility>

namespace ara::per {

template <typename T>
class SharedHandle final {
public:
    SharedHandle(const SharedHandle&) = default;
    SharedHandle(SharedHandle&&) noexcept = default;
    SharedHandle& operator=(const SharedHandle&) & = default;
    SharedHandle& operator=(SharedHandle&&) & noexcept = default;
    ~SharedHandle() = default;

    T* operator->() noexcept { return held_.get(); }
    const T* operator->() const noexcept { return held_.get(); }
    T& operator*() noexcept { return *held_; }
    const T& operator*() const noexcept { return *held_; }
    explicit operator bool() const noexcept { return held_ != nullptr; }

    // For the runtime.
    explicit SharedHandle(std::shared_ptr<T> held) noexcept : held_{std::move(held)} {}

private:
    std::shared_ptr<T> held_;
};

}  // namespace ara::per

#endif  // ARA_PER_SHARED_HANDLE_H_
