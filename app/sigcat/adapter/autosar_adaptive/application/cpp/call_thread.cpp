#include "application/call_thread.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <utility>

namespace application {

CallThread::CallThread(ara::log::Logger& logger, int below, std::vector<std::function<void()>> calls)
    : logger_(logger), calls_{std::move(calls)}, is_due_(calls_.size()), thread_{[this, below] {
          LowerPriority(below);
          Run();
      }} {}

CallThread::~CallThread() {
    {
        const std::lock_guard<std::mutex> lock{mutex_};
        is_stopped_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void CallThread::Request(std::size_t call) {
    {
        const std::lock_guard<std::mutex> lock{mutex_};
        is_due_[call] = true;
    }
    changed_.notify_all();
}

void CallThread::AwaitRest() {
    std::unique_lock<std::mutex> lock{mutex_};
    changed_.wait(lock, [this] { return !is_running_ && FirstDue() == calls_.size(); });
}

void CallThread::LowerPriority(int below) {
    int policy = SCHED_OTHER;
    sched_param parameters{};
    const bool is_known = pthread_getschedparam(pthread_self(), &policy, &parameters) == 0;
    if (below == 0 || (is_known && policy != SCHED_FIFO && policy != SCHED_RR)) {
        return;
    }
    parameters.sched_priority = std::max(parameters.sched_priority - below, sched_get_priority_min(policy));
    if (!is_known || pthread_setschedparam(pthread_self(), policy, &parameters) != 0) {
        logger_.LogError() << "The priority of a thread cannot be set";
    }
}

void CallThread::Run() {
    std::unique_lock<std::mutex> lock{mutex_};
    for (;;) {
        changed_.wait(lock, [this] { return is_stopped_ || FirstDue() != calls_.size(); });
        if (is_stopped_) {
            return;
        }
        const std::size_t call = FirstDue();
        is_due_[call] = false;
        is_running_ = true;
        lock.unlock();
        calls_[call]();
        lock.lock();
        is_running_ = false;
        changed_.notify_all();
    }
}

std::size_t CallThread::FirstDue() const {
    return static_cast<std::size_t>(std::find(is_due_.begin(), is_due_.end(), true) - is_due_.begin());
}

}  // namespace application
