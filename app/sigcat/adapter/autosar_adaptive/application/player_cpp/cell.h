// Values as text: cells of a trace, and of a recording.

#ifndef PLAYER_CELL_H
#define PLAYER_CELL_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ara/core/array.h"

namespace player {

/// A text, or a list, or a mapping: what a cell holds.
struct Item final {
    std::string text;
    std::vector<Item> items;
    std::vector<std::string> keys;

    /// The item under a key of a mapping. Throws std::runtime_error if there is none.
    const Item& At(const std::string& key) const;
};

/// Throws std::runtime_error if a list or mapping is not closed.
Item Parsed(const std::string& cell);

/// Names and numbers of an enumeration.
template <typename Enumeration>
struct Symbols final {
    using Names = std::vector<std::pair<const char*, std::int64_t>>;
    static const Names& All();
};

/// A value and its text. Structs have their own specializations.
template <typename T, typename = void>
struct Cell;

template <typename T>
T Read(const Item& item) {
    return Cell<T>::Read(item);
}

template <typename T>
std::string Text(const T& value) {
    return Cell<T>::Text(value);
}

template <>
struct Cell<bool, void> final {
    static bool Read(const Item& item) { return item.text == "true" || item.text == "1"; }
    static std::string Text(bool value) { return value ? "true" : "false"; }
};

template <typename T>
struct Cell<T, std::enable_if_t<std::is_integral<T>::value>> final {
    static T Read(const Item& item) {
        return std::is_signed<T>::value ? static_cast<T>(std::strtoll(item.text.c_str(), nullptr, 0))
                                        : static_cast<T>(std::strtoull(item.text.c_str(), nullptr, 0));
    }
    static std::string Text(T value) { return std::to_string(value); }
};

/// As many digits as tell every number from the next.
template <typename T>
struct Cell<T, std::enable_if_t<std::is_floating_point<T>::value>> final {
    static T Read(const Item& item) {
        return std::is_same<T, float>::value ? static_cast<T>(std::strtof(item.text.c_str(), nullptr))
                                             : static_cast<T>(std::strtod(item.text.c_str(), nullptr));
    }
    static std::string Text(T value) {
        char text[40];
        std::snprintf(text, sizeof text, "%.*g", std::is_same<T, float>::value ? 9 : 17, static_cast<double>(value));
        return text;
    }
};

template <typename T>
struct Cell<T, std::enable_if_t<std::is_enum<T>::value>> final {
    static T Read(const Item& item) {
        for (const auto& symbol : Symbols<T>::All()) {
            if (item.text == symbol.first) {
                return static_cast<T>(symbol.second);
            }
        }
        return static_cast<T>(std::strtoll(item.text.c_str(), nullptr, 0));
    }
    static std::string Text(T value) {
        for (const auto& symbol : Symbols<T>::All()) {
            if (symbol.second == static_cast<std::int64_t>(value)) {
                return symbol.first;
            }
        }
        return std::to_string(static_cast<std::int64_t>(value));
    }
};

template <typename T, std::size_t size>
struct Cell<ara::core::Array<T, size>, void> final {
    static ara::core::Array<T, size> Read(const Item& item) {
        if (item.items.size() != size) {
            throw std::runtime_error{"A list must have " + std::to_string(size) + " elements."};
        }
        ara::core::Array<T, size> value{};
        for (std::size_t i = 0; i < size; ++i) {
            value[i] = player::Read<T>(item.items[i]);
        }
        return value;
    }
    static std::string Text(const ara::core::Array<T, size>& value) {
        std::string text = "[";
        for (std::size_t i = 0; i < size; ++i) {
            text += (i > 0 ? "," : "") + player::Text(value[i]);
        }
        return text + "]";
    }
};

}  // namespace player

#endif  // PLAYER_CELL_H
