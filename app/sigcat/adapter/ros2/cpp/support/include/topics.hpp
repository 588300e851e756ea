// Topics of a node: publishers and subscriptions whose messages and events are counted.

#ifndef PACKAGE_GUARD__TOPICS_HPP_
#define PACKAGE_GUARD__TOPICS_HPP_

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "PACKAGE_NAME/diagnostics.hpp"
#include "diagnostic_msgs/msg/diagnostic_status.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "rmw/types.h"

namespace PACKAGE_NAME
{

/// What has come over a topic, or gone, and what its quality of service has told.
struct TopicCounts
{
  std::string topic;
  bool is_sent = false;
  std::atomic<uint64_t> messages{0};
  std::atomic<uint64_t> lost{0};
  std::atomic<uint64_t> skipped{0};
  std::atomic<uint64_t> deadline_missed{0};
  std::atomic<uint64_t> liveliness_lost{0};
  std::atomic<uint64_t> incompatible_qos{0};

  /// Whether another end of the topic is there that is not connected with this one.
  std::function<bool()> has_stranger = [] {return false;};

  /// For rate and level.
  uint64_t told_messages = 0;
  double rate = 0.0;
  Recent losses;
  Recent promises;

  /// Sequence number of the last message of each publisher.
  std::map<std::array<uint8_t, RMW_GID_STORAGE_SIZE>, uint64_t> sequence_numbers;
};

/// All topics of a node.
class Topics
{
public:
  /// Begins again. There must be no publisher or subscription.
  void clear();

  /// In lock step nothing may be lost: publishers and subscriptions that are made next keep
  /// messages until they are taken, however many a step sends.
  void keep_all(bool is_on);

  /// The quality of service of an end, as declared or, in lock step, with room for all messages.
  rclcpp::QoS quality(rclcpp::QoS declared) const;

  std::shared_ptr<TopicCounts> add(const std::string & topic, bool is_sent);

  /// A message has been taken, and its values are stored. Those of its publisher between it and
  /// the one before were skipped: a queue of the middleware that is full drops without an event.
  void taken(TopicCounts & counts, const rmw_message_info_t & info);

  uint64_t received() const;
  uint64_t sent() const;

  /// Whether as many messages have been taken in all, at the latest after `longest`.
  bool wait_for_received(uint64_t count, std::chrono::seconds longest);

  /// A status of each topic. A warning says that an end of it does not fit, that messages are
  /// lost, or that deadlines are missed, which is as it should be while no call runs.
  void tell(
    const std::string & node, bool has_calls,
    std::vector<diagnostic_msgs::msg::DiagnosticStatus> & statuses);

private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool keeps_all_ = false;
  uint64_t received_ = 0;
  std::vector<std::shared_ptr<TopicCounts>> counts_;
  std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

/// Options that count the events of a subscription: those that its quality of service can have,
/// since an executor asks for each of them whenever it waits.
rclcpp::SubscriptionOptions subscription_options(
  const std::shared_ptr<TopicCounts> & counts, const rclcpp::CallbackGroup::SharedPtr & group,
  const rclcpp::QoS & qos);

/// Options that count the events of a publisher.
rclcpp::PublisherOptions publisher_options(
  const std::shared_ptr<TopicCounts> & counts, const rclcpp::CallbackGroup::SharedPtr & group,
  const rclcpp::QoS & qos);

/// What a topic is called in diagnostics: without the sign for the name of the node.
std::string shown(const rclcpp_lifecycle::LifecycleNode & node, const std::string & topic);

/// A lifecycle publisher whose messages are counted.
template<typename MessageT>
class CountingPublisher
{
public:
  CountingPublisher(
    rclcpp_lifecycle::LifecycleNode & node, Topics & topics, const std::string & topic,
    const rclcpp::QoS & qos, const rclcpp::CallbackGroup::SharedPtr & group)
  : counts_(topics.add(shown(node, topic), true)),
    publisher_(node.create_publisher<MessageT>(
        topic, topics.quality(qos), publisher_options(counts_, group, qos)))
  {
    const auto base = std::weak_ptr<rclcpp::PublisherBase>(publisher_);
    counts_->has_stranger = [&node, base] {
        const auto made = base.lock();
        return made != nullptr &&
               node.count_subscribers(made->get_topic_name()) > made->get_subscription_count();
      };
  }

  void publish(const MessageT & message)
  {
    ++counts_->messages;
    publisher_->publish(message);
  }

private:
  std::shared_ptr<TopicCounts> counts_;
  typename rclcpp_lifecycle::LifecyclePublisher<MessageT>::SharedPtr publisher_;
};

/// A subscription whose messages are counted, after `take` has stored them.
template<typename MessageT, typename TakeT>
typename rclcpp::Subscription<MessageT>::SharedPtr subscribe(
  rclcpp_lifecycle::LifecycleNode & node, Topics & topics, const std::string & topic,
  const rclcpp::QoS & qos, const rclcpp::CallbackGroup::SharedPtr & group, TakeT take)
{
  const auto counts = topics.add(shown(node, topic), false);
  const auto made = node.create_subscription<MessageT>(
    topic, topics.quality(qos),
    [&topics, counts, take](const MessageT & message, const rclcpp::MessageInfo & info) {
      take(message);
      topics.taken(*counts, info.get_rmw_message_info());
    },
    subscription_options(counts, group, qos));
  const auto base = std::weak_ptr<rclcpp::SubscriptionBase>(made);
  counts->has_stranger = [&node, base] {
      const auto one = base.lock();
      return one != nullptr &&
             node.count_publishers(one->get_topic_name()) > one->get_publisher_count();
    };
  return made;
}

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__TOPICS_HPP_
