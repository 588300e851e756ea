#ifndef WIPER_HPP
#define WIPER_HPP

#include <array>
#include <cstdint>

namespace body {

enum class Speed : std::uint8_t { Off = 0, Slow = 2, Fast = 5 };

class Wiper final {
 public:
  struct In {
    std::uint16_t rain;                   // % 2^-4
    Speed wanted;
    std::array<std::int16_t, 3> torque;
  } in{};
  struct Out {
    Speed speed;
  } out{};

  void initialize() { out = Out{}; }
  void step() { out.speed = in.wanted; count(); }
  void terminate() {}
  bool selfTest();
  std::uint16_t getRain() const { return in.rain; }

 private:
  void count();
};

}  // namespace body

#endif
