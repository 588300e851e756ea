#include "PACKAGE_NAME/topics.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <iterator>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "PACKAGE_NAME/diagnostics.hpp"
#include "rmw/features.h"
#include "rmw/time.h"

namespace PACKAGE_NAME
{

using diagnostic_msgs::msg::DiagnosticStatus;

namespace
{

constexpr std::size_t kAllOfAStep = 1000;

}  // namespace

void Topics::clear()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.clear();
  received_ = 0;
  told_ = std::chrono::steady_clock::now();
}

void Topics::keep_all(bool is_on)
{
  keeps_all_ = is_on;
}

rclcpp::QoS Topics::quality(rclcpp::QoS declared) const
{
  return keeps_all_ ? declared.keep_last(kAllOfAStep) : declared;
}

std::shared_ptr<TopicCounts> Topics::add(const std::string & topic, bool is_sent)
{
  const auto counts = std::make_shared<TopicCounts>();
  counts->topic = topic;
  counts->is_sent = is_sent;
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.push_back(counts);
  return counts;
}

namespace
{

/// How many messages of its publisher were not taken before this one.
uint64_t skipped_before(TopicCounts & counts, const rmw_message_info_t & info)
{
  const uint64_t number = info.publication_sequence_number;
  if (info.from_intra_process || number == RMW_MESSAGE_INFO_SEQUENCE_NUMBER_UNSUPPORTED) {
    return 0U;
  }
  std::array<uint8_t, RMW_GID_STORAGE_SIZE> publisher{};
  std::copy_n(std::begin(info.publisher_gid.data), publisher.size(), publisher.begin());
  const auto known = counts.sequence_numbers.try_emplace(publisher, number);
  const uint64_t last = known.first->second;
  known.first->second = number;
  return number > last ? number - last - 1U : 0U;
}

}  // namespace

void Topics::taken(TopicCounts & counts, const rmw_message_info_t & info)
{
  ++counts.messages;
  counts.skipped += skipped_before(counts, info);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++received_;
  }
  changed_.notify_all();
}

uint64_t Topics::received() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return received_;
}

uint64_t Topics::sent() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  uint64_t sum = 0;
  for (const auto & counts : counts_) {
    sum += counts->is_sent ? counts->messages.load() : 0U;
  }
  return sum;
}

bool Topics::wait_for_received(uint64_t count, std::chrono::seconds longest)
{
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, longest, [this, count] {return received_ >= count;});
}

namespace
{

/// What is wrong at present; nothing if all is well.
std::string problem(TopicCounts & counts, bool has_calls)
{
  std::string text;
  if (counts.incompatible_qos > 0U && counts.has_stranger()) {
    text += "An end of the topic has a quality of service that does not fit. ";
  }
  if (counts.losses.grows(counts.lost + counts.skipped)) {
    text += "Messages are lost. ";
  }
  const uint64_t missed = counts.deadline_missed + counts.liveliness_lost;
  if (!has_calls) {
    counts.promises.forget(missed);
  } else if (counts.promises.grows(missed)) {
    text += "Messages are late. ";
  }
  return text.substr(0, text.find_last_not_of(' ') + 1U);
}

}  // namespace

void Topics::tell(
  const std::string & node, bool has_calls, std::vector<DiagnosticStatus> & statuses)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> elapsed = now - told_;
  const bool has_rate = elapsed.count() >= 0.5;  // less says nothing
  for (const auto & counts : counts_) {
    if (has_rate) {
      const uint64_t messages = counts->messages;
      counts->rate = static_cast<double>(messages - counts->told_messages) / elapsed.count();
      counts->told_messages = messages;
    }
    const std::string message = problem(*counts, has_calls);
    DiagnosticStatus status = made_status(
      message.empty() ? DiagnosticStatus::OK : DiagnosticStatus::WARN, node,
      (counts->is_sent ? "publisher " : "subscription ") + counts->topic, message);
    add_value(status, "messages", counts->messages.load());
    add_value(status, "rate [Hz]", counts->rate);
    add_value(status, "lost", counts->lost.load());
    add_value(status, "skipped", counts->skipped.load());
    add_value(status, "deadline missed", counts->deadline_missed.load());
    add_value(status, "liveliness lost", counts->liveliness_lost.load());
    add_value(status, "incompatible QoS", counts->incompatible_qos.load());
    statuses.push_back(status);
  }
  told_ = has_rate ? now : told_;
}

