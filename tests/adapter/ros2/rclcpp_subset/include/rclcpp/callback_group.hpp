#ifndef RCLCPP__CALLBACK_GROUP_HPP_
#define RCLCPP__CALLBACK_GROUP_HPP_

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace rclcpp
{

namespace detail
{

/// What an executor waits for.
class Waitable
{
public:
  enum class Kind {Subscription, Timer, Client, Service, Event};

  virtual ~Waitable() = default;

  virtual Kind kind() const = 0;
  virtual const void * rcl_handle() const = 0;
  /// What is to be executed now. Empty if nothing came.
  virtual std::function<void()> take() = 0;
};

}  // namespace detail

enum class CallbackGroupType
{
  MutuallyExclusive,
  Reentrant,
};

class CallbackGroup
{
public:
  using SharedPtr = std::shared_ptr<CallbackGroup>;
  using WeakPtr = std::weak_ptr<CallbackGroup>;
  using Waitables = std::vector<std::shared_ptr<detail::Waitable>>;

  CallbackGroup(CallbackGroupType type, std::function<void()> changed)
  : type_(type), changed_(std::move(changed)) {}

  void add(const std::shared_ptr<detail::Waitable> & waitable);
  Waitables waitables();

  /// Who is told when there is more to wait for, beside the executor of the node. False if another one has the group.
  bool set_listener(std::function<void()> listener);
  void clear_listener();

  /// Whether a callback may begin; it has begun, then.
  bool begin();
  void end();
  bool is_busy() const {return busy_;}

private:
  const CallbackGroupType type_;
  const std::function<void()> changed_;
  std::mutex mutex_;
  std::function<void()> listener_;
  std::vector<std::weak_ptr<detail::Waitable>> waitables_;
  std::atomic_bool busy_{false};
};

}  // namespace rclcpp

#endif  // RCLCPP__CALLBACK_GROUP_HPP_
