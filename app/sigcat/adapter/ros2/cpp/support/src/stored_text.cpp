#include "PACKAGE_NAME/stored_text.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace PACKAGE_NAME
{

namespace
{

constexpr char kFirstLine[] = "sigcat 1";

template<typename NumberT>
std::string shortest(NumberT value)
{
  char text[64];
  const auto end = std::to_chars(text, text + sizeof(text), value);
  return std::string(text, end.ptr);
}

template<typename NumberT>
bool read_integer(const std::string & text, NumberT & value)
{
  NumberT found{};
  const auto end = std::from_chars(text.data(), text.data() + text.size(), found);
  const bool is_good = end.ec == std::errc() && shortest(found) == text;  // no -0, no 007
  value = is_good ? found : value;
  return is_good;
}

/// Whether a text is a number such as 12, -0.5 or 1e-07.
bool is_decimal(const std::string & text)
{
  const char * at = text.c_str();
  const auto has_digits = [&at] {
      const char * const first = at;
      while (*at >= '0' && *at <= '9') {
        ++at;
      }
      return at != first;
    };
  at += *at == '-' ? 1 : 0;
  bool is_good = has_digits();
  if (*at == '.') {
    ++at;
    is_good = has_digits() && is_good;
  }
  if (*at == 'e') {
    ++at;
    at += *at == '-' || *at == '+' ? 1 : 0;
    is_good = has_digits() && is_good;
  }
  return is_good && at == text.c_str() + text.size();
}

}  // namespace

std::optional<StoredValues> parse_stored(const std::string & text)
{
  std::istringstream lines(text);
  std::string line;
  StoredValues values;
  if (!std::getline(lines, line) || lines.eof() || line != kFirstLine) {
    return std::nullopt;
  }
  while (std::getline(lines, line)) {
    const std::size_t colon = line.find(": ");
    const bool is_whole = !lines.eof();  // each line has an end
    if (!is_whole || colon == std::string::npos || colon == 0 ||
      !values.emplace(line.substr(0, colon), line.substr(colon + 2)).second)
    {
      return std::nullopt;
    }
  }
  return values;
}

std::string stored_text(const StoredValues & values)
{
  std::string text = std::string(kFirstLine) + "\n";
  for (const auto & value : values) {
    text += value.first + ": " + value.second + "\n";
  }
  return text;
}

std::vector<std::string> words_of(const std::string & text)
{
  std::vector<std::string> words(1);
  for (const char each : text) {
    if (each == ' ') {
      words.emplace_back();
    } else {
      words.back() += each;
    }
  }
  return words;
}

std::string text_of(bool value) {return value ? "true" : "false";}

std::string text_of(float value)
{
  const std::string text = shortest(value);
  float read = 0.0F;
  read_text(text, read);
  // Rounded twice when it is read, a text can be too short.
  return read == value ? text : shortest(static_cast<double>(value));
}

std::string text_of(double value) {return shortest(value);}
std::string text_of(int64_t value) {return shortest(value);}
std::string text_of(uint64_t value) {return shortest(value);}

bool read_text(const std::string & text, bool & value)
{
  value = text == "true" || (text != "false" && value);
  return text == "true" || text == "false";
}

bool read_text(const std::string & text, float & value)
{
  double found = 0.0;
  if (!read_text(text, found)) {
    return false;
  }
  const float rounded = static_cast<float>(found);
  const bool is_good = !std::isinf(rounded) || std::isinf(found);
  value = is_good ? rounded : value;
  return is_good;
}

bool read_text(const std::string & text, double & value)
{
  const bool is_negative = text[0] == '-';
  const std::string name = text.substr(is_negative ? 1 : 0);
  if (name == "inf" || name == "nan") {
    const double found = name == "inf" ?
      std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    value = is_negative ? -found : found;
    return true;
  }
  // std::from_chars of gcc 11 refuses what is almost 0; std::strtod heeds the locale.
  std::istringstream input(text);
  input.imbue(std::locale::classic());
  double found = 0.0;
  const bool is_good = is_decimal(text) && input >> found;
  value = is_good ? found : value;
  return is_good;
}

bool read_text(const std::string & text, int8_t & value) {return read_integer(text, value);}
bool read_text(const std::string & text, int16_t & value) {return read_integer(text, value);}
bool read_text(const std::string & text, int32_t & value) {return read_integer(text, value);}
bool read_text(const std::string & text, int64_t & value) {return read_integer(text, value);}
bool read_text(const std::string & text, uint8_t & value) {return read_integer(text, value);}
bool read_text(const std::string & text, uint16_t & value) {return read_integer(text, value);}
bool read_text(const std::string & text, uint32_t & value) {return read_integer(text, value);}
bool read_text(const std::string & text, uint64_t & value) {return read_integer(text, value);}

}  // namespace PACKAGE_NAME