namespace
{

/// Whether a time is given, and ends.
bool is_limited(const rmw_time_t & time)
{
  const rmw_time_t endless = RMW_DURATION_INFINITE;
  const bool is_given = time.sec != 0U || time.nsec != 0U;
  return is_given && (time.sec != endless.sec || time.nsec != endless.nsec);
}

}  // namespace

std::string shown(const rclcpp_lifecycle::LifecycleNode & node, const std::string & topic)
{
  return topic.rfind("~/", 0) == 0 ? node.get_name() + topic.substr(1) : topic;
}

rclcpp::SubscriptionOptions subscription_options(
  const std::shared_ptr<TopicCounts> & counts, const rclcpp::CallbackGroup::SharedPtr & group,
  const rclcpp::QoS & qos)
{
  rclcpp::SubscriptionOptions options;
  options.callback_group = group;
  if (is_limited(qos.get_rmw_qos_profile().deadline)) {
    options.event_callbacks.deadline_callback = [counts](rclcpp::QOSDeadlineRequestedInfo & event) {
        counts->deadline_missed += static_cast<uint64_t>(event.total_count_change);
      };
  }
  if (is_limited(qos.get_rmw_qos_profile().liveliness_lease_duration)) {
    options.event_callbacks.liveliness_callback =
      [counts](rclcpp::QOSLivelinessChangedInfo & event) {
        if (event.not_alive_count_change > 0) {
          counts->liveliness_lost += static_cast<uint64_t>(event.not_alive_count_change);
        }
      };
  }
  options.event_callbacks.incompatible_qos_callback =
    [counts](rclcpp::QOSRequestedIncompatibleQoSInfo & event) {
      counts->incompatible_qos += static_cast<uint64_t>(event.total_count_change);
    };
  // Where messages are numbered, those that are lost are among the skipped ones.
  if (!rmw_feature_supported(RMW_FEATURE_MESSAGE_INFO_PUBLICATION_SEQUENCE_NUMBER)) {
    options.event_callbacks.message_lost_callback = [counts](rclcpp::QOSMessageLostInfo & event) {
        counts->lost += event.total_count_change;
      };
  }
  return options;
}

rclcpp::PublisherOptions publisher_options(
  const std::shared_ptr<TopicCounts> & counts, const rclcpp::CallbackGroup::SharedPtr & group,
  const rclcpp::QoS & qos)
{
  rclcpp::PublisherOptions options;
  options.callback_group = group;
  if (is_limited(qos.get_rmw_qos_profile().deadline)) {
    options.event_callbacks.deadline_callback = [counts](rclcpp::QOSDeadlineOfferedInfo & event) {
        counts->deadline_missed += static_cast<uint64_t>(event.total_count_change);
      };
  }
  if (is_limited(qos.get_rmw_qos_profile().liveliness_lease_duration)) {
    options.event_callbacks.liveliness_callback = [counts](rclcpp::QOSLivelinessLostInfo & event) {
        counts->liveliness_lost += static_cast<uint64_t>(event.total_count_change);
      };
  }
  options.event_callbacks.incompatible_qos_callback =
    [counts](rclcpp::QOSOfferedIncompatibleQoSInfo & event) {
      counts->incompatible_qos += static_cast<uint64_t>(event.total_count_change);
    };
  return options;
}

}  // namespace PACKAGE_NAME
