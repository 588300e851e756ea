#include "rclcpp/context.hpp"

#include <semaphore.h>

#include <atomic>
#include <csignal>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "rcl/error_handling.h"
#include "rcl/init.h"
#include "rcl/logging.h"
#include "rclcpp/exceptions.hpp"

namespace rclcpp
{

namespace
{

std::mutex global_mutex;
std::shared_ptr<detail::Context> global_context;
std::recursive_mutex logging_mutex;
sem_t signalled;

void log(
  const rcutils_log_location_t * location, int severity, const char * name,
  rcutils_time_point_value_t timestamp, const char * format, va_list * arguments)
{
  const std::lock_guard<std::recursive_mutex> lock(logging_mutex);
  rcl_logging_multiple_output_handler(location, severity, name, timestamp, format, arguments);
}

void note_signal(int)
{
  sem_post(&signalled);
}

void handle_signals(void (* handler)(int))
{
  struct sigaction action{};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

/// Shuts down when a signal was noted. It holds the context meanwhile: it ends before what is static here is destroyed.
class SignalThread
{
public:
  SignalThread()
  {
    sem_init(&signalled, 0, 0);
    thread_ = std::thread([this] {wait();});
  }

  ~SignalThread()
  {
    handle_signals(SIG_DFL);
    ends_ = true;
    sem_post(&signalled);
    thread_.join();
  }

private:
  void wait()
  {
    while (!ends_) {
      if (sem_wait(&signalled) == 0 && !ends_) {
        shutdown();
      }
    }
  }

  std::atomic<bool> ends_{false};
  std::thread thread_;
};

void shut_down_on_signals()
{
  static const SignalThread thread;
  handle_signals(note_signal);
}

}  // namespace

namespace detail
{

void check(rcl_ret_t result, const char * what)
{
  if (result != RCL_RET_OK) {
    const std::string text = std::string(what) + ": " + rcl_get_error_string().str;
    rcl_reset_error();
    throw exceptions::RCLError(text);
  }
}

Context::Context(int argc, char const * const * argv)
: context_(rcl_get_zero_initialized_context())
{
  const rcl_allocator_t allocator = rcl_get_default_allocator();
  rcl_init_options_t options = rcl_get_zero_initialized_init_options();
  check(rcl_init_options_init(&options, allocator), "options of rcl");
  const rcl_ret_t made = rcl_init(argc, argv, &options, &context_);
  check(rcl_init_options_fini(&options), "options of rcl");
  check(made, "rcl");
  const std::lock_guard<std::recursive_mutex> lock(logging_mutex);
  check(
    rcl_logging_configure_with_output_handler(&context_.global_arguments, &allocator, log),
    "logging of rcl");
}

Context::~Context()
{
  shutdown();
  if (rcl_context_fini(&context_) != RCL_RET_OK) {
    rcl_reset_error();
  }
}

size_t Context::get_domain_id()
{
  size_t number = 0;
  check(rcl_context_get_domain_id(&context_, &number), "domain");
  return number;
}

bool Context::shutdown()
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (!is_valid()) {
    return false;
  }
  check(rcl_shutdown(&context_), "shutting down");
  for (const std::function<void()> & callback : callbacks_) {
    callback();
  }
  return true;
}

Context::Callbacks::iterator Context::add(std::function<void()> callback)
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return callbacks_.insert(callbacks_.end(), std::move(callback));
}

void Context::remove(Callbacks::iterator callback)
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  callbacks_.erase(callback);
}

std::shared_ptr<Context> context()
{
  const std::lock_guard<std::mutex> lock(global_mutex);
  if (!global_context) {
    throw exceptions::RCLError("rclcpp::init was not called");
  }
  return global_context;
}

GuardCondition::GuardCondition(std::shared_ptr<Context> context)
: context_(std::move(context)), guard_(rcl_get_zero_initialized_guard_condition())
{
  check(
    rcl_guard_condition_init(
      &guard_, context_->handle(), rcl_guard_condition_get_default_options()), "guard condition");
}

GuardCondition::~GuardCondition()
{
  if (rcl_guard_condition_fini(&guard_) != RCL_RET_OK) {
    rcl_reset_error();
  }
}

void GuardCondition::trigger()
{
  check(rcl_trigger_guard_condition(&guard_), "guard condition");
}

}  // namespace detail

void init(int argc, char const * const * argv)
{
  auto made = std::make_shared<detail::Context>(argc, argv);
  const std::lock_guard<std::mutex> lock(global_mutex);
  global_context = std::move(made);
  shut_down_on_signals();
}

bool ok()
{
  const std::lock_guard<std::mutex> lock(global_mutex);
  return global_context && global_context->is_valid();
}

bool shutdown()
{
  std::shared_ptr<detail::Context> shut;
  {
    const std::lock_guard<std::mutex> lock(global_mutex);
    shut = global_context;
  }
  return shut && shut->shutdown();
}

void on_shutdown(std::function<void()> callback)
{
  detail::context()->add(std::move(callback));
}

}  // namespace rclcpp
