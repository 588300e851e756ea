#include <memory>
#include <string>
#include <thread>

#include "rcl/error_handling.h"
#include "rcl/graph.h"
#include "rclcpp/client.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp
{

ServiceBase::ServiceBase(
  node_interfaces::NodeBaseInterface & node, const rosidl_service_type_support_t & type,
  const std::string & name, const QoS & qos)
{
  auto node_handle = node.get_shared_rcl_node_handle();
  auto service = std::make_unique<rcl_service_t>(rcl_get_zero_initialized_service());
  rcl_service_options_t options = rcl_service_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  detail::check(
    rcl_service_init(service.get(), node_handle.get(), &type, name.c_str(), &options), name.c_str());
  handle_ = {service.release(), [node_handle](rcl_service_t * gone) {
      if (rcl_service_fini(gone, node_handle.get()) != RCL_RET_OK) {
        rcl_reset_error();
      }
      delete gone;
    }};
}

ServiceBase::ServiceBase(rcl_service_t * service)
: handle_(service, [](rcl_service_t *) {})
{
}

bool ServiceBase::take_request(rmw_request_id_t & id, void * request)
{
  const rcl_ret_t taken = rcl_take_request(handle_.get(), &id, request);
  if (taken == RCL_RET_SERVICE_TAKE_FAILED) {
    rcl_reset_error();
    return false;
  }
  detail::check(taken, get_service_name());
  return true;
}

void ServiceBase::send_response(rmw_request_id_t & id, void * response)
{
  const rcl_ret_t sent = rcl_send_response(handle_.get(), &id, response);
  if (sent == RCL_RET_TIMEOUT) {
    rcl_reset_error();  // who asked is gone
    return;
  }
  detail::check(sent, get_service_name());
}

ClientBase::ClientBase(
  node_interfaces::NodeBaseInterface & node, const rosidl_service_type_support_t & type,
  const std::string & name, const QoS & qos)
: node_(node.get_shared_rcl_node_handle())
{
  auto client = std::make_unique<rcl_client_t>(rcl_get_zero_initialized_client());
  rcl_client_options_t options = rcl_client_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  detail::check(
    rcl_client_init(client.get(), node_.get(), &type, name.c_str(), &options), name.c_str());
  handle_ = {client.release(), [node_handle = node_](rcl_client_t * gone) {
      if (rcl_client_fini(gone, node_handle.get()) != RCL_RET_OK) {
        rcl_reset_error();
      }
      delete gone;
    }};
}

bool ClientBase::service_is_ready() const
{
  bool is_ready = false;
  const rcl_ret_t asked = rcl_service_server_is_available(node_.get(), handle_.get(), &is_ready);
  if (asked == RCL_RET_NODE_INVALID) {
    rcl_reset_error();
    return false;  // after shutdown
  }
  detail::check(asked, get_service_name());
  return is_ready;
}

bool ClientBase::wait_for_service(std::chrono::nanoseconds timeout) const
{
  const auto end = std::chrono::steady_clock::now() + timeout;
  while (!service_is_ready()) {
    if (std::chrono::steady_clock::now() > end || !ok()) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

int64_t ClientBase::send_request(const void * request)
{
  int64_t number = 0;
  detail::check(rcl_send_request(handle_.get(), request, &number), get_service_name());
  return number;
}

bool ClientBase::take_response(rmw_request_id_t & id, void * response)
{
  rmw_service_info_t info{};
  const rcl_ret_t taken = rcl_take_response_with_info(handle_.get(), &info, response);
  if (taken == RCL_RET_CLIENT_TAKE_FAILED) {
    rcl_reset_error();
    return false;
  }
  detail::check(taken, get_service_name());
  id = info.request_id;
  return true;
}

}  // namespace rclcpp
