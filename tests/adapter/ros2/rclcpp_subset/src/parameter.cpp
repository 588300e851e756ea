#include "rclcpp/parameter.hpp"

#include <string>
#include <vector>

namespace rclcpp
{

std::string to_string(ParameterType type)
{
  switch (type) {
    case PARAMETER_NOT_SET: return "not set";
    case PARAMETER_BOOL: return "bool";
    case PARAMETER_INTEGER: return "integer";
    case PARAMETER_DOUBLE: return "double";
    case PARAMETER_STRING: return "string";
    case PARAMETER_BYTE_ARRAY: return "byte_array";
    case PARAMETER_BOOL_ARRAY: return "bool_array";
    case PARAMETER_INTEGER_ARRAY: return "integer_array";
    case PARAMETER_DOUBLE_ARRAY: return "double_array";
    case PARAMETER_STRING_ARRAY: return "string_array";
  }
  return "unknown type";
}

ParameterValue::ParameterValue(bool value)
{
  value_.type = PARAMETER_BOOL;
  value_.bool_value = value;
}

ParameterValue::ParameterValue(int64_t value)
{
  value_.type = PARAMETER_INTEGER;
  value_.integer_value = value;
}

ParameterValue::ParameterValue(double value)
{
  value_.type = PARAMETER_DOUBLE;
  value_.double_value = value;
}

ParameterValue::ParameterValue(const std::string & value)
{
  value_.type = PARAMETER_STRING;
  value_.string_value = value;
}

ParameterValue::ParameterValue(const std::vector<uint8_t> & value)
{
  value_.type = PARAMETER_BYTE_ARRAY;
  value_.byte_array_value = value;
}

ParameterValue::ParameterValue(const std::vector<bool> & value)
{
  value_.type = PARAMETER_BOOL_ARRAY;
  value_.bool_array_value = value;
}

ParameterValue::ParameterValue(const std::vector<int64_t> & value)
{
  value_.type = PARAMETER_INTEGER_ARRAY;
  value_.integer_array_value = value;
}

ParameterValue::ParameterValue(const std::vector<double> & value)
{
  value_.type = PARAMETER_DOUBLE_ARRAY;
  value_.double_array_value = value;
}

ParameterValue::ParameterValue(const std::vector<std::string> & value)
{
  value_.type = PARAMETER_STRING_ARRAY;
  value_.string_array_value = value;
}

const ParameterValue::Message & ParameterValue::of_type(ParameterType type) const
{
  if (get_type() != type) {
    throw ParameterTypeException("expected [" + to_string(type) + "] got [" + to_string(get_type()) + "]");
  }
  return value_;
}

rcl_interfaces::msg::Parameter Parameter::to_parameter_msg() const
{
  rcl_interfaces::msg::Parameter message;
  message.name = name_;
  message.value = value_.to_value_msg();
  return message;
}

}  // namespace rclcpp
