// Parameters of a node: their descriptors, and their values as the core has them.

#ifndef PACKAGE_GUARD__PARAMETERS_HPP_
#define PACKAGE_GUARD__PARAMETERS_HPP_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "PACKAGE_NAME/values.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"

namespace PACKAGE_NAME
{

inline rcl_interfaces::msg::ParameterDescriptor described(
  const std::string & description, const std::string & constraints = "")
{
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = description;
  descriptor.additional_constraints = constraints;
  return descriptor;
}

/// Set at the start only.
inline rcl_interfaces::msg::ParameterDescriptor fixed(
  rcl_interfaces::msg::ParameterDescriptor descriptor)
{
  descriptor.read_only = true;
  return descriptor;
}

inline rcl_interfaces::msg::ParameterDescriptor within(
  rcl_interfaces::msg::ParameterDescriptor descriptor, double from, double to)
{
  descriptor.floating_point_range.resize(1);
  descriptor.floating_point_range[0].from_value = from;
  descriptor.floating_point_range[0].to_value = to;
  return descriptor;
}

inline rcl_interfaces::msg::ParameterDescriptor within(
  rcl_interfaces::msg::ParameterDescriptor descriptor, int64_t from, int64_t to)
{
  descriptor.integer_range.resize(1);
  descriptor.integer_range[0].from_value = from;
  descriptor.integer_range[0].to_value = to;
  descriptor.integer_range[0].step = 1;
  return descriptor;
}

/// Takes a number into its place in the core. False if the place cannot hold it.
template<typename FromT, typename ToT>
bool take(FromT from, ToT & to)
{
  constexpr bool kIsWhole = std::numeric_limits<ToT>::is_integer;
  const ToT taken = static_cast<ToT>(from);
  bool is_held = true;
  if constexpr (std::is_same_v<ToT, float>) {
    is_held = std::isfinite(taken) == std::isfinite(from);
  } else if constexpr (kIsWhole) {
    is_held = static_cast<FromT>(taken) == from && (taken > ToT{}) == (from > FromT{});
  }
  to = is_held ? taken : to;
  return is_held;
}

/// Takes an array, whose length has to be that of its place.
template<typename FromT, typename ToT, std::size_t size>
bool take(const std::vector<FromT> & from, ToT (& to)[size])
{
  bool is_taken = from.size() == size;
  for (std::size_t i = 0; is_taken && i < size; ++i) {
    is_taken = take(static_cast<FromT>(from[i]), to[i]);
  }
  return is_taken;
}

/// Takes the number of a text. False if it is none of the enumeration.
template<std::size_t count, typename ToT>
bool take(const Symbol (& symbols)[count], const std::string & from, ToT & to)
{
  for (const Symbol & symbol : symbols) {
    if (from == symbol.text) {
      to = static_cast<ToT>(symbol.number);
      return true;
    }
  }
  return false;
}

template<std::size_t count, typename ToT, std::size_t size>
bool take(
  const Symbol (& symbols)[count], const std::vector<std::string> & from, ToT (& to)[size])
{
  bool is_taken = from.size() == size;
  for (std::size_t i = 0; is_taken && i < size; ++i) {
    is_taken = take(symbols, from[i], to[i]);
  }
  return is_taken;
}

/// Lets the core start with a value that is neither stored nor the default.
template<typename ValueT, typename StoredT>
void start_with(const ValueT & value, const ValueT & standard, StoredT & stored)
{
  if (!stored.is_there && value != standard) {
    stored.is_there = take(value, stored.value);
  }
}

template<std::size_t count, typename ValueT, typename StoredT>
void start_with(
  const Symbol (& symbols)[count], const ValueT & value, const ValueT & standard, StoredT & stored)
{
  if (!stored.is_there && value != standard) {
    stored.is_there = take(symbols, value, stored.value);
  }
}

/// The limits of a parameter, in its unit.
struct Limits
{
  const char * name;
  double low;
  double high;

  bool has(const rclcpp::Parameter & parameter) const
  {
    const auto is_inside = [this](auto value) {
        return static_cast<double>(value) >= low && static_cast<double>(value) <= high;
      };
    const auto are_inside = [&is_inside](const auto & values) {
        return std::all_of(values.begin(), values.end(), is_inside);
      };
    switch (parameter.get_type()) {
      case rclcpp::ParameterType::PARAMETER_INTEGER:
        return is_inside(parameter.as_int());
      case rclcpp::ParameterType::PARAMETER_DOUBLE:
        return is_inside(parameter.as_double());
      case rclcpp::ParameterType::PARAMETER_INTEGER_ARRAY:
        return are_inside(parameter.as_integer_array());
      case rclcpp::ParameterType::PARAMETER_DOUBLE_ARRAY:
        return are_inside(parameter.as_double_array());
      default:
        return true;
    }
  }
};

/// Which parameter the core refuses, and what its limits are.
inline std::string refusal(
  const std::vector<rclcpp::Parameter> & parameters, const std::vector<Limits> & limits)
{
  std::string names;
  for (const rclcpp::Parameter & parameter : parameters) {
    const std::string & name = parameter.get_name();
    const auto is_own = [&name](const Limits & each) {return name == each.name;};
    const auto own = std::find_if(limits.begin(), limits.end(), is_own);
    if (own != limits.end() && !own->has(parameter)) {
      std::ostringstream text;
      text << name << " must be from " << own->low << " to " << own->high;
      return text.str();
    }
    names += (names.empty() ? "" : ", ") + name;
  }
  return names + ": a value is out of its range";
}

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__PARAMETERS_HPP_
