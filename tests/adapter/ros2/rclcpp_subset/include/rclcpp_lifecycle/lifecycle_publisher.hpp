#ifndef RCLCPP_LIFECYCLE__LIFECYCLE_PUBLISHER_HPP_
#define RCLCPP_LIFECYCLE__LIFECYCLE_PUBLISHER_HPP_

#include <atomic>
#include <memory>
#include <string>

#include "rclcpp/logging.hpp"
#include "rclcpp/publisher.hpp"

namespace rclcpp_lifecycle
{

/// What is active while its node is.
class ManagedEntityInterface
{
public:
  virtual ~ManagedEntityInterface() = default;

  virtual void on_activate() = 0;
  virtual void on_deactivate() = 0;
};

/// A publisher that publishes while its node is active; of what it does not publish, it tells once.
template<typename MessageT>
class LifecyclePublisher : public ManagedEntityInterface, public rclcpp::Publisher<MessageT>
{
public:
  using SharedPtr = std::shared_ptr<LifecyclePublisher>;

  using rclcpp::Publisher<MessageT>::Publisher;

  void publish(const MessageT & message) override
  {
    if (is_active_) {
      rclcpp::Publisher<MessageT>::publish(message);
    } else if (!is_told_.exchange(true)) {
      RCLCPP_WARN(
        rclcpp::get_logger("LifecyclePublisher"),
        "Trying to publish message on the topic '%s', but the publisher is not activated",
        this->get_topic_name());
    }
  }

  void on_activate() override {is_active_ = true;}
  void on_deactivate() override
  {
    is_active_ = false;
    is_told_ = false;
  }
  bool is_activated() const {return is_active_;}

private:
  std::atomic_bool is_active_{false};
  std::atomic_bool is_told_{false};
};

}  // namespace rclcpp_lifecycle

#endif  // RCLCPP_LIFECYCLE__LIFECYCLE_PUBLISHER_HPP_
