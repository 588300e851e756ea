// Protects and checks what the lines of its input say, as the bench does with events.
//
// protect PROFILE ID COUNTER HEADER VALUES  prints the protected message, after the length in its header, and the next counter
// check PROFILE ID MOST HEADER PAYLOAD      prints the status; the lines of one profile are one event's
#include <iostream>
#include <map>
#include <string>

#include "e2e/protection.h"
#include "someip/big_endian.h"

namespace {

using bench::Bytes;

Bytes FromHex(const std::string& text) {
    Bytes bytes;
    for (std::size_t n = 0; n + 1 < text.size(); n += 2) {
        bytes.push_back(static_cast<std::uint8_t>(std::stoul(text.substr(n, 2), nullptr, 16)));
    }
    return bytes;
}

void PrintHex(const Bytes& bytes) {
    static constexpr char kDigits[] = "0123456789abcdef";
    for (const auto byte : bytes) {
        std::cout << kDigits[byte >> 4] << kDigits[byte & 15];
    }
}

bench::Header HeaderOf(const Bytes& bytes) {
    return {0,        0,        bench::ShortAt(bytes, 0), bench::ShortAt(bytes, 2), bytes[4],
            bytes[5], bytes[6], static_cast<bench::ReturnCode>(bytes[7])};
}

}  // namespace

int main() {
    std::map<unsigned, bench::Checker> checkers;
    std::string word, header, data;
    unsigned profile = 0;
    std::uint32_t id = 0;
    std::uint32_t number = 0;
    while (std::cin >> word >> profile >> id >> number >> header >> data) {
        const bench::Protection protection{static_cast<std::uint8_t>(profile), id, number};
        const Bytes bytes = FromHex(data.substr(1));  // after a dot, as there may be none
        if (word == "protect") {
            std::uint32_t counter = number;
            PrintHex(bench::Protected(protection, counter, HeaderOf(FromHex(header)), bytes));
            std::cout << ' ' << counter << std::endl;
        } else {
            auto& checker = checkers.try_emplace(profile, protection).first->second;
            std::cout << static_cast<int>(checker.Check(HeaderOf(FromHex(header)), bytes)) << std::endl;
        }
    }
}
