// What waits until the execution management asks the process to end.

#ifndef APPLICATION_TERMINATION_H
#define APPLICATION_TERMINATION_H

#include <condition_variable>
#include <mutex>

namespace application {

class Termination final {
public:
    /// From any thread, more than once.
    void Request() {
        {
            const std::lock_guard<std::mutex> lock{mutex_};
            is_requested_ = true;
        }
        changed_.notify_all();
    }

    void Wait() {
        std::unique_lock<std::mutex> lock{mutex_};
        changed_.wait(lock, [this] { return is_requested_; });
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool is_requested_{false};
};

}  // namespace application

#endif  // APPLICATION_TERMINATION_H
