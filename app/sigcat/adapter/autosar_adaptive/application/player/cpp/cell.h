// Values as text: of a normalized trace, and of a recording.

#ifndef PLAYER_CELL_H
#define PLAYER_CELL_H

#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ara/core/array.h"

namespace player {

/// A name as JSON has it: no name has a quote.
inline std::string Quoted(const std::string& name) { return '"' + name + '"'; }

/// The words of a cell, one after the other: numbers, and names of booleans and enumerations.
class Words final {
public:
    explicit Words(const std::string& cell) : words_{cell} {}

    bool IsOver() const { return is_over_; }

    /// Throws std::runtime_error if there is none.
    std::string Next() {
        std::string word;
        if (is_over_ || !std::getline(words_, word, ';')) {
            throw std::runtime_error{"a value is missing."};
        }
        is_over_ = words_.eof();
        return word;
    }

private:
    std::istringstream words_;
    bool is_over_{false};
};

/// Throws std::runtime_error if a word is not a number that fits.
template <typename T>
T NumberOf(const std::string& word) {
    const char* const text = word.c_str();
    char* end = nullptr;
    T value{};
    bool is_right = true;
    errno = 0;
    if constexpr (std::is_floating_point<T>::value) {
        value = static_cast<T>(std::is_same<T, float>::value ? std::strtof(text, &end) : std::strtod(text, &end));
        is_right = errno == 0 || !std::isinf(value);  // small numbers are reported, too
    } else if constexpr (std::is_signed<T>::value) {
        const long long wide = std::strtoll(text, &end, 10);
        value = static_cast<T>(wide);
        is_right = errno == 0 && value == wide;
    } else {
        const unsigned long long wide = std::strtoull(text, &end, 10);
        value = static_cast<T>(wide);
        is_right = errno == 0 && value == wide && *text != '-';
    }
    if (word.empty() || *text == ' ' || *end != '\0' || !is_right) {
        throw std::runtime_error{Quoted(word) + " is not a value of its datatype."};
    }
    return value;
}

/// Names and numbers of an enumeration.
template <typename Enumeration>
struct Symbols final {
    using Names = std::vector<std::pair<const char*, std::int64_t>>;
    static const Names& All();
};

/// A value and its text; within a list or a mapping, the text is JSON. Structs have their own specializations.
template <typename T, typename = void>
struct Cell;

template <typename T>
T Read(Words& from) {
    return Cell<T>::Read(from);
}

/// The value of a whole cell.
template <typename T>
T ReadAll(const std::string& cell) {
    Words from{cell};
    T value = Read<T>(from);
    if (!from.IsOver()) {
        throw std::runtime_error{Quoted(cell) + " has too many values."};
    }
    return value;
}

template <typename T>
std::string Text(const T& value, bool is_inner = false) {
    return Cell<T>::Text(value, is_inner);
}

/// A list of JSON.
template <typename ListT>
std::string ListText(const ListT& list) {
    std::string text = "[";
    for (std::size_t i = 0; i < list.size(); ++i) {
        text += (i > 0 ? "," : "") + player::Text(static_cast<typename ListT::value_type>(list[i]), true);
    }
    return text + "]";
}

template <>
struct Cell<bool, void> final {
    static bool Read(Words& from) {
        const std::string word = from.Next();
        if (word != "true" && word != "false") {
            throw std::runtime_error{Quoted(word) + " is not true or false."};
        }
        return word == "true";
    }
    static std::string Text(bool value, bool /* is_inner */) { return value ? "true" : "false"; }
};

template <typename T>
struct Cell<T, std::enable_if_t<std::is_integral<T>::value>> final {
    static T Read(Words& from) { return NumberOf<T>(from.Next()); }
    static std::string Text(T value, bool /* is_inner */) { return std::to_string(value); }
};

/// As many digits as tell every number from the next.
template <typename T>
struct Cell<T, std::enable_if_t<std::is_floating_point<T>::value>> final {
    static T Read(Words& from) { return NumberOf<T>(from.Next()); }
    static std::string Text(T value, bool is_inner) {
        if (std::isnan(value)) {
            return is_inner ? "NaN" : "nan";
        }
        if (std::isinf(value)) {
            return std::string{value < 0 ? "-" : ""} + (is_inner ? "Infinity" : "inf");
        }
        char text[40];
        std::snprintf(text, sizeof text, "%.*g", std::is_same<T, float>::value ? 9 : 17, static_cast<double>(value));
        return text;
    }
};

template <typename T>
struct Cell<T, std::enable_if_t<std::is_enum<T>::value>> final {
    static T Read(Words& from) {
        const std::string word = from.Next();
        for (const auto& symbol : Symbols<T>::All()) {
            if (word == symbol.first) {
                return static_cast<T>(symbol.second);
            }
        }
        return static_cast<T>(NumberOf<std::underlying_type_t<T>>(word));
    }
    static std::string Text(T value, bool is_inner) {
        for (const auto& symbol : Symbols<T>::All()) {
            if (symbol.second == static_cast<std::int64_t>(value)) {
                return is_inner ? Quoted(symbol.first) : symbol.first;
            }
        }
        return std::to_string(static_cast<std::int64_t>(value));
    }
};

template <typename T, std::size_t size>
struct Cell<ara::core::Array<T, size>, void> final {
    static ara::core::Array<T, size> Read(Words& from) {
        ara::core::Array<T, size> value{};
        for (std::size_t i = 0; i < size; ++i) {
            value[i] = player::Read<T>(from);
        }
        return value;
    }
    static std::string Text(const ara::core::Array<T, size>& value, bool /* is_inner */) { return ListText(value); }
};

}  // namespace player

#endif  // PLAYER_CELL_H
