// The thread that runs what applications register: handlers and methods. One at a time, so that what receives never waits.
#ifndef BENCH_SERVICES_DISPATCHER_H_
#define BENCH_SERVICES_DISPATCHER_H_

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace bench {

class Dispatcher {
public:
    void Start();
    // What was not run yet is not run any more.
    void Stop();

    void Post(const void* owner, std::function<void()> call);

    // Nothing of the owner runs when this has returned, unless it is called by what runs.
    void Retire(const void* owner);

    // How many wait or run.
    std::size_t Running();

private:
    struct Task {
        const void* owner;
        std::function<void()> call;
    };

    void Run();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Task> tasks_;
    const void* running_ = nullptr;
    bool stops_ = true;
    std::thread::id own_;
    std::thread thread_;
};

}  // namespace bench

#endif  // BENCH_SERVICES_DISPATCHER_H_
