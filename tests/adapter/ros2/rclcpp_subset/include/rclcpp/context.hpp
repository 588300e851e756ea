#ifndef RCLCPP__CONTEXT_HPP_
#define RCLCPP__CONTEXT_HPP_

#include <functional>
#include <list>
#include <memory>
#include <mutex>

#include "rcl/context.h"
#include "rcl/guard_condition.h"

namespace rclcpp
{

void init(int argc, char const * const * argv);
bool ok();
bool shutdown();
void on_shutdown(std::function<void()> callback);

namespace detail
{

/// What `init` makes, until the last node that uses it is gone.
class Context
{
public:
  using Callbacks = std::list<std::function<void()>>;

  Context(int argc, char const * const * argv);
  ~Context();

  bool shutdown();
  bool is_valid() const {return rcl_context_is_valid(&context_);}
  size_t get_domain_id();
  rcl_context_t * handle() {return &context_;}

  /// Calls it when the context is shut down, until it is removed.
  Callbacks::iterator add(std::function<void()> callback);
  void remove(Callbacks::iterator callback);

private:
  rcl_context_t context_;
  std::recursive_mutex mutex_;
  Callbacks callbacks_;
};

/// The context of the last `init`. Throws where there is none.
std::shared_ptr<Context> context();

class GuardCondition
{
public:
  explicit GuardCondition(std::shared_ptr<Context> context);
  ~GuardCondition();

  void trigger();
  rcl_guard_condition_t * handle() {return &guard_;}

private:
  std::shared_ptr<Context> context_;
  rcl_guard_condition_t guard_;
};

}  // namespace detail
}  // namespace rclcpp

#endif  // RCLCPP__CONTEXT_HPP_
