// Keeps methods and calls apart: calls may run at the same time, a method runs alone.

#ifndef APPLICATION_CALL_MUTEX_H
#define APPLICATION_CALL_MUTEX_H

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace application {

/// A shared mutex for std::shared_lock (calls) and std::lock_guard (methods). A call never waits for a method that waits itself,
/// which std::shared_timed_mutex leaves open: else a long call would block an urgent one.
class CallMutex final {
public:
    void lock_shared() {
        std::unique_lock<std::mutex> lock{mutex_};
        changed_.wait(lock, [this] { return !is_alone_; });
        ++calls_;
    }

    void unlock_shared() {
        {
            const std::lock_guard<std::mutex> lock{mutex_};
            --calls_;
        }
        changed_.notify_all();
    }

    void lock() {
        std::unique_lock<std::mutex> lock{mutex_};
        changed_.wait(lock, [this] { return !is_alone_ && calls_ == 0U; });
        is_alone_ = true;
    }

    void unlock() {
        {
            const std::lock_guard<std::mutex> lock{mutex_};
            is_alone_ = false;
        }
        changed_.notify_all();
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint32_t calls_{0};
    bool is_alone_{false};
};

}  // namespace application

#endif  // APPLICATION_CALL_MUTEX_H
