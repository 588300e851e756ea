// End-to-end protection of events: what a sender adds, and what a receiver finds (PRS_E2EProtocol).
//
// Protected is what the default offset of 64 bits says: the half of the SOME/IP header after its length, then the header
// of the profile, then the values. The state machine with its windows is left out: it decides nothing here.
#ifndef BENCH_E2E_PROTECTION_H_
#define BENCH_E2E_PROTECTION_H_

#include <cstdint>

#include "ara/com/e2e/types.h"
#include "someip/message.h"

namespace bench {

// The payload of a protected message: the header of the profile, and the values. `counter` is the next one's then.
Bytes Protected(const Protection& protection, std::uint32_t& counter, const Header& header, ByteView values);

// The values of a protected payload; none of one that is too short.
ByteView Values(const Protection& protection, ByteView payload) noexcept;

// Holds each message of an event against the one before.
class Checker {
public:
    explicit Checker(const Protection& protection) noexcept;

    ara::com::e2e::ProfileCheckStatus Check(const Header& header, ByteView payload);

private:
    bool IsWhole(const Header& header, ByteView payload) const;

    Protection protection_;
    std::uint64_t counter_;
};

}  // namespace bench

#endif  // BENCH_E2E_PROTECTION_H_
