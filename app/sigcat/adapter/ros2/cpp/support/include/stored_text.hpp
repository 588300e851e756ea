// What a node keeps, as text: a first line that names the format, then lines of `key: value`.
// A value is a flag, a number or numbers with a space between, and is written in one way only.

#ifndef PACKAGE_GUARD__STORED_TEXT_HPP_
#define PACKAGE_GUARD__STORED_TEXT_HPP_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace PACKAGE_NAME
{

/// Texts of values, by key.
using StoredValues = std::map<std::string, std::string>;

/// Nothing if the text is not whole, or none that a node has written.
std::optional<StoredValues> parse_stored(const std::string & text);

std::string stored_text(const StoredValues & values);

/// The parts of a text between its spaces.
std::vector<std::string> words_of(const std::string & text);

/// Values as text: the shortest that reads back the same.
std::string text_of(bool value);
std::string text_of(float value);
std::string text_of(double value);
std::string text_of(int64_t value);
std::string text_of(uint64_t value);

inline std::string text_of(int8_t value) {return text_of(static_cast<int64_t>(value));}
inline std::string text_of(int16_t value) {return text_of(static_cast<int64_t>(value));}
inline std::string text_of(int32_t value) {return text_of(static_cast<int64_t>(value));}
inline std::string text_of(uint8_t value) {return text_of(static_cast<uint64_t>(value));}
inline std::string text_of(uint16_t value) {return text_of(static_cast<uint64_t>(value));}
inline std::string text_of(uint32_t value) {return text_of(static_cast<uint64_t>(value));}

template<typename ElementT, std::size_t size>
std::string text_of(const ElementT (& values)[size])
{
  std::string text;
  for (const ElementT & value : values) {
    text += (text.empty() ? "" : " ") + text_of(value);
  }
  return text;
}

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

/// False if it is not as many values; those before the first wrong one are taken.
template<typename ElementT, std::size_t size>
bool read_text(const std::string & text, ElementT (& values)[size])
{
  const std::vector<std::string> words = words_of(text);
  bool is_good = words.size() == size;
  for (std::size_t i = 0; is_good && i < size; ++i) {
    is_good = read_text(words[i], values[i]);
  }
  return is_good;
}

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__STORED_TEXT_HPP_
