#include "rclcpp/node_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "overrides.hpp"
#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp::node_interfaces
{

namespace
{

using Descriptor = NodeParameters::Descriptor;
using Result = NodeParameters::Result;

const QoS parameter_services(KeepLast(rmw_qos_profile_parameters.depth), rmw_qos_profile_parameters);
const QoS parameter_events(
  KeepLast(rmw_qos_profile_parameter_events.depth), rmw_qos_profile_parameter_events);

Result good()
{
  Result result;
  result.successful = true;
  return result;
}

Result refused(const std::string & reason)
{
  Result result;
  result.successful = false;
  result.reason = reason;
  return result;
}

bool are_close(double a, double b)
{
  return std::abs(a - b) <= std::numeric_limits<double>::epsilon() * std::abs(a + b) * 100.0;
}

bool is_within(const rcl_interfaces::msg::IntegerRange & range, int64_t value)
{
  if (value == range.from_value || value == range.to_value) {
    return true;
  }
  const bool is_between = value > range.from_value && value < range.to_value;
  return is_between && (range.step == 0 ||
         (static_cast<uint64_t>(value) - static_cast<uint64_t>(range.from_value)) % range.step == 0);
}

bool is_within(const rcl_interfaces::msg::FloatingPointRange & range, double value)
{
  if (are_close(value, range.from_value) || are_close(value, range.to_value)) {
    return true;
  }
  if (value < range.from_value || value > range.to_value) {
    return false;
  }
  const double steps = std::round((value - range.from_value) / range.step);
  return range.step == 0.0 || are_close(value, range.from_value + steps * range.step);
}

/// What rclcpp says of a value that its descriptor does not allow; empty if it does.
std::string objection(const Parameter & parameter, const Descriptor & descriptor)
{
  const auto type = static_cast<ParameterType>(descriptor.type);
  const std::string name = "arameter {" + parameter.get_name() + "}";
  if (!descriptor.dynamic_typing && type != parameter.get_type()) {
    return "Wrong parameter type, p" + name + " is of type {" + to_string(type) +
           "}, setting it to {" + to_string(parameter.get_type()) + "} is not allowed.";
  }
  if (type == PARAMETER_INTEGER && !descriptor.integer_range.empty() &&
    !is_within(descriptor.integer_range[0], parameter.as_int()))
  {
    return "P" + name + " doesn't comply with integer range.";
  }
  if (type == PARAMETER_DOUBLE && !descriptor.floating_point_range.empty() &&
    !is_within(descriptor.floating_point_range[0], parameter.as_double()))
  {
    return "P" + name + " doesn't comply with floating point range.";
  }
  return "";
}

}  // namespace

NodeParameters::NodeParameters(
  NodeBaseInterface::SharedPtr node, Clock::SharedPtr clock, const NodeOptions & options)
: node_(std::move(node)),
  clock_(std::move(clock)),
  events_(*node_, "/parameter_events", parameter_events, {}),
  overrides_(detail::overrides_of(*node_, options))
{
  serve();
}

const ParameterValue & NodeParameters::declare(
  const std::string & name, const ParameterValue & value, const Descriptor & descriptor)
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (has(name)) {
    throw exceptions::ParameterAlreadyDeclaredException(
            "parameter '" + name + "' has already been declared");
  }
  Declared declared{value, descriptor};
  declared.descriptor.name = name;
  declared.descriptor.type = value.get_type();
  if (const auto found = overrides_.find(name); found != overrides_.end()) {
    declared.value = found->second;
  }
  const Parameter parameter(name, declared.value);
  const Result result = check({parameter}, {{name, declared.descriptor}});
  if (!result.successful && declared.value.get_type() != value.get_type()) {
    throw exceptions::InvalidParameterTypeException(name, result.reason);
  }
  if (!result.successful) {
    throw exceptions::InvalidParameterValueException(
            "parameter '" + name + "' could not be set: " + result.reason);
  }
  const auto made = declared_.insert_or_assign(name, std::move(declared)).first;
  tell({parameter}, true);
  return made->second.value;
}

bool NodeParameters::has(const std::string & name) const
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return declared_.count(name) != 0;
}

const NodeParameters::Declared & NodeParameters::at(const std::string & name) const
{
  const auto found = declared_.find(name);
  if (found == declared_.end()) {
    throw exceptions::ParameterNotDeclaredException("parameter '" + name + "' is not declared");
  }
  return found->second;
}

Parameter NodeParameters::get(const std::string & name) const
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return Parameter(name, at(name).value);
}

Descriptor NodeParameters::describe(const std::string & name) const
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return at(name).descriptor;
}

rcl_interfaces::msg::ListParametersResult NodeParameters::list(
  const std::vector<std::string> & prefixes, uint64_t depth) const
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  rcl_interfaces::msg::ListParametersResult result;
  const auto is_asked_for = [&](const std::string & name, const std::string & prefix) {
      const bool is_below = prefix.empty() || name.rfind(prefix + ".", 0) == 0;
      const std::string rest = name.substr(prefix.empty() || !is_below ? 0 : prefix.size() + 1);
      const auto dots = static_cast<uint64_t>(std::count(rest.begin(), rest.end(), '.'));
      return name == prefix || (is_below && (depth == 0 || dots < depth));
    };
  for (const auto & [name, declared] : declared_) {
    const std::vector<std::string> all{""};
    for (const std::string & prefix : prefixes.empty() ? all : prefixes) {
      if (is_asked_for(name, prefix)) {
        result.names.push_back(name);
        break;
      }
    }
  }
  return result;
}

