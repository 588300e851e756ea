// What a thread does, if it may fail.

#ifndef PACKAGE_GUARD__GUARD_HPP_
#define PACKAGE_GUARD__GUARD_HPP_

#include <exception>

#include "rclcpp/rclcpp.hpp"

namespace PACKAGE_NAME
{

/// Does `work`, and answers whether it came to its end. An exception that left a thread would end
/// the process, and with it all nodes in it: it is logged, after what it leads to.
template<typename WorkT>
bool guarded(const rclcpp::Logger & logger, const char * consequence, WorkT && work)
{
  try {
    work();
    return true;
  } catch (const std::exception & error) {
    RCLCPP_FATAL(logger, "%s: %s", consequence, error.what());
    return false;
  }
}

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__GUARD_HPP_
