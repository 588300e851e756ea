#include "PACKAGE_NAME/scheduling.hpp"

#include <pthread.h>
#include <sched.h>

#include <cstring>
#include <string>
#include <thread>

#include "rclcpp/exceptions.hpp"

namespace PACKAGE_NAME
{

void check_policy(const std::string & policy)
{
  if (policy != "other" && policy != "fifo" && policy != "rr") {
    throw rclcpp::exceptions::InvalidParameterValueException(
            "scheduling_policy must be other, fifo or rr, not " + policy);
  }
}

std::string schedule(std::thread & thread, const std::string & policy, int priority)
{
  if (policy == "other") {
    return "";
  }
  sched_param parameters{};
  parameters.sched_priority = priority;
  const int result = pthread_setschedparam(
    thread.native_handle(), policy == "fifo" ? SCHED_FIFO : SCHED_RR, &parameters);
  return result == 0 ? "" : "scheduling_policy " + policy + " is refused: " + std::strerror(result);
}

}  // namespace PACKAGE_NAME
