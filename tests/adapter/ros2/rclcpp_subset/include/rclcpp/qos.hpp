#ifndef RCLCPP__QOS_HPP_
#define RCLCPP__QOS_HPP_

#include <cstddef>

#include "rclcpp/time.hpp"
#include "rmw/incompatible_qos_events_statuses.h"
#include "rmw/qos_profiles.h"
#include "rmw/types.h"

namespace rclcpp
{

enum class LivelinessPolicy
{
  Automatic = RMW_QOS_POLICY_LIVELINESS_AUTOMATIC,
  ManualByTopic = RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC,
};

struct KeepLast
{
  explicit KeepLast(size_t count)
  : depth(count) {}

  size_t depth;
};

class QoS
{
public:
  explicit QoS(KeepLast history, const rmw_qos_profile_t & profile = rmw_qos_profile_default);
  QoS(size_t depth)  // NOLINT: rclcpp converts, too
  : QoS(KeepLast(depth)) {}

  QoS & keep_last(size_t depth);
  QoS & reliable();
  QoS & best_effort();
  QoS & transient_local();
  QoS & durability_volatile();
  QoS & deadline(const Duration & deadline);
  QoS & lifespan(const Duration & lifespan);
  QoS & liveliness(LivelinessPolicy policy);
  QoS & liveliness_lease_duration(const Duration & lease);

  const rmw_qos_profile_t & get_rmw_qos_profile() const {return profile_;}

private:
  rmw_qos_profile_t profile_;
};

class ServicesQoS : public QoS
{
public:
  ServicesQoS()
  : QoS(KeepLast(rmw_qos_profile_services_default.depth), rmw_qos_profile_services_default) {}
};

}  // namespace rclcpp

#endif  // RCLCPP__QOS_HPP_
