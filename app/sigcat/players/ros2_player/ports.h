// The topics of the player: it publishes what no node publishes, and hears what nodes publish.

#ifndef PLAYER_PORTS_H
#define PLAYER_PORTS_H

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "player/cell.h"
#include "player/times.h"
#include "rclcpp/rclcpp.hpp"

namespace player {

/// After which what does not come will not come.
constexpr std::chrono::seconds kPatience{20};

constexpr std::int64_t kSecond = 1000000000;  // in ns

using Symbol = std::pair<const char*, std::int64_t>;
using Takers = std::set<std::size_t>;  // nodes, by their numbers

template <>
struct Cell<std::string, void> final {
    static std::string Read(const Item& item) { return item.text; }
    static std::string Text(const std::string& value) { return value; }
};

/// A sequence of any length.
template <typename T>
struct Cell<T, std::void_t<typename T::allocator_type, std::enable_if_t<!std::is_same<T, std::string>::value>>> final {
    static T Read(const Item& item) {
        T value;
        for (const auto& each : item.items) {
            value.push_back(player::Read<typename T::value_type>(each));
        }
        return value;
    }
    static std::string Text(const T& value) {
        std::string text = "[";
        for (std::size_t i = 0; i < value.size(); ++i) {
            text += (i > 0 ? "," : "") + player::Text(static_cast<typename T::value_type>(value[i]));
        }
        return text + "]";
    }
};

/// The number of a symbol, or of a text that is a number.
inline std::int64_t NumberOf(const std::string& text, const std::vector<Symbol>& symbols) {
    for (const auto& each : symbols) {
        if (text == each.first) {
            return each.second;
        }
    }
    return std::strtoll(text.c_str(), nullptr, 0);
}

inline std::string SymbolOf(std::int64_t number, const std::vector<Symbol>& symbols) {
    for (const auto& each : symbols) {
        if (number == each.second) {
            return each.first;
        }
    }
    return std::to_string(number);
}

/// What was sent by whom, and how many messages each node has to take.
class Record final {
public:
    /// `is_read` by another program while it is written: it is told what the player does.
    Record(const std::string& file, std::size_t nodes, bool is_read);

    /// Stamps are those of a clock that was at `epoch`, which is 0 in lock step, when the drive was at `begin`.
    void Begin(std::int64_t epoch, std::uint64_t begin) {
        const std::lock_guard<std::mutex> lock{mutex_};
        epoch_ = epoch;
        begin_ = begin;
    }
    void Hear(std::size_t node, const Takers& takers, const std::vector<std::pair<const char*, std::string>>& values,
              std::int64_t stamp);
    void Give(const Takers& takers);
    void Forget(std::size_t node);
    void Say(const std::string& line);  // to the program that reads
    void TimeIn(const std::string& file);  // when rows are sent and values come
    void TellSent(std::uint64_t row);

    std::uint64_t Given(std::size_t node) const;
    std::uint64_t GivenInAll() const;

    /// Whether as many messages of a node have come here, at the latest after the patience of the player.
    bool AwaitHeard(std::size_t node, std::uint64_t count);

private:
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::ofstream out_;
    Times times_;
    bool is_read_;
    std::int64_t epoch_{0};
    std::uint64_t begin_{0};
    std::vector<std::uint64_t> heard_;
    std::vector<std::uint64_t> given_;
    std::set<std::size_t> gone_;
};

class Out {
public:
    explicit Out(Takers takers) : takers_(std::move(takers)) {}
    virtual ~Out() = default;
    virtual void Publish(std::int64_t stamp) = 0;
    virtual std::size_t Subscriptions() const = 0;
    const Takers& Nodes() const { return takers_; }
    bool is_filled{false};
    bool is_sent{false};  // in the time that is

private:
    Takers takers_;
};

template <typename MessageT>
class OutOf final : public Out {
public:
    OutOf(rclcpp::Node& node, const std::string& topic, const rclcpp::QoS& quality, Takers takers)
        : Out{std::move(takers)}, publisher_{node.create_publisher<MessageT>(topic, quality)} {}

    void Publish(std::int64_t stamp) override {
        message.stamp.sec = static_cast<std::int32_t>(stamp / kSecond);
        message.stamp.nanosec = static_cast<std::uint32_t>(stamp % kSecond);
        publisher_->publish(message);
        message = MessageT{};
        is_filled = false;
    }
    std::size_t Subscriptions() const override { return publisher_->get_subscription_count(); }

    MessageT message{};

private:
    std::shared_ptr<rclcpp::Publisher<MessageT>> publisher_;
};

class Ports final {
public:
    Ports(rclcpp::Node& node, Record& record) : node_{node}, record_{record} {}

    template <typename MessageT>
    OutOf<MessageT>& Offer(const std::string& topic, const rclcpp::QoS& quality, const Takers& takers) {
        auto made = std::make_unique<OutOf<MessageT>>(node_, topic, quality, takers);
        auto& out = *made;
        outs_.push_back(std::move(made));
        return out;
    }

    template <typename MessageT, typename FillT>
    void Column(const char* name, OutOf<MessageT>& out, FillT fill) {
        columns_[name] = [&out, fill](const std::string& cell) {
            fill(out.message, Parsed(cell));
            out.is_filled = true;
        };
    }

    template <typename MessageT, typename ValuesT>
    void Hear(const std::string& topic, const rclcpp::QoS& quality, std::size_t node, const Takers& takers,
              ValuesT values) {
        Takers others = takers;
        others.erase(node);
        subscriptions_.push_back(node_.create_subscription<MessageT>(
            topic, quality, [this, node, others, values](const MessageT& message) {
                const std::int64_t stamp = static_cast<std::int64_t>(message.stamp.sec) * kSecond +
                                           static_cast<std::int64_t>(message.stamp.nanosec);
                record_.Hear(node, others, values(message), stamp);
            }));
    }

    /// Fills the message that has a column. False if there is none.
    bool Set(const std::string& name, const std::string& cell);

    /// Whether a node receives what has this name.
    bool Has(const std::string& name) const { return columns_.count(name) != 0; }

    /// Sends what was filled, with the time at which it was measured, in ns.
    void Publish(std::int64_t stamp);

    /// Whether what was filled would be the second message of a topic in the time that is: of a subscription that keeps one
    /// value, the first would be lost.
    bool Repeats() const;

    /// Another time begins, or everything that was sent in this one has been taken.
    void Forget();

    /// Whether every subscription of the nodes has been found.
    bool AreConnected() const;

private:
    rclcpp::Node& node_;
    Record& record_;
    std::vector<std::unique_ptr<Out>> outs_;
    std::map<std::string, std::function<void(const std::string&)>> columns_;
    std::vector<std::shared_ptr<void>> subscriptions_;
};

/// Reliable for all that hear it, or as reliable as the one that is heard.
inline rclcpp::QoS Quality(bool is_reliable, bool keeps) {
    rclcpp::QoS quality{rclcpp::KeepLast(keeps ? 1 : 1000)};
    is_reliable ? quality.reliable() : quality.best_effort();
    return keeps ? quality.transient_local() : quality;
}

// -- generated: what there is of these nodes ----------------------------------------------------------------------

/// Names of the nodes, in the order of their numbers.
const std::vector<std::string>& Nodes();

/// Numbers of the nodes of a function.
const std::map<std::string, std::size_t>& Functions();

/// Times at which a call is due: period and offset, in ns.
const std::vector<std::pair<std::uint64_t, std::uint64_t>>& Cycles();

/// Whether calls are due by what comes, too.
bool HasEvents();

void Connect(Ports& ports);

}  // namespace player

#endif  // PLAYER_PORTS_H
