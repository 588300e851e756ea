#ifndef RCLCPP__CLIENT_HPP_
#define RCLCPP__CLIENT_HPP_

#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "rcl/client.h"
#include "rclcpp/node_base.hpp"
#include "rclcpp/qos.hpp"
#include "rosidl_typesupport_cpp/service_type_support.hpp"

namespace rclcpp
{

class ClientBase : public detail::Waitable
{
public:
  using SharedPtr = std::shared_ptr<ClientBase>;

  ClientBase(
    node_interfaces::NodeBaseInterface & node, const rosidl_service_type_support_t & type,
    const std::string & name, const QoS & qos);

  const char * get_service_name() const {return rcl_client_get_service_name(handle_.get());}
  bool service_is_ready() const;
  bool wait_for_service(std::chrono::nanoseconds timeout) const;

  Kind kind() const override {return Kind::Client;}
  const void * rcl_handle() const override {return handle_.get();}

protected:
  int64_t send_request(const void * request);
  bool take_response(rmw_request_id_t & id, void * response);

private:
  std::shared_ptr<rcl_node_t> node_;
  std::shared_ptr<rcl_client_t> handle_;
};

template<typename ServiceT>
class Client : public ClientBase
{
public:
  using SharedPtr = std::shared_ptr<Client>;
  using SharedRequest = std::shared_ptr<typename ServiceT::Request>;
  using SharedResponse = std::shared_ptr<typename ServiceT::Response>;
  using SharedFuture = std::shared_future<SharedResponse>;
  using Callback = std::function<void(SharedFuture)>;

  struct SharedFutureAndRequestId
  {
    SharedFuture future;
    int64_t request_id;
  };

  Client(node_interfaces::NodeBaseInterface & node, const std::string & name, const QoS & qos)
  : ClientBase(
      node, *rosidl_typesupport_cpp::get_service_type_support_handle<ServiceT>(), name, qos)
  {}

  SharedFutureAndRequestId async_send_request(SharedRequest request, Callback callback = {})
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const int64_t number = send_request(request.get());
    Pending & pending = pending_[number];
    pending.callback = std::move(callback);
    pending.future = pending.promise.get_future().share();
    return {pending.future, number};
  }

  size_t prune_pending_requests()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const size_t pruned = pending_.size();
    pending_.clear();
    return pruned;
  }

  std::function<void()> take() override
  {
    auto response = std::make_shared<typename ServiceT::Response>();
    rmw_request_id_t id;
    if (!take_response(id, response.get())) {
      return {};
    }
    return [this, id, response] {answer(id.sequence_number, response);};
  }

private:
  struct Pending
  {
    std::promise<SharedResponse> promise;
    SharedFuture future;
    Callback callback;
  };

  void answer(int64_t number, const SharedResponse & response)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    auto found = pending_.extract(number);
    lock.unlock();
    if (found.empty()) {
      return;
    }
    Pending & pending = found.mapped();
    pending.promise.set_value(response);
    if (pending.callback) {
      pending.callback(pending.future);
    }
  }

  std::mutex mutex_;
  std::map<int64_t, Pending> pending_;
};

}  // namespace rclcpp

#endif  // RCLCPP__CLIENT_HPP_
