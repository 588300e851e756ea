// Writes a track as bytes, by the settings that its arguments are: big endian, alignment, lengths of array, text and struct, UTF-16.
// Then reads the bytes that the lines of its input are, and tells what they say.
#include <cstdint>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

#include "bench/reader.h"
#include "bench/writer.h"
#include "probe/demo/impl_type_track_t.h"

namespace {

using probe::demo::Mode_T;
using probe::demo::Track_T;

std::uint8_t Number(const char* text) { return static_cast<std::uint8_t>(std::atoi(text)); }

std::string Hex(const bench::Bytes& bytes) {
    std::ostringstream text;
    for (const unsigned byte : bytes) {
        text << std::hex << std::setw(2) << std::setfill('0') << byte;
    }
    return text.str();
}

bench::Bytes Parsed(const std::string& hex) {
    bench::Bytes bytes;
    for (std::size_t at = 0; at + 1 < hex.size(); at += 2) {
        bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(at, 2), nullptr, 16)));
    }
    return bytes;
}

void Read(const std::string& hex, const bench::Serialization& settings) {
    const auto bytes = Parsed(hex);
    bench::Reader reader{bytes, settings};
    Track_T track{};
    bench::Codec<Track_T>::Read(reader, track);
    if (!reader.IsValid()) {
        std::cout << "malformed" << std::endl;
        return;
    }
    std::cout << track.name << ' ' << static_cast<int>(track.mode);
    for (const auto corner : track.corners) {
        std::cout << ' ' << corner;
    }
    for (const bool flag : track.flags) {
        std::cout << (flag ? " yes" : " no");
    }
    std::cout << ' ' << track.distance << std::endl;
}

}  // namespace

int main(int, char** arguments) {
    const bench::Serialization settings{Number(arguments[1]) != 0, Number(arguments[2]), Number(arguments[3]),
                                        Number(arguments[4]),      Number(arguments[5]), Number(arguments[6]) != 0};
    bench::Writer writer{settings};
    bench::Codec<Track_T>::Write(writer, Track_T{arguments[7], Mode_T::ON, {1, -2, 3, -4}, {true, false}, 0.5});
    std::cout << Hex(writer.Payload()) << std::endl;
    for (std::string line; std::getline(std::cin, line) && line != "quit";) {
        Read(line, settings);
    }
    return 0;
}
