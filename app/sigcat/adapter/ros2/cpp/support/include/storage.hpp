// What a node keeps from one run to the next: a file of `key: value` lines, written whole or not
// at all.

#ifndef PACKAGE_GUARD__STORAGE_HPP_
#define PACKAGE_GUARD__STORAGE_HPP_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "rclcpp/rclcpp.hpp"

namespace PACKAGE_NAME
{

/// The file of a node in a folder; an empty one is $ROS_HOME/PACKAGE_NAME, or ~/.ros/PACKAGE_NAME.
std::filesystem::path storage_file(const std::string & folder, const std::string & node);

/// Values as text: the shortest that reads back the same.
std::string text_of(bool value);
std::string text_of(float value);
std::string text_of(double value);
std::string text_of(int64_t value);
std::string text_of(uint64_t value);

/// False, and the value as it was, if the text is none of its type.
bool read_text(const std::string & text, bool & value);
bool read_text(const std::string & text, float & value);
bool read_text(const std::string & text, double & value);
bool read_text(const std::string & text, int8_t & value);
bool read_text(const std::string & text, int16_t & value);
bool read_text(const std::string & text, int32_t & value);
bool read_text(const std::string & text, int64_t & value);
bool read_text(const std::string & text, uint8_t & value);
bool read_text(const std::string & text, uint16_t & value);
bool read_text(const std::string & text, uint32_t & value);
bool read_text(const std::string & text, uint64_t & value);

inline std::string text_of(int8_t value) {return text_of(static_cast<int64_t>(value));}
inline std::string text_of(int16_t value) {return text_of(static_cast<int64_t>(value));}
inline std::string text_of(int32_t value) {return text_of(static_cast<int64_t>(value));}
inline std::string text_of(uint8_t value) {return text_of(static_cast<uint64_t>(value));}
inline std::string text_of(uint16_t value) {return text_of(static_cast<uint64_t>(value));}
inline std::string text_of(uint32_t value) {return text_of(static_cast<uint64_t>(value));}

class Storage
{
public:
  Storage(std::filesystem::path file, rclcpp::Logger logger);

  /// Reads the file. A broken one is kept beside as `.broken`.
  void load();

  /// Whether all that was read could be read. Otherwise nothing of it should be used.
  bool is_good() const {return is_good_;}

  /// Puts a broken file aside.
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

  template<typename ElementT, std::size_t size>
  bool read(const std::string & key, ElementT (& values)[size])
  {
    const auto found = values_.find(key);
    if (found == values_.end()) {
      return false;
    }
    std::istringstream words(found->second);
    std::string word;
    for (ElementT & value : values) {
      is_good_ = (words >> word) && read_text(word, value) && is_good_;
    }
    is_good_ = !(words >> word) && is_good_;
    return is_good_;
  }

  template<typename ValueT>
  void write(const std::string & key, const ValueT & value)
  {
    values_[key] = text_of(value);
  }

  template<typename ElementT, std::size_t size>
  void write(const std::string & key, const ElementT (& values)[size])
  {
    std::string text;
    for (const ElementT & value : values) {
      text += (text.empty() ? "" : " ") + text_of(value);
    }
    values_[key] = text;
  }

  /// The counts of an error, each under a key of its own.
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
  bool parse(const std::string & line);

  std::filesystem::path file_;
  rclcpp::Logger logger_;
  std::map<std::string, std::string> values_;
  bool is_good_ = true;
};

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__STORAGE_HPP_
