// Values between the platform and the core: numbers as they are, enumerations as their numbers, arrays element by
// element. Structs have their own specializations.

#ifndef APPLICATION_VALUES_H
#define APPLICATION_VALUES_H

#include <cstddef>

#include "ara/core/array.h"

namespace application {

template <typename From, typename To>
struct Copy final {
    static void Run(const From& from, To& to) { to = static_cast<To>(from); }
};

template <typename From, typename To>
void Assign(const From& from, To& to) {
    Copy<From, To>::Run(from, to);
}

template <typename From, typename To, std::size_t size>
struct Copy<ara::core::Array<From, size>, To[size]> final {
    static void Run(const ara::core::Array<From, size>& from, To (&to)[size]) {
        for (std::size_t i = 0; i < size; ++i) {
            Assign(from[i], to[i]);
        }
    }
};

template <typename From, typename To, std::size_t size>
struct Copy<From[size], ara::core::Array<To, size>> final {
    static void Run(const From (&from)[size], ara::core::Array<To, size>& to) {
        for (std::size_t i = 0; i < size; ++i) {
            Assign(from[i], to[i]);
        }
    }
};

}  // namespace application

#endif  // APPLICATION_VALUES_H
