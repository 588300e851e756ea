// What a node keeps from one run to the next: a file that is written whole or not at all.

#ifndef PACKAGE_GUARD__STORAGE_HPP_
#define PACKAGE_GUARD__STORAGE_HPP_

#include <cstddef>
#include <filesystem>
#include <string>

#include "PACKAGE_NAME/stored_text.hpp"
#include "rclcpp/rclcpp.hpp"

namespace PACKAGE_NAME
{

/// The file of a node in a folder; an empty one is $ROS_HOME/PACKAGE_NAME, or ~/.ros/PACKAGE_NAME.
/// Its name has the domain, unless that is 0.
std::filesystem::path storage_file(
  const std::string & folder, const std::string & node, std::size_t domain);

class Storage
{
public:
  Storage(std::filesystem::path file, rclcpp::Logger logger);

  /// Reads the file.
  void load();

  /// Whether all that was read could be read. Otherwise nothing of it should be used.
  bool is_good() const {return is_good_;}

  /// Keeps a broken file beside as `.broken`.
  void set_aside();

  /// False, and the value as it was, if nothing is stored under this key.
  template<typename ValueT>
  bool read(const std::string & key, ValueT & value)
  {
    const auto found = values_.find(key);
    if (found == values_.end()) {
      return false;
    }
    is_good_ = read_text(found->second, value) && is_good_;
    return is_good_;
  }

  template<typename ValueT>
  void write(const std::string & key, const ValueT & value)
  {
    values_[key] = text_of(value);
  }

  /// The counts of an error, each under its own key.
  template<typename CountsT>
  void read_counts(const std::string & error, CountsT & counts)
  {
    read(error + ".occurrences", counts.occurrences);
    read(error + ".ignition_cycles", counts.ignition_cycles);
    read(error + ".has_failed", counts.has_failed);
    read(error + ".is_tested", counts.is_tested);
  }

  template<typename CountsT>
  void write_counts(const std::string & error, const CountsT & counts)
  {
    write(error + ".occurrences", counts.occurrences);
    write(error + ".ignition_cycles", counts.ignition_cycles);
    write(error + ".has_failed", counts.has_failed);
    write(error + ".is_tested", counts.is_tested);
  }

  /// Writes the file, all of it or nothing. What was read before and not written since stays.
  void save();

private:
  std::filesystem::path file_;
  rclcpp::Logger logger_;
  StoredValues values_;
  bool is_good_ = true;
};

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__STORAGE_HPP_
