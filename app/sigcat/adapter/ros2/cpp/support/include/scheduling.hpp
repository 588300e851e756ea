// The scheduling of the thread that runs a node's calls.

#ifndef PACKAGE_GUARD__SCHEDULING_HPP_
#define PACKAGE_GUARD__SCHEDULING_HPP_

#include <string>
#include <thread>

namespace PACKAGE_NAME
{

/// Throws InvalidParameterValueException if there is no such policy.
void check_policy(const std::string & policy);

/// Gives a thread the policy `fifo` or `rr` with a priority; `other` leaves it as it is. What stood
/// in the way, or nothing.
std::string schedule(std::thread & thread, const std::string & policy, int priority);

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__SCHEDULING_HPP_
