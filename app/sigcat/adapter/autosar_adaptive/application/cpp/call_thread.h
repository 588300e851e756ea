// A thread that runs the calls of one priority.

#ifndef APPLICATION_CALL_THREAD_H
#define APPLICATION_CALL_THREAD_H

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "ara/log/logger.h"

namespace application {

class CallThread final {
public:
    /// Runs `calls`, the first one of the list before the others if several are due. Its priority is that of the
    /// thread that makes it, less `below`, where the process has fixed priorities.
    CallThread(ara::log::Logger& logger, int below, std::vector<std::function<void()>> calls);

    /// Waits for the call that runs. Calls that are due besides do not run.
    ~CallThread();
    CallThread(const CallThread&) = delete;
    CallThread(CallThread&&) = delete;
    CallThread& operator=(const CallThread&) = delete;
    CallThread& operator=(CallThread&&) = delete;

    /// A call is due: the one at this place of the list.
    void Request(std::size_t call);

    /// Waits until no call is due and none runs.
    void AwaitRest();

private:
    void LowerPriority(int below);
    void Run();
    std::size_t FirstDue() const;

    ara::log::Logger& logger_;
    std::vector<std::function<void()>> calls_;
    std::vector<bool> is_due_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool is_running_{false};
    bool is_stopped_{false};
    std::thread thread_;
};

}  // namespace application

#endif  // APPLICATION_CALL_THREAD_H
