#ifndef RCLCPP__EXECUTORS_HPP_
#define RCLCPP__EXECUTORS_HPP_

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "rcl/wait.h"
#include "rclcpp/node_base.hpp"

namespace rclcpp
{

struct ExecutorOptions
{
};

enum class FutureReturnCode
{
  SUCCESS,
  INTERRUPTED,
  TIMEOUT,
};

class Executor
{
public:
  explicit Executor(const ExecutorOptions & options = {});
  virtual ~Executor();

  virtual void spin() = 0;
  void cancel();
  bool is_spinning() const {return spins_;}

  void add_node(node_interfaces::NodeBaseInterface::SharedPtr node);
  void remove_node(node_interfaces::NodeBaseInterface::SharedPtr node);
  template<typename NodeT>
  void add_node(const std::shared_ptr<NodeT> & node) {add_node(node->get_node_base_interface());}
  template<typename NodeT>
  void remove_node(const std::shared_ptr<NodeT> & node)
  {
    remove_node(node->get_node_base_interface());
  }
  void add_callback_group(
    CallbackGroup::SharedPtr group, node_interfaces::NodeBaseInterface::SharedPtr node);

  /// Until the future is ready, the context is shut down or the executor is cancelled. Whether it is ready is asked before
  /// each wait, which cancel() ends.
  template<typename FutureT>
  FutureReturnCode spin_until_future_complete(const FutureT & future)
  {
    const auto is_ready = [&future] {
        return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
      };
    if (is_ready()) {
      return FutureReturnCode::SUCCESS;
    }
    {
      const Spinning spinning(*this);
      while (goes_on() && !is_ready()) {
        work_once();
      }
    }
    return is_ready() ? FutureReturnCode::SUCCESS : FutureReturnCode::INTERRUPTED;
  }

protected:
  /// Executes what is ready until it is cancelled or the context is shut down.
  void work();
  void work_once();
  bool goes_on() const;
  /// Meanwhile it spins, and not any more after an exception of a callback either.
  class Spinning
  {
  public:
    explicit Spinning(Executor & executor);
    ~Spinning() {executor_.spins_ = false;}
    Spinning(const Spinning &) = delete;
    Spinning & operator=(const Spinning &) = delete;

  private:
    Executor & executor_;
  };

private:
  struct Ready
  {
    CallbackGroup::SharedPtr group;
    std::shared_ptr<detail::Waitable> waitable;
  };
  struct Task
  {
    Ready from;
    std::function<void()> run;
  };

  std::optional<Task> next();
  std::optional<Task> next_of_ready();
  void wait();
  std::vector<Ready> all();
  void fill(std::vector<Ready> & waited, std::vector<size_t> & places);

  std::shared_ptr<detail::Context> context_;
  std::shared_ptr<detail::GuardCondition> interrupt_;
  detail::Context::Callbacks::iterator on_shutdown_;
  std::atomic_bool spins_{false};
  std::atomic_bool waits_{false};
  std::mutex nodes_mutex_;
  std::vector<node_interfaces::NodeBaseInterface::SharedPtr> nodes_;
  std::vector<CallbackGroup::SharedPtr> groups_;
  std::mutex wait_mutex_;
  rcl_wait_set_t wait_set_;
  std::deque<Ready> ready_;
};

namespace executors
{

class SingleThreadedExecutor : public Executor
{
public:
  using Executor::Executor;

  void spin() override;
};

class MultiThreadedExecutor : public Executor
{
public:
  explicit MultiThreadedExecutor(const ExecutorOptions & options = {}, size_t number_of_threads = 0);

  void spin() override;
  size_t get_number_of_threads() const {return threads_;}

private:
  size_t threads_;
};

}  // namespace executors

void spin(node_interfaces::NodeBaseInterface::SharedPtr node);
template<typename NodeT>
void spin(const std::shared_ptr<NodeT> & node) {spin(node->get_node_base_interface());}

}  // namespace rclcpp

#endif  // RCLCPP__EXECUTORS_HPP_
