#include "PACKAGE_NAME/diagnostics.hpp"

#include <algorithm>
#include <string>

#include "diagnostic_msgs/msg/key_value.hpp"

namespace PACKAGE_NAME
{

using diagnostic_msgs::msg::DiagnosticStatus;

namespace
{

uint8_t level_of(const ErrorReport & report)
{
  switch (report.state) {
    case ErrorState::PASSED:
      return DiagnosticStatus::OK;
    case ErrorState::PREFAILED:
      return DiagnosticStatus::WARN;
    case ErrorState::FAILED:
    case ErrorState::HEALING:
      return report.failed_level;
    case ErrorState::NOT_TESTED:  // no fault: aggregators rank STALE as the worst
    default:
      return DiagnosticStatus::OK;
  }
}

const char * name_of(ErrorState state)
{
  switch (state) {
    case ErrorState::PASSED:
      return "PASSED";
    case ErrorState::PREFAILED:
      return "PREFAILED";
    case ErrorState::FAILED:
      return "FAILED";
    case ErrorState::HEALING:
      return "HEALING";
    case ErrorState::NOT_TESTED:
    default:
      return "NOT_TESTED";
  }
}

std::string microseconds(uint64_t nanoseconds)
{
  return std::to_string(static_cast<double>(nanoseconds) / 1000.0);
}

}  // namespace

std::string unique_name(const std::string & fully_qualified_name)
{
  return fully_qualified_name.substr(fully_qualified_name.find_first_not_of('/'));
}

DiagnosticStatus made_status(
  uint8_t level, const std::string & node, const std::string & what, const std::string & message)
{
  DiagnosticStatus status;
  status.level = level;
  status.name = node + ": " + what;
  status.message = message;
  status.hardware_id = node;
  return status;
}

void add_text(DiagnosticStatus & status, const std::string & key, const std::string & value)
{
  diagnostic_msgs::msg::KeyValue pair;
  pair.key = key;
  pair.value = value;
  status.values.push_back(pair);
}

DiagnosticStatus error_status(const std::string & node, const ErrorReport & report)
{
  const bool has_failed =
    report.state == ErrorState::FAILED || report.state == ErrorState::HEALING;
  DiagnosticStatus status = made_status(
    level_of(report), node, report.name, has_failed ? report.message : name_of(report.state));
  add_text(status, "state", name_of(report.state));
  add_text(status, "confirmed", report.is_confirmed ? "true" : "false");
  add_value(status, "occurrences", report.occurrences);
  add_value(status, "ignition cycles", report.ignition_cycles);
  return status;
}

DiagnosticStatus call_status(
  const std::string & node, const char * call, const CallReport & report)
{
  DiagnosticStatus status = made_status(
    report.is_late ? DiagnosticStatus::WARN : DiagnosticStatus::OK, node, call,
    report.is_late ? "Releases were missed." : "");
  add_value(status, "steps", report.steps);
  add_value(status, "missed", report.missed);
  add_value(status, "dropped", report.dropped);
  add_text(status, "t_adapter [us]", microseconds(report.adapter));
  add_text(status, "t_logic [us]", microseconds(report.logic));
  add_text(status, "longest t_adapter [us]", microseconds(report.longest_adapter));
  add_text(status, "longest t_logic [us]", microseconds(report.longest_logic));
  return status;
}

void CallTimes::add(uint64_t adapter, uint64_t logic)
{
  ++last_.steps;
  last_.adapter = adapter;
  last_.logic = logic;
  last_.longest_adapter = std::max(last_.longest_adapter, adapter);
  last_.longest_logic = std::max(last_.longest_logic, logic);
}

CallReport CallTimes::report(uint64_t missed, uint64_t dropped)
{
  const bool has_run = steps_.grows(last_.steps);
  last_.is_late = missed_.grows(missed);
  last_.is_excluded = dropped_.grows(dropped) && !has_run;
  last_.missed = missed;
  last_.dropped = dropped;
  return last_;
}

}  // namespace PACKAGE_NAME
