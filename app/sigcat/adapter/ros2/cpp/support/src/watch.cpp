#include "PACKAGE_NAME/watch.hpp"

#include <chrono>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace PACKAGE_NAME
{

Watch::Watch(std::function<void()> supervise)
: supervise_(std::move(supervise)), thread_([this] {run();})
{
}

Watch::~Watch()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_stopped_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Watch::begin(std::chrono::nanoseconds longest)
{
  const Time now = std::chrono::steady_clock::now();
  bool is_sooner = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    interval_ = now - began_;
    began_ = now;
    longest_ = longest + std::chrono::milliseconds(1);
    late_ = now + longest_;
    is_running_ = true;
    is_sooner = late_ < look_;
  }
  if (is_sooner) {
    changed_.notify_all();
  }
}

void Watch::end()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  is_running_ = false;
}

void Watch::run()
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (!is_stopped_) {
    const Time now = std::chrono::steady_clock::now();
    if (is_running_ && now >= late_) {
      late_ = now + longest_;
      lock.unlock();
      supervise_();
      lock.lock();
    } else {
      look_ = next_look(now);
      changed_.wait_until(lock, look_);
    }
  }
}

/// When a call that runs is late; otherwise in the middle of the time of the next one, if it
/// comes after this one as this one came after the one before.
Watch::Time Watch::next_look(Time now) const
{
  const Time next = is_running_ ? late_ : began_ + interval_ + longest_ / 2;
  return next > now ? next : now + std::chrono::hours(1);
}

}  // namespace PACKAGE_NAME
