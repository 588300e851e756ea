// The topics of the player: it publishes what no node publishes, and hears what nodes publish.

#ifndef PLAYER_PORTS_H
#define PLAYER_PORTS_H

#include <algorithm>
#include <array>
#include <atomic>
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
#include <type_traits>
#include <utility>
#include <vector>

#include "builtin_interfaces/msg/time.hpp"
#include "player/cell.h"
#include "player/times.h"
#include "rclcpp/rclcpp.hpp"

namespace player {

/// After which what does not come will not come.
constexpr std::chrono::seconds kPatience{20};

constexpr std::size_t kRoom = 1000;  // messages of a topic that wait until they are taken

constexpr std::int64_t kSecond = 1000000000;  // in ns

using Symbol = std::pair<const char*, std::int64_t>;
using Takers = std::set<std::size_t>;  // nodes, by their numbers

template <typename T, typename = void>
struct IsSequence : std::false_type {};
template <typename T>
struct IsSequence<T, std::void_t<typename T::allocator_type>> : std::bool_constant<!std::is_same_v<T, std::string>> {};

template <typename T>
struct IsList : IsSequence<T> {};
template <typename T, std::size_t size>
struct IsList<std::array<T, size>> : std::true_type {};

/// A sequence of any length: it takes all words.
template <typename T>
struct Cell<T, std::enable_if_t<IsSequence<T>::value>> final {
    static T Read(Words& from) {
        T value;
        while (!from.IsOver()) {
            value.push_back(player::Read<typename T::value_type>(from));
        }
        return value;
    }
    static std::string Text(const T& value, bool /* is_inner */) { return ListText(value); }
};

/// Fills a field with an enumeration: its name, or the number that the message has for it.
template <typename T>
void Fill(T& field, Words& from, const std::vector<Symbol>& symbols) {
    if constexpr (IsSequence<T>::value) {
        while (!from.IsOver()) {
            Fill(field.emplace_back(), from, symbols);
        }
    } else if constexpr (IsList<T>::value) {
        for (auto& each : field) {
            Fill(each, from, symbols);
        }
    } else if constexpr (std::is_same_v<T, std::string>) {
        field = from.Next();
    } else {
        const std::string word = from.Next();
        const auto found = std::find_if(symbols.begin(), symbols.end(), [&word](const auto& each) { return word == each.first; });
        field = found != symbols.end() ? static_cast<T>(found->second) : NumberOf<T>(word);
    }
}

/// Fills a field with the enumeration of a whole cell.
template <typename T>
void FillAll(T& field, const std::string& cell, const std::vector<Symbol>& symbols) {
    Words from{cell};
    Fill(field, from, symbols);
    if (!from.IsOver()) {
        throw std::runtime_error{Quoted(cell) + " has too many values."};
    }
}

/// The text of an enumeration.
template <typename T>
std::string NameOf(const T& field, const std::vector<Symbol>& symbols, bool is_inner = false) {
    if constexpr (IsList<T>::value) {
        std::string text = "[";
        for (const auto& each : field) {
            text += (text.size() > 1 ? "," : "") + NameOf(each, symbols, true);
        }
        return text + "]";
    } else if constexpr (std::is_same_v<T, std::string>) {
        return is_inner ? Quoted(field) : field;
    } else {
        const auto is_it = [&field](const auto& each) { return each.second == static_cast<std::int64_t>(field); };
        const auto found = std::find_if(symbols.begin(), symbols.end(), is_it);
        return found == symbols.end() ? std::to_string(field) : is_inner ? Quoted(found->first) : found->first;
    }
}

/// The time that a message has: its own, that of its header, or none.
template <typename MessageT, typename = void>
struct Stamp final {
    static builtin_interfaces::msg::Time* Of(MessageT&) { return nullptr; }
};
template <typename MessageT>
struct Stamp<MessageT, std::enable_if_t<std::is_same_v<decltype(MessageT::stamp), builtin_interfaces::msg::Time>>> final {
    static auto* Of(MessageT& message) { return &message.stamp; }
};
template <typename MessageT>
struct Stamp<MessageT, std::void_t<decltype(MessageT::header.stamp)>> final {
    static auto* Of(MessageT& message) { return &message.header.stamp; }
};

/// What was sent by whom, and how many messages each node has to take.
class Record final {
public:
    /// `is_read` by another program while it is written: it reports the actions of the player.
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

    /// The time of the nodes in lock step.
    void SetNow(std::uint64_t time) { now_ = static_cast<std::int64_t>(time); }
    std::int64_t Now() const { return now_; }

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
    std::atomic<std::int64_t> now_{0};
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
        if (auto* const time = Stamp<MessageT>::Of(message)) {
            time->sec = static_cast<std::int32_t>(stamp / kSecond);
            time->nanosec = static_cast<std::uint32_t>(stamp % kSecond);
        }
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
    Ports(rclcpp::Node& node, Record& record, bool is_lock_step)
        : node_{node}, record_{record}, is_lock_step_{is_lock_step} {}

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
            fill(out.message, cell);
            out.is_filled = true;
        };
    }

    /// Keeps all, whatever depth the topic has: calls that follow each other at once send several values, and each is recorded.
    template <typename MessageT, typename ValuesT>
    void Hear(const std::string& topic, rclcpp::QoS quality, std::size_t node, const Takers& takers, ValuesT values) {
        quality.keep_last(kRoom);
        Takers others = takers;
        others.erase(node);
        subscriptions_.push_back(node_.create_subscription<MessageT>(
            topic, quality, [this, node, others, values](const MessageT& message) {
                MessageT copy = message;
                const auto* const time = Stamp<MessageT>::Of(copy);
                record_.Hear(node, others, values(message), time != nullptr ? Nanoseconds(*time) : Now());
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
    static std::int64_t Nanoseconds(const builtin_interfaces::msg::Time& time) {
        return static_cast<std::int64_t>(time.sec) * kSecond + static_cast<std::int64_t>(time.nanosec);
    }
    /// The time of a message that has none.
    std::int64_t Now() const { return is_lock_step_ ? record_.Now() : node_.now().nanoseconds(); }

    rclcpp::Node& node_;
    Record& record_;
    bool is_lock_step_;
    std::vector<std::unique_ptr<Out>> outs_;
    std::map<std::string, std::function<void(const std::string&)>> columns_;
    std::vector<std::shared_ptr<void>> subscriptions_;
};

/// Reliable for all that hear it, or as reliable as the one that is heard. `depth`: messages that a late subscriber gets.
inline rclcpp::QoS Quality(bool is_reliable, bool keeps, std::size_t depth) {
    rclcpp::QoS quality{rclcpp::KeepLast(keeps ? depth : kRoom)};
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

/// Whether received values make calls due, too.
bool HasEvents();

void Connect(Ports& ports);

}  // namespace player

#endif  // PLAYER_PORTS_H
