#include "player/steps.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <utility>

namespace player {

namespace {

template <typename FutureT>
auto Answer(FutureT&& future, const std::string& node) {
    if (future.wait_for(kPatience) != std::future_status::ready) {
        throw std::runtime_error{node + " does not answer."};
    }
    return future.get();
}

}  // namespace

Steps::Steps(rclcpp::Node& node, Record& record) : record_{record} {
    for (std::size_t number = 0; number < Nodes().size(); ++number) {
        const std::string name = Nodes()[number];
        nodes_.push_back({number, name, node.create_client<StepService>(name + "/step"),
                          node.create_client<lifecycle_msgs::srv::ChangeState>(name + "/change_state")});
    }
}

void Steps::Change(std::uint8_t transition) {
    for (auto& node : nodes_) {
        if (!node.change->wait_for_service(kPatience)) {
            throw std::runtime_error{node.name + " is not there."};
        }
        auto request = std::make_shared<lifecycle_msgs::srv::ChangeState::Request>();
        request->transition.id = transition;
        if (!Answer(node.change->async_send_request(request).future, node.name)->success) {
            throw std::runtime_error{node.name + " refuses transition " + std::to_string(transition) + "."};
        }
    }
}

bool Steps::Step(std::uint64_t time) {
    const std::uint64_t before = record_.GivenInAll();
    for (auto& node : nodes_) {
        Await(node, Ask(node, time, false));
    }
    return record_.GivenInAll() > before;
}

void Steps::Advance(std::uint64_t time) {
    AskAll(time, false);
}

std::uint64_t Steps::NextFrom(std::uint64_t time) const {
    std::uint64_t next = kNever;
    for (const auto& node : nodes_) {
        next = node.next >= time ? std::min(next, node.next) : next;
    }
    return next;
}

bool Steps::AreTold() const {
    return std::all_of(nodes_.begin(), nodes_.end(), [](const Node& node) { return node.next != 0; });
}

void Steps::Wait() {
    AskAll(0, true);
}

void Steps::AskAll(std::uint64_t time, bool only_wait) {
    std::vector<Answered> asked;
    for (auto& node : nodes_) {
        asked.push_back(Ask(node, time, only_wait));
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        Await(nodes_[i], std::move(asked[i]));
    }
}

Steps::Answered Steps::Ask(Node& node, std::uint64_t time, bool only_wait) {
    auto request = std::make_shared<StepService::Request>();
    request->received = record_.Given(node.number);
    request->time = time;
    request->only_wait = only_wait;
    return node.step->async_send_request(request);
}

void Steps::Await(Node& node, Answered asked) {
    const auto answer = Answer(asked.future, node.name);
    if (!answer->success) {
        throw std::runtime_error{node.name + ": " + answer->message};
    }
    node.next = answer->next == 0 ? node.next : answer->next;  // who only waited says nothing
    if (!record_.AwaitHeard(node.number, answer->sent)) {
        throw std::runtime_error{"A message of " + node.name + " was lost."};
    }
}

void Steps::Forget(std::size_t number) {
    record_.Forget(number);
    nodes_.erase(std::remove_if(nodes_.begin(), nodes_.end(), [number](const Node& node) { return node.number == number; }),
                 nodes_.end());
}

}  // namespace player
