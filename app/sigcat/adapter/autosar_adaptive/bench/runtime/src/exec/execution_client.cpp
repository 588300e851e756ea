#include "ara/exec/execution_client.h"

#include <csignal>
#include <thread>
#include <unistd.h>
#include <utility>

namespace ara::exec {

namespace {

// A signal handler may do no more than write to a pipe; a thread reads it, and calls what the application gave.
int signal_pipe[2] = {-1, -1};
constexpr char kTerminate = 'T';
constexpr char kEnd = 'E';

bool Write(char what) { return ::write(signal_pipe[1], &what, 1) == 1; }

extern "C" void TakeSignal(int /* signal */) { static_cast<void>(Write(kTerminate)); }

}  // namespace

const char* ExecErrorDomain::Message(CodeType code) const noexcept {
    switch (static_cast<Errc>(code)) {
        case Errc::kInvalidArgument:
            return "invalid argument";
        case Errc::kCommunicationError:
            return "the execution management cannot be reached";
        case Errc::kInvalidTransition:
            return "invalid transition";
        case Errc::kGeneralError:
            break;
    }
    return "error of execution management";
}

const ara::core::ErrorDomain& GetExecErrorDomain() noexcept {
    static const ExecErrorDomain domain;
    return domain;
}

class ExecutionClient::Signals final {
public:
    explicit Signals(std::function<void()> handler)
        : thread_{[handler = std::move(handler)] {
              char what = kEnd;
              while (::read(signal_pipe[0], &what, 1) == 1 && what != kEnd) {
                  handler();
              }
          }} {
        std::signal(SIGTERM, TakeSignal);
        std::signal(SIGINT, TakeSignal);
    }

    ~Signals() {
        std::signal(SIGTERM, SIG_DFL);
        std::signal(SIGINT, SIG_DFL);
        static_cast<void>(Write(kEnd));
        thread_.join();
        ::close(signal_pipe[0]);
        ::close(signal_pipe[1]);
        signal_pipe[0] = signal_pipe[1] = -1;
    }

    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;

private:
    std::thread thread_;
};

ExecutionClient::ExecutionClient(std::unique_ptr<Signals> signals) noexcept : signals_{std::move(signals)} {}
ExecutionClient::ExecutionClient(ExecutionClient&&) noexcept = default;
ExecutionClient& ExecutionClient::operator=(ExecutionClient&&) noexcept = default;
ExecutionClient::~ExecutionClient() = default;

ExecutionClient::ExecutionClient(std::function<void()> terminationHandler) {
    auto made = Create(std::move(terminationHandler));
    if (!made) {
        throw ExecException{made.Error()};
    }
    *this = std::move(made).Value();
}

ara::core::Result<ExecutionClient> ExecutionClient::Create(std::function<void()> terminationHandler) noexcept {
    if (!terminationHandler || signal_pipe[0] != -1) {
        return ara::core::Result<ExecutionClient>::FromError(ExecErrc::kInvalidArgument);
    }
    if (::pipe(signal_pipe) != 0) {
        return ara::core::Result<ExecutionClient>::FromError(ExecErrc::kCommunicationError);
    }
    return ExecutionClient{std::make_unique<Signals>(std::move(terminationHandler))};
}

ara::core::Result<void> ExecutionClient::ReportExecutionState(ExecutionState /* state */) const noexcept {
    return {};  // no execution management receives it
}

}  // namespace ara::exec