Result NodeParameters::set_atomically(const Parameters & parameters)
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  std::map<std::string, Descriptor> descriptors;
  for (const Parameter & parameter : parameters) {
    const std::string & name = parameter.get_name();
    if (!has(name)) {
      throw exceptions::ParameterNotDeclaredException(
              "parameter '" + name + "' cannot be set because it was not declared");
    }
    descriptors[name] = describe(name);
    if (descriptors[name].read_only) {
      return refused("parameter '" + name + "' cannot be set because it is read-only");
    }
  }
  const Result result = check(parameters, descriptors);
  if (result.successful) {
    for (const Parameter & parameter : parameters) {
      declared_[parameter.get_name()].value = parameter.get_parameter_value();
    }
    for (const auto & weak : post_set_) {
      if (const auto handle = weak.lock()) {
        handle->callback(parameters);
      }
    }
    tell(parameters, false);
  }
  return result;
}

Result NodeParameters::check(
  const Parameters & parameters, const std::map<std::string, Descriptor> & descriptors)
{
  for (const Parameter & parameter : parameters) {
    const std::string reason = objection(parameter, descriptors.at(parameter.get_name()));
    if (!reason.empty()) {
      return refused(reason);
    }
  }
  for (const auto & weak : on_set_) {
    const auto handle = weak.lock();
    const Result result = handle ? handle->callback(parameters) : good();
    if (!result.successful) {
      return result;
    }
  }
  return good();
}

void NodeParameters::tell(const Parameters & parameters, bool are_new)
{
  rcl_interfaces::msg::ParameterEvent event;
  event.stamp = clock_->now();
  event.node = node_->get_fully_qualified_name();
  for (const Parameter & parameter : parameters) {
    auto & told = are_new ? event.new_parameters : event.changed_parameters;
    told.push_back(parameter.to_parameter_msg());
  }
  events_.publish(event);
  if (after_set_) {
    after_set_(parameters);
  }
}

OnSetParametersCallbackHandle::SharedPtr NodeParameters::add_on_set(
  OnSetParametersCallbackHandle::OnSetParametersCallbackType callback)
{
  auto handle = std::make_shared<OnSetParametersCallbackHandle>();
  handle->callback = std::move(callback);
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  on_set_.push_front(handle);
  return handle;
}

PostSetParametersCallbackHandle::SharedPtr NodeParameters::add_post_set(
  PostSetParametersCallbackHandle::PostSetParametersCallbackType callback)
{
  auto handle = std::make_shared<PostSetParametersCallbackHandle>();
  handle->callback = std::move(callback);
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  post_set_.push_front(handle);
  return handle;
}

void NodeParameters::after_set(std::function<void(const Parameters &)> callback)
{
  after_set_ = std::move(callback);
}

template<typename ServiceT, typename CallbackT>
void NodeParameters::serve(const std::string & name, CallbackT callback)
{
  auto service = std::make_shared<Service<ServiceT>>(
    *node_, "~/" + name,
    [callback](auto request, auto response) {callback(*request, *response);}, parameter_services);
  node_->add(service, nullptr);
  services_.push_back(service);
}

void NodeParameters::serve()
{
  using namespace rcl_interfaces::srv;  // NOLINT(build/namespaces): six services
  const auto set = [this](const auto & messages) {
      Parameters parameters;
      for (const auto & message : messages) {
        parameters.push_back(Parameter::from_parameter_msg(message));
      }
      try {
        return set_atomically(parameters);
      } catch (const exceptions::ParameterNotDeclaredException & exception) {
        return refused(exception.what());
      }
    };
  serve<GetParameters>("get_parameters", [this](const auto & request, auto & response) {
      const auto is_declared = [this](const std::string & name) {return has(name);};
      if (std::all_of(request.names.begin(), request.names.end(), is_declared)) {
        for (const std::string & name : request.names) {
          response.values.push_back(get(name).get_parameter_value().to_value_msg());
        }
      }
    });
  serve<GetParameterTypes>("get_parameter_types", [this](const auto & request, auto & response) {
      for (const std::string & name : request.names) {
        const ParameterType type = has(name) ? get(name).get_type() : PARAMETER_NOT_SET;
        response.types.push_back(type);
      }
    });
  serve<SetParameters>("set_parameters", [set](const auto & request, auto & response) {
      for (const auto & message : request.parameters) {
        response.results.push_back(set(std::vector<rcl_interfaces::msg::Parameter>{message}));
      }
    });
  serve<SetParametersAtomically>(
    "set_parameters_atomically", [set](const auto & request, auto & response) {
      response.result = set(request.parameters);
    });
  serve<DescribeParameters>("describe_parameters", [this](const auto & request, auto & response) {
      const auto is_declared = [this](const std::string & name) {return has(name);};
      if (std::all_of(request.names.begin(), request.names.end(), is_declared)) {
        for (const std::string & name : request.names) {
          response.descriptors.push_back(describe(name));
        }
      }
    });
  serve<ListParameters>("list_parameters", [this](const auto & request, auto & response) {
      response.result = list(request.prefixes, request.depth);
    });
}

}  // namespace rclcpp::node_interfaces
