// Supervision of inputs and calls. Times are in ns.

#ifndef ECO_CONTROL_BASELINE__SUPERVISION_HPP_
#define ECO_CONTROL_BASELINE__SUPERVISION_HPP_

#include <algorithm>
#include <cstdint>
#include <optional>

namespace eco_control_baseline
{

constexpr uint64_t kMillisecond = 1000000U;

// Whether a signal has not been received for longer than a time.
class ReceptionTimeout
{
public:
  explicit ReceptionTimeout(uint64_t longest)
  : longest_(longest) {}

  void received(uint64_t now)
  {
    last_ = now;
    has_come_ = true;
    came_since_ = true;
  }

  // `entered` is when the node began to listen.
  void judge(uint64_t entered, uint64_t now)
  {
    const bool is_late = now - std::max(has_come_ ? last_ : 0U, entered) > longest_;
    is_expired_ = is_late || (is_expired_ && !came_since_);
    came_since_ = came_since_ && !is_late;
  }

  bool is_expired() const {return is_expired_;}

  // Unknown before the first value is received or missing.
  std::optional<bool> verdict() const
  {
    return has_come_ || is_expired_ ? std::optional<bool>(is_expired_) : std::nullopt;
  }

private:
  uint64_t longest_;
  uint64_t last_ = 0;
  bool has_come_ = false;
  bool came_since_ = false;
  bool is_expired_ = false;
};

// An error that is reported from when it has been present for long enough until it has been absent for long enough.
class Error
{
public:
  Error(uint64_t maturation, uint64_t healing, bool heals = true)
  : maturation_(maturation), healing_(healing), heals_(heals) {}

  void update(std::optional<bool> present, bool is_forced, uint64_t now)
  {
    if (is_forced) {
      state_ = State::kFailed;
    } else if (present.value_or(false)) {
      became_present(now);
    } else if (present.has_value()) {
      became_absent(now);
    }
  }

  bool has_failed() const {return state_ == State::kFailed || state_ == State::kHealing;}
  uint8_t told() const {return told_.value_or(0U);}

  // The status to report, if it differs from the last one.
  std::optional<uint8_t> news()
  {
    if (state_ == State::kUnknown || state_ == State::kMaturing) {
      return std::nullopt;
    }
    const uint8_t status = has_failed() ? 1U : 0U;
    if (told_ == status) {
      return std::nullopt;
    }
    told_ = status;
    return status;
  }

private:
  enum class State {kUnknown, kPassed, kMaturing, kFailed, kHealing};

  void became_present(uint64_t now)
  {
    if (state_ == State::kUnknown || state_ == State::kPassed) {
      state_ = State::kMaturing;
      since_ = now;
    }
    if (state_ == State::kHealing || (state_ == State::kMaturing && now - since_ >= maturation_)) {
      state_ = State::kFailed;
    }
  }

  void became_absent(uint64_t now)
  {
    if (state_ == State::kUnknown || state_ == State::kMaturing) {
      state_ = State::kPassed;
    } else if (state_ == State::kFailed && heals_) {
      state_ = State::kHealing;
      since_ = now;
    }
    if (state_ == State::kHealing && now - since_ >= healing_) {
      state_ = State::kPassed;
    }
  }

  uint64_t maturation_;
  uint64_t healing_;
  bool heals_;
  State state_ = State::kUnknown;
  uint64_t since_ = 0;
  std::optional<uint8_t> told_;
};

// Whether a call runs neither too rarely nor too often.
class AliveSupervision
{
public:
  AliveSupervision(uint64_t window, uint32_t fewest, uint32_t most)
  : window_(window), fewest_(fewest), most_(most) {}

  void begin(uint64_t first)
  {
    first_ = first;
    count_ = 0;
    is_bad_.reset();
  }

  void ended(uint64_t now)
  {
    close(now);
    count_ += now >= first_ ? 1U : 0U;
  }

  std::optional<bool> verdict(uint64_t now)
  {
    close(now);
    return is_bad_;
  }

private:
  void close(uint64_t now)
  {
    while (now >= first_ + window_) {
      is_bad_ = count_ < fewest_ || count_ > most_;
      count_ = 0;
      first_ += window_;
    }
  }

  uint64_t window_;
  uint32_t fewest_;
  uint32_t most_;
  uint64_t first_ = 0;
  uint32_t count_ = 0;
  std::optional<bool> is_bad_;
};

}  // namespace eco_control_baseline

#endif  // ECO_CONTROL_BASELINE__SUPERVISION_HPP_
