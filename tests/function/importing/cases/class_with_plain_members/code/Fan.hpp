#pragma once
#include <cstdint>
class Fan {
 public:
  float level;
  struct In { float temp; } in;
  struct Out { float flow; } out;
  void initialize();
  void step();
  int unused;
  int counter_;
 private:
  float state_;
};
