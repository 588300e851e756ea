// Values between messages and the core: numbers as they are, arrays element by element, texts of
// enumerations by their names. Structs have their own specializations.

#ifndef PACKAGE_GUARD__VALUES_HPP_
#define PACKAGE_GUARD__VALUES_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace PACKAGE_NAME
{

template<typename FromT, typename ToT>
struct Copy
{
  static void run(const FromT & from, ToT & to) {to = static_cast<ToT>(from);}
};

template<typename FromT, typename ToT>
void assign(const FromT & from, ToT & to)
{
  Copy<FromT, ToT>::run(from, to);
}

template<typename FromT, typename ToT, std::size_t size>
struct Copy<std::array<FromT, size>, ToT[size]>
{
  static void run(const std::array<FromT, size> & from, ToT (& to)[size])
  {
    for (std::size_t i = 0; i < size; ++i) {
      assign(from[i], to[i]);
    }
  }
};

template<typename FromT, typename ToT, std::size_t size>
struct Copy<FromT[size], std::array<ToT, size>>
{
  static void run(const FromT (& from)[size], std::array<ToT, size> & to)
  {
    for (std::size_t i = 0; i < size; ++i) {
      assign(from[i], to[i]);
    }
  }
};

/// A value of an enumeration: its text in messages and its number in the core.
struct Symbol
{
  const char * text;
  int64_t number;
};

/// The text of a number; none of a number that has no name.
template<std::size_t count>
std::string symbol_text(const Symbol (& symbols)[count], int64_t number)
{
  for (const Symbol & symbol : symbols) {
    if (symbol.number == number) {
      return symbol.text;
    }
  }
  return "";
}

/// The number of a text; `unknown` of a text that is none of them.
template<std::size_t count>
int64_t symbol_number(
  const Symbol (& symbols)[count], const std::string & text, int64_t unknown)
{
  for (const Symbol & symbol : symbols) {
    if (symbol.text == text) {
      return symbol.number;
    }
  }
  return unknown;
}

template<std::size_t count, typename FromT, std::size_t size>
void assign_texts(
  const Symbol (& symbols)[count], const FromT (& from)[size], std::array<std::string, size> & to)
{
  for (std::size_t i = 0; i < size; ++i) {
    to[i] = symbol_text(symbols, static_cast<int64_t>(from[i]));
  }
}

template<std::size_t count, typename ToT, std::size_t size>
void assign_numbers(
  const Symbol (& symbols)[count], const std::array<std::string, size> & from, ToT (& to)[size],
  int64_t unknown)
{
  for (std::size_t i = 0; i < size; ++i) {
    to[i] = static_cast<ToT>(symbol_number(symbols, from[i], unknown));
  }
}

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__VALUES_HPP_
