// The time of calls: steady, in nanoseconds.

#ifndef APPLICATION_CLOCK_H
#define APPLICATION_CLOCK_H

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>

namespace application {

class Clock {
public:
    Clock() = default;
    virtual ~Clock() = default;
    Clock(const Clock&) = delete;
    Clock(Clock&&) = delete;
    Clock& operator=(const Clock&) = delete;
    Clock& operator=(Clock&&) = delete;

    virtual std::uint64_t Now() const = 0;

    /// Waits until it is `time`, which does not drift, or until Wake. False after Stop.
    virtual bool WaitUntil(std::uint64_t time) = 0;

    /// Ends the wait that is, or else the next one. From any thread.
    virtual void Wake() = 0;

    /// Ends all waiting. From any thread.
    virtual void Stop() = 0;

    /// Whether another program says when calls run: then none runs at the same time as another one.
    virtual bool IsInTurns() const { return false; }
};

class SteadyClock final : public Clock {
public:
    std::uint64_t Now() const override;
    bool WaitUntil(std::uint64_t time) override;
    void Wake() override;
    void Stop() override;

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool is_woken_{false};
    bool is_stopped_{false};
};

/// The clock of a component.
std::unique_ptr<Clock> MakeClock(const char* component);

}  // namespace application

#endif  // APPLICATION_CLOCK_H
