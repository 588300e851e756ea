// The nodes, brought through their life and made to step, by their services.

#ifndef PLAYER_STEPS_H
#define PLAYER_STEPS_H

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lifecycle_msgs/srv/change_state.hpp"
#include "player/ports.h"
#include "player/step_service.h"
#include "rclcpp/rclcpp.hpp"

namespace player {

class Steps final {
public:
    Steps(rclcpp::Node& node, Record& record);

    /// Brings every node through a transition. Throws std::runtime_error if one refuses.
    void Change(std::uint8_t transition);

    /// One step of each node, in the order of the set: what one sends the next one has taken. They are at `time` afterwards.
    /// Whether any of them has sent something to another one.
    bool Step(std::uint64_t time);

    /// All nodes continue to `time`, until which nothing is due.
    void Advance(std::uint64_t time);

    /// The earliest time from this one on at which a node has said that it runs.
    std::uint64_t NextFrom(std::uint64_t time) const;

    /// Whether every node has said when it runs.
    bool AreTold() const;

    /// All nodes have taken what was sent to them.
    void Wait();

    /// A node is gone.
    void Forget(std::size_t number);

private:
    struct Node final {
        std::size_t number;
        std::string name;
        rclcpp::Client<StepService>::SharedPtr step;
        rclcpp::Client<lifecycle_msgs::srv::ChangeState>::SharedPtr change;
        std::uint64_t next{0};
    };

    using Answered = decltype(std::declval<rclcpp::Client<StepService>&>().async_send_request(nullptr));

    void AskAll(std::uint64_t time, bool only_wait);
    Answered Ask(Node& node, std::uint64_t time, bool only_wait);
    void Await(Node& node, Answered asked);

    Record& record_;
    std::vector<Node> nodes_;
};

}  // namespace player

#endif  // PLAYER_STEPS_H
