// What the nodes in C++ read and write, for the test: one request, and one answer on standard output.
//   parse < FILE            the file as it would be written, or exit code 1
//   read DATATYPE < TEXT    the value, as %a or a whole number, or exit code 1; `float[3]` are three of them
//   write DATATYPE < VALUE  its text

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <string>

#include "full/stored_text.hpp"

namespace
{

void show(bool value) {std::printf("%s ", value ? "true" : "false");}
void show(float value) {std::printf("%a ", static_cast<double>(value));}
void show(double value) {std::printf("%a ", value);}
void show(uint64_t value) {std::printf("%" PRIu64 " ", value);}
template<typename IntegerT>
void show(IntegerT value) {std::printf("%" PRId64 " ", static_cast<int64_t>(value));}

template<typename ValueT>
bool read_one(const std::string & text)
{
  ValueT value{};
  const bool is_good = full::read_text(text, value);
  if (is_good) {
    show(value);
  }
  return is_good;
}

bool read_three(const std::string & text)
{
  float values[3] = {};
  const bool is_good = full::read_text(text, values);
  for (const float value : values) {
    show(value);
  }
  return is_good;
}

const std::map<std::string, std::function<bool (const std::string &)>> kReaders = {
  {"_Bool", read_one<bool>}, {"float", read_one<float>}, {"double", read_one<double>},
  {"int8_t", read_one<int8_t>}, {"int16_t", read_one<int16_t>}, {"int32_t", read_one<int32_t>},
  {"int64_t", read_one<int64_t>}, {"uint8_t", read_one<uint8_t>}, {"uint16_t", read_one<uint16_t>},
  {"uint32_t", read_one<uint32_t>}, {"uint64_t", read_one<uint64_t>}, {"float[3]", read_three}};

bool parse(const std::string & text)
{
  const auto values = full::parse_stored(text);
  std::cout << (values ? full::stored_text(*values) : "");
  return values.has_value();
}

bool write(const std::string & datatype, const std::string & text)
{
  const double value = std::strtod(text.c_str(), nullptr);
  std::cout << (datatype == "float" ? full::text_of(static_cast<float>(value)) : full::text_of(value));
  return true;
}

}  // namespace

int main(int count, char ** arguments)
{
  const std::string text((std::istreambuf_iterator<char>(std::cin)), std::istreambuf_iterator<char>());
  const std::string asked = arguments[1], datatype = count > 2 ? arguments[2] : "";
  const bool is_good = asked == "parse" ? parse(text) :
    asked == "read" ? kReaders.at(datatype)(text) : write(datatype, text);
  return is_good ? 0 : 1;
}
