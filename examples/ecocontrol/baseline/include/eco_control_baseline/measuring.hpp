// Only for the comparison: durations of calls, written to the folder in SIGCAT_MARKS.

#ifndef ECO_CONTROL_BASELINE__MEASURING_HPP_
#define ECO_CONTROL_BASELINE__MEASURING_HPP_

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace eco_control_baseline
{

class Measuring
{
public:
  explicit Measuring(const std::string & function)
  {
    if (const char * folder = std::getenv("SIGCAT_MARKS")) {
      const std::string name = std::string(folder) + "/" + function + "." + std::to_string(getpid());
      file_ = std::fopen(name.c_str(), "wb");
    }
  }

  ~Measuring()
  {
    if (file_ != nullptr) {
      std::fclose(file_);
    }
  }

  Measuring(const Measuring &) = delete;
  Measuring & operator=(const Measuring &) = delete;

  // 0: inputs are taken; 1: the function is called; 2: it has returned; 3: outputs are taken.
  void at(unsigned point, uint64_t now)
  {
    if (point == 0U) {
      preemptions_ = preemptions();
    }
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    record_.at[point] = static_cast<uint64_t>(std::chrono::nanoseconds(time).count());
    record_.now = now;
    if (point == 3U && file_ != nullptr) {
      record_.call = CALL | (preemptions() != preemptions_ ? PREEMPTED : 0U);
      std::fwrite(&record_, sizeof(record_), 1, file_);
    }
  }

private:
  static constexpr uint32_t CALL = 1;
  static constexpr uint32_t PREEMPTED = 0x80000000U;  // the thread was preempted meanwhile

  static long preemptions()
  {
    rusage usage{};
    return getrusage(RUSAGE_THREAD, &usage) == 0 ? usage.ru_nivcsw : 0;
  }

  struct Record
  {
    uint64_t now;
    uint64_t at[4];
    uint32_t call;
    uint32_t reactions;
  };

  Record record_{0, {0, 0, 0, 0}, CALL, 0};
  long preemptions_ = 0;
  std::FILE * file_ = nullptr;
};

}  // namespace eco_control_baseline

#endif  // ECO_CONTROL_BASELINE__MEASURING_HPP_
