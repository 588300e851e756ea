// Statuses as /diagnostics has them: of errors and of calls.

#ifndef PACKAGE_GUARD__DIAGNOSTICS_HPP_
#define PACKAGE_GUARD__DIAGNOSTICS_HPP_

#include <chrono>
#include <cstdint>
#include <string>

#include "diagnostic_msgs/msg/diagnostic_status.hpp"

namespace PACKAGE_NAME
{

/// Whether a count has grown lately, that is, within the last second or two: a level holds that
/// long, however often statuses are sent.
class Recent
{
public:
  bool grows(uint64_t count)
  {
    const auto now = std::chrono::steady_clock::now();
    if (now - begin_ >= std::chrono::milliseconds(900)) {
      before_ = last_;
      last_ = count;
      begin_ = now;
    }
    return count != before_;
  }

  /// What has been counted so far does not matter.
  void forget(uint64_t count)
  {
    before_ = count;
    last_ = count;
  }

private:
  uint64_t before_ = 0;
  uint64_t last_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// A name that differs between namespaces, without the slash that all begin with: `ego/core_acc`.
std::string unique_name(const std::string & fully_qualified_name);

/// A status without values.
diagnostic_msgs::msg::DiagnosticStatus made_status(
  uint8_t level, const std::string & node, const std::string & what, const std::string & message);

void add_text(
  diagnostic_msgs::msg::DiagnosticStatus & status, const std::string & key,
  const std::string & value);

template<typename NumberT>
void add_value(
  diagnostic_msgs::msg::DiagnosticStatus & status, const std::string & key, NumberT value)
{
  add_text(status, key, std::to_string(value));
}

/// The state of an error, numbered as in every core.
enum class ErrorState : uint8_t {NOT_TESTED, PASSED, PREFAILED, FAILED, HEALING};

/// Reported state of an error.
struct ErrorReport
{
  const char * name;
  const char * message;  // while it has failed
  uint8_t failed_level;
  ErrorState state;
  bool is_confirmed;
  uint16_t occurrences;
  uint16_t ignition_cycles;
};

diagnostic_msgs::msg::DiagnosticStatus error_status(
  const std::string & node, const ErrorReport & report);

/// Times between laps, in ns.
class Stopwatch
{
public:
  /// The time since the lap before, or since the beginning.
  uint64_t lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const auto elapsed = std::chrono::duration_cast<std::chrono::nanoseconds>(now - last_);
    last_ = now;
    return static_cast<uint64_t>(elapsed.count());
  }

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Reported counts of a call, with times in ns.
struct CallReport
{
  uint64_t steps = 0;
  uint64_t missed = 0;
  uint64_t dropped = 0;
  bool is_late = false;  // whether releases were missed lately
  bool is_excluded = false;  // whether the mode excludes it
  uint64_t adapter = 0;  // the last one
  uint64_t logic = 0;
  uint64_t longest_adapter = 0;
  uint64_t longest_logic = 0;
};

diagnostic_msgs::msg::DiagnosticStatus call_status(
  const std::string & node, const char * call, const CallReport & report);

/// How often a call has run, and how long it took.
class CallTimes
{
public:
  void add(uint64_t adapter, uint64_t logic);
  CallReport report(uint64_t missed, uint64_t dropped);

private:
  CallReport last_;
  Recent steps_;
  Recent missed_;
  Recent dropped_;
};

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__DIAGNOSTICS_HPP_
