#ifndef RCLCPP__NODE_OPTIONS_HPP_
#define RCLCPP__NODE_OPTIONS_HPP_

#include <string>
#include <utility>
#include <vector>

#include "rclcpp/parameter.hpp"

namespace rclcpp
{

class NodeOptions
{
public:
  const std::vector<std::string> & arguments() const {return arguments_;}
  NodeOptions & arguments(std::vector<std::string> arguments)
  {
    arguments_ = std::move(arguments);
    return *this;
  }

  const std::vector<Parameter> & parameter_overrides() const {return overrides_;}
  NodeOptions & parameter_overrides(std::vector<Parameter> overrides)
  {
    overrides_ = std::move(overrides);
    return *this;
  }
  template<typename T>
  NodeOptions & append_parameter_override(const std::string & name, const T & value)
  {
    overrides_.emplace_back(name, ParameterValue(value));
    return *this;
  }

private:
  std::vector<std::string> arguments_;
  std::vector<Parameter> overrides_;
};

}  // namespace rclcpp

#endif  // RCLCPP__NODE_OPTIONS_HPP_
