#include "services/searches.h"

#include <algorithm>
#include <utility>

#include "ara/log/logger.h"
#include "discovery/discovery_message.h"
#include "services/runtime.h"

namespace bench {

std::uint64_t Searches::Start(const ServiceDescription& service, std::uint16_t instance, Handler handler) {
    auto search = std::make_shared<Search>(
        Search{++started_, &service, instance, std::make_shared<Handler>(std::move(handler))});
    searches_.emplace(search->id, search);
    Tell(search);
    if (search->told.empty()) {
        const auto& times = service.times;
        const auto delay = runtime_.Between(times.initial_delay_min, times.initial_delay_max);
        search->timer = runtime_.Later().After(delay, [this, search] { Ask(search); });
    }
    return search->id;
}

std::shared_ptr<const void> Searches::Stop(std::uint64_t search) {
    const auto found = searches_.find(search);
    if (found == searches_.end()) {
        return nullptr;
    }
    EndPhase(*found->second);
    return searches_.extract(found).mapped();
}

void Searches::Changed(std::uint16_t service) {
    for (const auto& [id, search] : searches_) {
        if (search->service->id == service) {
            Tell(search);
        }
    }
}

void Searches::Compare(const Entry& offer) {
    for (const auto& [id, search] : searches_) {
        const ServiceDescription& service = *search->service;
        const bool is_meant = search->instance == kAnyInstance || search->instance == offer.instance;
        if (service.id != offer.service || !is_meant || service.major_version == offer.major_version ||
            search->has_logged_version) {
            continue;
        }
        search->has_logged_version = true;
        ara::log::CreateLogger("COM", "Communication").LogWarn()
            << service.name << ": version " << static_cast<std::uint32_t>(offer.major_version) << "."
            << offer.minor_version << " is offered, but version " << static_cast<std::uint32_t>(service.major_version)
            << "." << service.minor_version << " is needed";
    }
}

void Searches::Clear() { searches_.clear(); }

std::size_t Searches::Missing() const {
    return static_cast<std::size_t>(std::count_if(
        searches_.begin(), searches_.end(), [](const auto& each) { return each.second->told.empty(); }));
}

void Searches::Ask(const std::shared_ptr<Search>& search) {
    const auto& times = search->service->times;
    runtime_.Discovery().Add(kDiscoveryGroup,
                             Entry{EntryType::kFind, search->service->id, search->instance,
                                   search->service->major_version, times.find_time_to_live, kAnyMinorVersion});
    search->timer.reset();
    if (search->repetitions < times.repetitions_max) {
        const Milliseconds delay{times.repetitions_base_delay * static_cast<double>(1ULL << search->repetitions)};
        ++search->repetitions;
        search->timer = runtime_.Later().After(delay, [this, search] { Ask(search); });
    }
}

void Searches::Tell(const std::shared_ptr<Search>& search) {
    auto handles = runtime_.Used().Found(*search->service, search->instance);
    if (handles == search->told) {
        return;
    }
    search->told = handles;
    if (!handles.empty()) {
        EndPhase(*search);  // who offers it does so again and again: asking is over
    }
    runtime_.Handlers().Post(search.get(), [search, handles = std::move(handles)] {
        (*search->handler)(handles, ara::com::FindServiceHandle{search->id});
    });
}

void Searches::EndPhase(Search& search) {
    if (search.timer.has_value()) {
        runtime_.Later().Cancel(*search.timer);
        search.timer.reset();
    }
}

}  // namespace bench
