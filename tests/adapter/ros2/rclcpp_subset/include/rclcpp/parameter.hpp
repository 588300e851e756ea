#ifndef RCLCPP__PARAMETER_HPP_
#define RCLCPP__PARAMETER_HPP_

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/parameter.hpp"
#include "rcl_interfaces/msg/parameter_type.hpp"
#include "rcl_interfaces/msg/parameter_value.hpp"
#include "rclcpp/exceptions.hpp"

namespace rclcpp
{

enum ParameterType : uint8_t
{
  PARAMETER_NOT_SET = rcl_interfaces::msg::ParameterType::PARAMETER_NOT_SET,
  PARAMETER_BOOL = rcl_interfaces::msg::ParameterType::PARAMETER_BOOL,
  PARAMETER_INTEGER = rcl_interfaces::msg::ParameterType::PARAMETER_INTEGER,
  PARAMETER_DOUBLE = rcl_interfaces::msg::ParameterType::PARAMETER_DOUBLE,
  PARAMETER_STRING = rcl_interfaces::msg::ParameterType::PARAMETER_STRING,
  PARAMETER_BYTE_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_BYTE_ARRAY,
  PARAMETER_BOOL_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_BOOL_ARRAY,
  PARAMETER_INTEGER_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_INTEGER_ARRAY,
  PARAMETER_DOUBLE_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_DOUBLE_ARRAY,
  PARAMETER_STRING_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_STRING_ARRAY,
};

std::string to_string(ParameterType type);

class ParameterValue
{
public:
  using Message = rcl_interfaces::msg::ParameterValue;

  ParameterValue() = default;
  explicit ParameterValue(const Message & message)
  : value_(message) {}
  explicit ParameterValue(bool value);
  explicit ParameterValue(int value)
  : ParameterValue(int64_t{value}) {}
  explicit ParameterValue(int64_t value);
  explicit ParameterValue(double value);
  explicit ParameterValue(const std::string & value);
  explicit ParameterValue(const char * value)
  : ParameterValue(std::string(value)) {}
  explicit ParameterValue(const std::vector<uint8_t> & value);
  explicit ParameterValue(const std::vector<bool> & value);
  explicit ParameterValue(const std::vector<int64_t> & value);
  explicit ParameterValue(const std::vector<double> & value);
  explicit ParameterValue(const std::vector<std::string> & value);

  ParameterType get_type() const {return static_cast<ParameterType>(value_.type);}
  const Message & to_value_msg() const {return value_;}

  /// The value. Throws ParameterTypeException if it is of another type.
  template<typename T>
  const auto & get() const
  {
    if constexpr (std::is_same_v<T, bool>) {
      return of_type(PARAMETER_BOOL).bool_value;
    } else if constexpr (std::is_same_v<T, int64_t>) {
      return of_type(PARAMETER_INTEGER).integer_value;
    } else if constexpr (std::is_same_v<T, double>) {
      return of_type(PARAMETER_DOUBLE).double_value;
    } else if constexpr (std::is_same_v<T, std::string>) {
      return of_type(PARAMETER_STRING).string_value;
    } else if constexpr (std::is_same_v<T, std::vector<uint8_t>>) {
      return of_type(PARAMETER_BYTE_ARRAY).byte_array_value;
    } else if constexpr (std::is_same_v<T, std::vector<bool>>) {
      return of_type(PARAMETER_BOOL_ARRAY).bool_array_value;
    } else if constexpr (std::is_same_v<T, std::vector<int64_t>>) {
      return of_type(PARAMETER_INTEGER_ARRAY).integer_array_value;
    } else if constexpr (std::is_same_v<T, std::vector<double>>) {
      return of_type(PARAMETER_DOUBLE_ARRAY).double_array_value;
    } else {
      static_assert(std::is_same_v<T, std::vector<std::string>>, "no type of a parameter");
      return of_type(PARAMETER_STRING_ARRAY).string_array_value;
    }
  }

private:
  const Message & of_type(ParameterType type) const;

  Message value_;
};

class Parameter
{
public:
  Parameter() = default;
  Parameter(std::string name, ParameterValue value)
  : name_(std::move(name)), value_(std::move(value)) {}
  template<typename T>
  Parameter(std::string name, T value)
  : Parameter(std::move(name), ParameterValue(std::move(value))) {}

  const std::string & get_name() const {return name_;}
  ParameterType get_type() const {return value_.get_type();}
  const ParameterValue & get_parameter_value() const {return value_;}

  bool as_bool() const {return value_.get<bool>();}
  int64_t as_int() const {return value_.get<int64_t>();}
  double as_double() const {return value_.get<double>();}
  const std::string & as_string() const {return value_.get<std::string>();}
  const std::vector<uint8_t> & as_byte_array() const {return value_.get<std::vector<uint8_t>>();}
  const std::vector<bool> & as_bool_array() const {return value_.get<std::vector<bool>>();}
  const std::vector<int64_t> & as_integer_array() const {return value_.get<std::vector<int64_t>>();}
  const std::vector<double> & as_double_array() const {return value_.get<std::vector<double>>();}
  const std::vector<std::string> & as_string_array() const
  {
    return value_.get<std::vector<std::string>>();
  }

  static Parameter from_parameter_msg(const rcl_interfaces::msg::Parameter & message)
  {
    return Parameter(message.name, ParameterValue(message.value));
  }
  rcl_interfaces::msg::Parameter to_parameter_msg() const;

  bool operator==(const Parameter & other) const
  {
    return name_ == other.name_ && value_.to_value_msg() == other.value_.to_value_msg();
  }
  bool operator!=(const Parameter & other) const {return !(*this == other);}

private:
  std::string name_;
  ParameterValue value_;
};

}  // namespace rclcpp

#endif  // RCLCPP__PARAMETER_HPP_
