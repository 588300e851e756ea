// What a process tells the execution management, and hears of it (SWS_EM_02001).
#ifndef ARA_EXEC_EXECUTION_CLIENT_H_
#define ARA_EXEC_EXECUTION_CLIENT_H_

#include <cstdint>
#include <functional>
#include <memory>

#include "ara/core/result.h"
#include "ara/exec/exec_error_domain.h"

namespace ara::exec {

enum class ExecutionState : std::uint32_t { kRunning = 0 };

// One for each process: it takes SIGTERM, and SIGINT for who works at a desk.
class ExecutionClient final {
public:
    // Throws ExecException where Create gives an error.
    explicit ExecutionClient(std::function<void()> terminationHandler);
    ~ExecutionClient();
    ExecutionClient(const ExecutionClient&) = delete;
    ExecutionClient& operator=(const ExecutionClient&) = delete;
    ExecutionClient(ExecutionClient&&) noexcept;
    ExecutionClient& operator=(ExecutionClient&&) noexcept;

    // The handler runs in a thread of the platform.
    static ara::core::Result<ExecutionClient> Create(std::function<void()> terminationHandler) noexcept;

    ara::core::Result<void> ReportExecutionState(ExecutionState state) const noexcept;

private:
    class Signals;

    explicit ExecutionClient(std::unique_ptr<Signals> signals) noexcept;

    std::unique_ptr<Signals> signals_;
};

}  // namespace ara::exec

#endif  // ARA_EXEC_EXECUTION_CLIENT_H_
