#include "services/dispatcher.h"

#include <algorithm>
#include <utility>

namespace bench {

void Dispatcher::Start() {
    stops_ = false;
    thread_ = std::thread{[this] { Run(); }};
}

void Dispatcher::Stop() {
    {
        std::lock_guard<std::mutex> lock{mutex_};
        stops_ = true;
        tasks_.clear();
    }
    changed_.notify_all();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void Dispatcher::Post(const void* owner, std::function<void()> call) {
    {
        std::lock_guard<std::mutex> lock{mutex_};
        if (stops_) {
            return;
        }
        tasks_.push_back({owner, std::move(call)});
    }
    changed_.notify_all();
}

void Dispatcher::Retire(const void* owner) {
    std::deque<Task> dropped;  // destroyed without the lock: what a task holds may end here
    std::unique_lock<std::mutex> lock{mutex_};
    for (auto& task : tasks_) {
        if (task.owner == owner) {
            dropped.push_back(std::move(task));
        }
    }
    tasks_.erase(std::remove_if(tasks_.begin(), tasks_.end(), [owner](const Task& task) { return task.owner == owner; }),
                 tasks_.end());
    if (std::this_thread::get_id() != own_) {
        changed_.wait(lock, [this, owner] { return running_ != owner; });
    }
}

std::size_t Dispatcher::Running() {
    std::lock_guard<std::mutex> lock{mutex_};
    return tasks_.size() + (running_ != nullptr ? 1U : 0U);
}

void Dispatcher::Run() {
    std::unique_lock<std::mutex> lock{mutex_};
    own_ = std::this_thread::get_id();
    while (true) {
        changed_.wait(lock, [this] { return stops_ || !tasks_.empty(); });
        if (stops_) {
            return;
        }
        Task task = std::move(tasks_.front());
        tasks_.pop_front();
        running_ = task.owner;
        lock.unlock();
        task.call();
        task.call = nullptr;
        lock.lock();
        running_ = nullptr;
        changed_.notify_all();
    }
}

}  // namespace bench
