// The time of a node's calls, in nanoseconds.

#ifndef PACKAGE_GUARD__CLOCK_HPP_
#define PACKAGE_GUARD__CLOCK_HPP_

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>

#include "builtin_interfaces/msg/time.hpp"
#include "rclcpp/rclcpp.hpp"

namespace PACKAGE_NAME
{

class Clock
{
public:
  Clock() = default;
  virtual ~Clock() = default;
  Clock(const Clock &) = delete;
  Clock & operator=(const Clock &) = delete;

  virtual uint64_t now() const = 0;

  /// The present time as messages have it.
  virtual builtin_interfaces::msg::Time stamp() const = 0;

  /// Whether the time of messages has gone back since this was asked last. That of the calls has
  /// not: it continues from where it was.
  virtual bool has_gone_back() {return false;}

  /// Waits until it is `time`, which does not drift, or until wake(). False after stop().
  bool wait_until(uint64_t time);

  /// Ends the wait that is, or else the next one. From any thread.
  void wake();

  /// Ends all waiting until resume(). From any thread.
  void stop();
  void resume();
  bool is_stopped() const;

protected:
  virtual void wait(std::unique_lock<std::mutex> & lock, uint64_t time) = 0;
  bool is_interrupted() const {return is_woken_ || is_stopped_;}

  mutable std::mutex mutex_;
  std::condition_variable changed_;

private:
  bool is_woken_ = false;
  bool is_stopped_ = false;
};

/// A clock that no one sets. Messages have the time of the node's clock.
class SteadyClock final : public Clock
{
public:
  explicit SteadyClock(rclcpp::Clock::SharedPtr node_clock);
  uint64_t now() const override;
  builtin_interfaces::msg::Time stamp() const override;

private:
  void wait(std::unique_lock<std::mutex> & lock, uint64_t time) override;

  rclcpp::Clock::SharedPtr node_clock_;
};

/// Simulated time, from /clock: it stands still, runs as fast as it likes, goes back, and is 0 at
/// first.
class SimulatedClock final : public Clock
{
public:
  explicit SimulatedClock(rclcpp::Clock::SharedPtr node_clock);
  uint64_t now() const override;
  builtin_interfaces::msg::Time stamp() const override;
  bool has_gone_back() override {return is_back_.exchange(false);}

private:
  void wait(std::unique_lock<std::mutex> & lock, uint64_t time) override;

  std::atomic<int64_t> gone_back_{0};  // in all
  std::atomic<bool> is_back_{false};
  rclcpp::Clock::SharedPtr node_clock_;
  rclcpp::JumpHandler::SharedPtr jumps_;
};

/// Time that is given from outside, step by step. It is 0 at first.
class StepClock final : public Clock
{
public:
  uint64_t now() const override;
  builtin_interfaces::msg::Time stamp() const override;
  void set(uint64_t time);

private:
  void wait(std::unique_lock<std::mutex> & lock, uint64_t time) override;

  uint64_t time_ = 0;
};

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__CLOCK_HPP_
