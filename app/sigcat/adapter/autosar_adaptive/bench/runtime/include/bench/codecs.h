// How values of every kind become bytes: included by the generated codecs.cpp alone.
#ifndef BENCH_CODECS_H_
#define BENCH_CODECS_H_

#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ara/core/array.h"
#include "bench/codec.h"
#include "bench/reader.h"
#include "bench/writer.h"

namespace bench {

// Members of a struct, in order. The generated code has the one of each struct.
template <typename T>
struct Members;

// Whether a struct is the arguments of a message, which have no length before them.
template <typename T>
struct IsArguments : std::false_type {};

// An unsigned integer that has the bits of a number.
template <std::size_t Width>
struct BitsOf;
template <>
struct BitsOf<4> {
    using type = std::uint32_t;
};
template <>
struct BitsOf<8> {
    using type = std::uint64_t;
};

template <typename T, typename = void>
struct Form {  // a struct
    static std::size_t Width(const Serialization& settings) {
        return IsArguments<T>::value ? 0 : settings.struct_length;
    }
    static void Write(Writer& writer, const T& value) {
        const auto width = Width(writer.Settings());
        const auto begin = writer.BeginLength(width);
        Members<T>::ForEach([&writer](const auto& each) { Form<std::decay_t<decltype(each)>>::Write(writer, each); },
                            value);
        writer.EndLength(begin, width);
    }
    static void Read(Reader& reader, T& value) {
        const auto part = reader.Begin(Width(reader.Settings()));
        Members<T>::ForEach([&reader](auto& each) { Form<std::decay_t<decltype(each)>>::Read(reader, each); }, value);
        reader.End(part);
    }
};

template <typename T>
struct Form<T, std::enable_if_t<std::is_integral_v<T>>> {
    static void Write(Writer& writer, T value) {
        writer.Integer(static_cast<std::uint64_t>(value), sizeof(T));
    }
    static void Read(Reader& reader, T& value) { value = static_cast<T>(reader.Integer(sizeof(T))); }
};

template <>
struct Form<bool> {
    static void Write(Writer& writer, bool value) { writer.Integer(value ? 1 : 0, 1); }
    // Only the lowest bit counts.
    static void Read(Reader& reader, bool& value) { value = (reader.Integer(1) & 1U) != 0; }
};

template <typename T>
struct Form<T, std::enable_if_t<std::is_enum_v<T>>> {
    using Held = std::underlying_type_t<T>;
    static void Write(Writer& writer, T value) { Form<Held>::Write(writer, static_cast<Held>(value)); }
    static void Read(Reader& reader, T& value) {
        Held held{};
        Form<Held>::Read(reader, held);
        value = static_cast<T>(held);
    }
};

template <typename T>
struct Form<T, std::enable_if_t<std::is_floating_point_v<T>>> {
    using Bits = typename BitsOf<sizeof(T)>::type;
    static void Write(Writer& writer, T value) {
        Bits bits;
        std::memcpy(&bits, &value, sizeof bits);
        writer.Integer(bits, sizeof bits);
    }
    static void Read(Reader& reader, T& value) {
        const auto bits = static_cast<Bits>(reader.Integer(sizeof(Bits)));
        std::memcpy(&value, &bits, sizeof bits);
    }
};

template <>
struct Form<std::string> {
    static void Write(Writer& writer, const std::string& value) { writer.Text(value); }
    static void Read(Reader& reader, std::string& value) { value = reader.Text(); }
};

template <typename T, std::size_t N>
struct Form<std::array<T, N>> {
    static void Write(Writer& writer, const std::array<T, N>& value) {
        const std::size_t width = writer.Settings().array_length;
        const auto begin = writer.BeginLength(width);
        for (const auto& each : value) {
            Form<T>::Write(writer, each);
        }
        writer.EndLength(begin, width);
    }
    static void Read(Reader& reader, std::array<T, N>& value) {
        const auto part = reader.Begin(reader.Settings().array_length);
        for (auto& each : value) {
            Form<T>::Read(reader, each);
        }
        reader.End(part);
    }
};

template <typename T>
struct Form<std::vector<T>> {
    static void Write(Writer& writer, const std::vector<T>& value) {
        const std::size_t width = writer.Settings().array_length;
        const auto begin = writer.BeginLength(width);
        for (const T& each : value) {
            Form<T>::Write(writer, each);
        }
        writer.EndLength(begin, width);
        writer.EndOpen();
    }
    static void Read(Reader& reader, std::vector<T>& value) {
        const auto part = reader.Begin(reader.Settings().array_length);
        while (reader.IsBefore(part)) {
            const auto at = reader.At();
            T each{};
            Form<T>::Read(reader, each);
            if (reader.At() == at) {  // bytes that no element takes
                reader.Fail();
            }
            value.push_back(std::move(each));
        }
        reader.End(part);
        reader.EndOpen();
    }
};

template <typename T>
void Codec<T>::Write(Writer& writer, const T& value) {
    Form<T>::Write(writer, value);
}

template <typename T>
void Codec<T>::Read(Reader& reader, T& value) {
    Form<T>::Read(reader, value);
}

}  // namespace bench

#endif  // BENCH_CODECS_H_
