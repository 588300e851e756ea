#ifndef RCLCPP__MESSAGE_INFO_HPP_
#define RCLCPP__MESSAGE_INFO_HPP_

#include "rmw/types.h"

namespace rclcpp
{

class MessageInfo
{
public:
  const rmw_message_info_t & get_rmw_message_info() const {return info_;}
  rmw_message_info_t & get_rmw_message_info() {return info_;}

private:
  rmw_message_info_t info_ = rmw_get_zero_initialized_message_info();
};

}  // namespace rclcpp

#endif  // RCLCPP__MESSAGE_INFO_HPP_
