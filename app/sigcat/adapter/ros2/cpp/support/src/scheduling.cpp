#include "PACKAGE_NAME/scheduling.hpp"

#include <pthread.h>
#include <sched.h>

#include <cstring>
#include <string>
#include <thread>

namespace PACKAGE_NAME
{

std::string schedule(std::thread & thread, const std::string & policy, int priority)
{
  if (policy == "other") {
    return "";
  }
  if (policy != "fifo" && policy != "rr") {
    return "scheduling_policy must be other, fifo or rr, not " + policy;
  }
  sched_param parameters{};
  parameters.sched_priority = priority;
  const int result = pthread_setschedparam(
    thread.native_handle(), policy == "fifo" ? SCHED_FIFO : SCHED_RR, &parameters);
  return result == 0 ? "" : "scheduling_policy " + policy + " is refused: " + std::strerror(result);
}

}  // namespace PACKAGE_NAME
