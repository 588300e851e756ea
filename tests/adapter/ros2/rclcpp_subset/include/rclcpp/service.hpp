#ifndef RCLCPP__SERVICE_HPP_
#define RCLCPP__SERVICE_HPP_

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "rcl/service.h"
#include "rclcpp/node_base.hpp"
#include "rclcpp/qos.hpp"
#include "rosidl_typesupport_cpp/service_type_support.hpp"

namespace rclcpp
{

class ServiceBase : public detail::Waitable
{
public:
  using SharedPtr = std::shared_ptr<ServiceBase>;

  ServiceBase(
    node_interfaces::NodeBaseInterface & node, const rosidl_service_type_support_t & type,
    const std::string & name, const QoS & qos);
  /// A service that somebody else has made, and keeps.
  explicit ServiceBase(rcl_service_t * service);

  const char * get_service_name() const {return rcl_service_get_service_name(handle_.get());}

  Kind kind() const override {return Kind::Service;}
  const void * rcl_handle() const override {return handle_.get();}

protected:
  bool take_request(rmw_request_id_t & id, void * request);
  void send_response(rmw_request_id_t & id, void * response);

private:
  std::shared_ptr<rcl_service_t> handle_;
};

template<typename ServiceT>
class Service : public ServiceBase
{
public:
  using SharedPtr = std::shared_ptr<Service>;
  using Request = typename ServiceT::Request;
  using Response = typename ServiceT::Response;
  using Callback = std::function<void (std::shared_ptr<Request>, std::shared_ptr<Response>)>;

  Service(
    node_interfaces::NodeBaseInterface & node, const std::string & name, Callback callback, const QoS & qos)
  : ServiceBase(
      node, *rosidl_typesupport_cpp::get_service_type_support_handle<ServiceT>(), name, qos),
    callback_(std::move(callback))
  {}
  Service(rcl_service_t * service, Callback callback)
  : ServiceBase(service), callback_(std::move(callback))
  {}

  std::function<void()> take() override
  {
    auto request = std::make_shared<Request>();
    rmw_request_id_t id;
    if (!take_request(id, request.get())) {
      return {};
    }
    return [this, id, request]() mutable {
             auto response = std::make_shared<Response>();
             callback_(request, response);
             send_response(id, response.get());
           };
  }

private:
  Callback callback_;
};

}  // namespace rclcpp

#endif  // RCLCPP__SERVICE_HPP_
