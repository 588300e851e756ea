#ifndef RCLCPP__EXCEPTIONS_HPP_
#define RCLCPP__EXCEPTIONS_HPP_

#include <stdexcept>
#include <string>

#include "rcl/types.h"

namespace rclcpp::exceptions
{

class RCLError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

class InvalidParametersException : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

class InvalidParameterValueException : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

class InvalidParameterTypeException : public std::runtime_error
{
public:
  InvalidParameterTypeException(const std::string & name, const std::string & message)
  : std::runtime_error("parameter '" + name + "' has invalid type: " + message)
  {}
};

class ParameterAlreadyDeclaredException : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

class ParameterNotDeclaredException : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

}  // namespace rclcpp::exceptions

namespace rclcpp
{

class ParameterTypeException : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

namespace detail
{

/// Throws RCLError, with what rcl says, unless the result is good.
void check(rcl_ret_t result, const char * what);

}  // namespace detail
}  // namespace rclcpp

#endif  // RCLCPP__EXCEPTIONS_HPP_
