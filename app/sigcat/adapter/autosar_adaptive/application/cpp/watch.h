// Finds a call that runs for longer than it may, while it runs.

#ifndef APPLICATION_WATCH_H
#define APPLICATION_WATCH_H

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace application {

/// Its thread looks once for each call, when that has ended if all is well: calls that come regularly do not have to wake it.
class Watch final {
public:
    /// Calls `supervise` in a separate thread, again and again until a late call has ended.
    explicit Watch(std::function<void()> supervise);
    ~Watch();
    Watch(const Watch&) = delete;
    Watch(Watch&&) = delete;
    Watch& operator=(const Watch&) = delete;
    Watch& operator=(Watch&&) = delete;

    /// A call begins.
    void Begin(std::chrono::nanoseconds longest);

    /// It has ended.
    void End();

private:
    using Time = std::chrono::steady_clock::time_point;

    void Run();
    Time NextLook(Time now) const;

    std::function<void()> supervise_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::chrono::nanoseconds longest_{0};
    std::chrono::nanoseconds interval_{0};
    Time began_;
    Time late_;
    Time look_;
    bool is_running_{false};
    bool is_stopped_{false};
    std::thread thread_;
};

}  // namespace application

#endif  // APPLICATION_WATCH_H
