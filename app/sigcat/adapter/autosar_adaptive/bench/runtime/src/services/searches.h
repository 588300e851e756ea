// Searches for services, each with the phases in which it asks the network.
#ifndef BENCH_SERVICES_SEARCHES_H_
#define BENCH_SERVICES_SEARCHES_H_

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "ara/com/types.h"
#include "bench/handle.h"
#include "discovery/entry.h"
#include "net/timers.h"

namespace bench {

class Runtime;

class Searches {
public:
    using Handler = ara::com::FindServiceHandler<Handle>;

    explicit Searches(Runtime& runtime) noexcept : runtime_{runtime} {}

    std::uint64_t Start(const ServiceDescription& service, std::uint16_t instance, Handler handler);
    // What the owner of its handler calls is retired with, when the lock is released.
    std::shared_ptr<const void> Stop(std::uint64_t search);

    // A service has come or gone.
    void Changed(std::uint16_t service);
    // Log an offer of another major version than a search asks for, once for each search.
    void Compare(const Entry& offer);
    void Clear();

    // How many have found nothing.
    std::size_t Missing() const;

private:
    struct Search {
        std::uint64_t id;
        const ServiceDescription* service;
        std::uint16_t instance;
        std::shared_ptr<Handler> handler;
        ara::com::ServiceHandleContainer<Handle> told{};
        std::uint32_t repetitions = 0;
        bool has_logged_version = false;
        std::optional<Timers::Id> timer{};
    };

    void Ask(const std::shared_ptr<Search>& search);
    void Tell(const std::shared_ptr<Search>& search);
    void EndPhase(Search& search);

    Runtime& runtime_;
    std::map<std::uint64_t, std::shared_ptr<Search>> searches_;
    std::uint64_t started_ = 0;
};

}  // namespace bench

#endif  // BENCH_SERVICES_SEARCHES_H_
