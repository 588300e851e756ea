#include "overrides.hpp"

#include <map>
#include <regex>
#include <string>
#include <vector>

#include "rcl/arguments.h"
#include "rcl_yaml_param_parser/parser.h"
#include "rclcpp/exceptions.hpp"

namespace rclcpp::detail
{

namespace
{

using Values = std::map<std::string, ParameterValue>;

/// Names of nodes in a file: `*` stands for one part, `**` for any number of them.
bool is_meant(const std::string & pattern, const std::string & node)
{
  const std::string rooted = pattern[0] == '/' ? pattern : "/" + pattern;
  const std::string any = std::regex_replace(rooted, std::regex(R"(/\*)"), R"((/\w+))");
  return std::regex_match(node, std::regex(any));
}

template<typename ElementT, typename ArrayT>
std::vector<ElementT> elements(const ArrayT & array)
{
  return std::vector<ElementT>(array.values, array.values + array.size);
}

std::vector<std::string> texts(const rcutils_string_array_t & array)
{
  return std::vector<std::string>(array.data, array.data + array.size);
}

ParameterValue value_of(const rcl_variant_t & value)
{
  if (value.bool_value) {
    return ParameterValue(*value.bool_value);
  } else if (value.integer_value) {
    return ParameterValue(*value.integer_value);
  } else if (value.double_value) {
    return ParameterValue(*value.double_value);
  } else if (value.string_value) {
    return ParameterValue(std::string(value.string_value));
  } else if (value.byte_array_value) {
    return ParameterValue(elements<uint8_t>(*value.byte_array_value));
  } else if (value.bool_array_value) {
    return ParameterValue(elements<bool>(*value.bool_array_value));
  } else if (value.integer_array_value) {
    return ParameterValue(elements<int64_t>(*value.integer_array_value));
  } else if (value.double_array_value) {
    return ParameterValue(elements<double>(*value.double_array_value));
  } else if (value.string_array_value) {
    return ParameterValue(texts(*value.string_array_value));
  }
  throw exceptions::InvalidParameterValueException("No parameter value set");
}

void add(const rcl_node_params_t & given, Values & values)
{
  for (size_t at = 0; at < given.num_params; ++at) {
    values.insert_or_assign(given.parameter_names[at], value_of(given.parameter_values[at]));
  }
}

void add(const rcl_arguments_t & arguments, const std::string & node, Values & values)
{
  rcl_params_t * given = nullptr;
  check(rcl_arguments_get_param_overrides(&arguments, &given), "parameters of the command line");
  for (size_t at = 0; given && at < given->num_nodes; ++at) {
    if (is_meant(given->node_names[at], node)) {
      add(given->params[at], values);
    }
  }
  if (given) {
    rcl_yaml_node_struct_fini(given);
  }
}

}  // namespace

Values overrides_of(const node_interfaces::NodeBaseInterface & node, const NodeOptions & options)
{
  Values values;
  const std::string name = node.get_fully_qualified_name();
  const auto handle = node.get_shared_rcl_node_handle();
  add(node.get_context()->handle()->global_arguments, name, values);
  add(rcl_node_get_options(handle.get())->arguments, name, values);
  for (const Parameter & override : options.parameter_overrides()) {
    values.insert_or_assign(override.get_name(), override.get_parameter_value());
  }
  return values;
}

}  // namespace rclcpp::detail
