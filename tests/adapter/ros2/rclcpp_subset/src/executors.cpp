#include "rclcpp/executors.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "rcl/error_handling.h"
#include "rclcpp/exceptions.hpp"

namespace rclcpp
{

using detail::Waitable;
using detail::check;

Executor::Executor(const ExecutorOptions &)
: context_(detail::context()), interrupt_(std::make_shared<detail::GuardCondition>(context_)),
  on_shutdown_(context_->add([this] {interrupt_->trigger();})),
  wait_set_(rcl_get_zero_initialized_wait_set())
{
  check(
    rcl_wait_set_init(
      &wait_set_, 0, 1, 0, 0, 0, 0, context_->handle(), rcl_get_default_allocator()), "wait set");
}

Executor::~Executor()
{
  context_->remove(on_shutdown_);
  for (const auto & node : nodes_) {
    node->clear_listener();
  }
  for (const auto & group : groups_) {
    group->clear_listener();
  }
  if (rcl_wait_set_fini(&wait_set_) != RCL_RET_OK) {
    rcl_reset_error();
  }
}

void Executor::cancel()
{
  spins_ = false;
  interrupt_->trigger();
}

void Executor::add_node(node_interfaces::NodeBaseInterface::SharedPtr node)
{
  if (!node->set_listener([this] {interrupt_->trigger();})) {
    throw std::runtime_error("Node has already been added to an executor.");
  }
  const std::lock_guard<std::mutex> lock(nodes_mutex_);
  nodes_.push_back(std::move(node));
  interrupt_->trigger();
}

void Executor::remove_node(node_interfaces::NodeBaseInterface::SharedPtr node)
{
  const std::lock_guard<std::mutex> lock(nodes_mutex_);
  const auto found = std::find(nodes_.begin(), nodes_.end(), node);
  if (found == nodes_.end()) {
    throw std::runtime_error("Node needs to be associated with this executor.");
  }
  node->clear_listener();
  nodes_.erase(found);
  interrupt_->trigger();
}

void Executor::add_callback_group(
  CallbackGroup::SharedPtr group, node_interfaces::NodeBaseInterface::SharedPtr)
{
  if (!group->set_listener([this] {interrupt_->trigger();})) {
    throw std::runtime_error("Callback group has already been added to an executor.");
  }
  const std::lock_guard<std::mutex> lock(nodes_mutex_);
  groups_.push_back(std::move(group));
  interrupt_->trigger();
}

Executor::Spinning::Spinning(Executor & executor)
: executor_(executor)
{
  if (executor_.spins_.exchange(true)) {
    throw std::runtime_error("spin() called while already spinning");
  }
}

void Executor::work()
{
  while (goes_on()) {
    work_once();
  }
}

void Executor::work_once()
{
  std::optional<Task> task = next();
  if (task) {
    const std::shared_ptr<void> after(
      nullptr, [this, group = task->from.group](void *) {
        group->end();
        if (waits_) {
          interrupt_->trigger();  // the group is free
        }
      });
    task->run();
    task.reset();
  }
}

bool Executor::goes_on() const
{
  return spins_ && context_->is_valid();
}

std::optional<Executor::Task> Executor::next()
{
  const std::lock_guard<std::mutex> lock(wait_mutex_);
  std::optional<Task> task = next_of_ready();
  if (!task && goes_on()) {
    wait();
    task = next_of_ready();
  }
  return task;
}

std::optional<Executor::Task> Executor::next_of_ready()
{
  while (!ready_.empty()) {
    Ready ready = std::move(ready_.front());
    ready_.pop_front();
    if (!ready.group->begin()) {
      continue;  // it is ready still when its group is free
    }
    if (std::function<void()> run = ready.waitable->take()) {
      return Task{std::move(ready), std::move(run)};
    }
    ready.group->end();
  }
  return std::nullopt;
}

/// What may be executed: everything of groups that are not busy.
std::vector<Executor::Ready> Executor::all()
{
  const std::lock_guard<std::mutex> lock(nodes_mutex_);
  std::vector<CallbackGroup::SharedPtr> groups = groups_;
  for (const auto & node : nodes_) {
    const auto of_node = node->callback_groups();
    groups.insert(groups.end(), of_node.begin(), of_node.end());
  }
  std::vector<Ready> found;
  for (const auto & group : groups) {
    if (!group->is_busy()) {
      for (auto & waitable : group->waitables()) {
        found.push_back({group, std::move(waitable)});
      }
    }
  }
  return found;
}

static rcl_ret_t add(rcl_wait_set_t & set, const Waitable & waitable, size_t & place)
{
  const void * handle = waitable.rcl_handle();
  switch (waitable.kind()) {
    case Waitable::Kind::Subscription:
      return rcl_wait_set_add_subscription(
        &set, static_cast<const rcl_subscription_t *>(handle), &place);
    case Waitable::Kind::Timer:
      return rcl_wait_set_add_timer(&set, static_cast<const rcl_timer_t *>(handle), &place);
    case Waitable::Kind::Client:
      return rcl_wait_set_add_client(&set, static_cast<const rcl_client_t *>(handle), &place);
    case Waitable::Kind::Service:
      return rcl_wait_set_add_service(&set, static_cast<const rcl_service_t *>(handle), &place);
    case Waitable::Kind::Event:
      return rcl_wait_set_add_event(&set, static_cast<const rcl_event_t *>(handle), &place);
  }
  return RCL_RET_INVALID_ARGUMENT;
}

static bool is_ready(const rcl_wait_set_t & set, Waitable::Kind kind, size_t place)
{
  switch (kind) {
    case Waitable::Kind::Subscription: return set.subscriptions[place] != nullptr;
    case Waitable::Kind::Timer: return set.timers[place] != nullptr;
    case Waitable::Kind::Client: return set.clients[place] != nullptr;
    case Waitable::Kind::Service: return set.services[place] != nullptr;
    case Waitable::Kind::Event: return set.events[place] != nullptr;
  }
  return false;
}

void Executor::fill(std::vector<Ready> & waited, std::vector<size_t> & places)
{
  std::array<size_t, 5> counts{};
  for (const Ready & each : waited) {
    ++counts[static_cast<size_t>(each.waitable->kind())];
  }
  check(
    rcl_wait_set_resize(&wait_set_, counts[0], 1, counts[1], counts[2], counts[3], counts[4]),
    "wait set");
  check(rcl_wait_set_clear(&wait_set_), "wait set");
  check(rcl_wait_set_add_guard_condition(&wait_set_, interrupt_->handle(), nullptr), "wait set");
  for (size_t at = 0; at < waited.size(); ++at) {
    check(add(wait_set_, *waited[at].waitable, places[at]), "wait set");
  }
}

void Executor::wait()
{
  waits_ = true;
  std::vector<Ready> waited = all();
  std::vector<size_t> places(waited.size());
  fill(waited, places);
  const rcl_ret_t result = rcl_wait(&wait_set_, -1);
  waits_ = false;
  if (result == RCL_RET_TIMEOUT) {
    rcl_reset_error();
    return;
  }
  check(result, "wait");
  for (size_t at = 0; at < waited.size(); ++at) {
    if (is_ready(wait_set_, waited[at].waitable->kind(), places[at])) {
      ready_.push_back(std::move(waited[at]));
    }
  }
}

namespace executors
{

void SingleThreadedExecutor::spin()
{
  const Spinning spinning(*this);
  work();
}

MultiThreadedExecutor::MultiThreadedExecutor(
  const ExecutorOptions & options, size_t number_of_threads)
: Executor(options),
  threads_(number_of_threads > 0 ? number_of_threads :
    std::max<size_t>(std::thread::hardware_concurrency(), 2))
{
}

void MultiThreadedExecutor::spin()
{
  const Spinning spinning(*this);
  std::vector<std::thread> others;
  for (size_t at = 1; at < threads_; ++at) {
    others.emplace_back([this] {work();});
  }
  work();
  for (std::thread & other : others) {
    other.join();
  }
}

}  // namespace executors

void spin(node_interfaces::NodeBaseInterface::SharedPtr node)
{
  executors::SingleThreadedExecutor executor;
  executor.add_node(std::move(node));
  executor.spin();
}

}  // namespace rclcpp
