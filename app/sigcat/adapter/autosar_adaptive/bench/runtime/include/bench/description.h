// What the ARXML says of a service, as constant tables that the generator writes.
#ifndef BENCH_DESCRIPTION_H_
#define BENCH_DESCRIPTION_H_

#include <cstdint>
#include <string_view>

#include "ara/core/error_domain.h"
#include "ara/core/span.h"

namespace bench {

// TransformationProps: how values become bytes.
struct Serialization {
    bool is_big_endian;
    std::uint8_t alignment;  // bytes
    std::uint8_t array_length;
    std::uint8_t string_length;
    std::uint8_t struct_length;
    bool is_utf16;
};

// Times of service discovery, in ms; times to live in s.
struct DiscoveryTimes {
    double initial_delay_min;
    double initial_delay_max;
    std::uint32_t repetitions_max;
    double repetitions_base_delay;
    double offer_cyclic_delay;
    std::uint32_t offer_time_to_live;
    std::uint32_t find_time_to_live;
    std::uint32_t subscribe_time_to_live;
    double response_delay_min;
    double response_delay_max;
};

// End-to-end protection of an event, by a profile of AUTOSAR.
struct Protection {
    std::uint8_t profile = 0;  // none
    std::uint32_t data_id = 0;
    std::uint32_t max_delta_counter = 1;  // the largest step from one counter to the next
};

// An event, or the notifier of a field.
struct EventDescription {
    std::string_view name;
    std::uint16_t id;
    std::uint16_t group;
    bool is_field;
    Protection protection{};
};

// The instance that a port of an executable means: in its own process, or in a further one, which is named.
struct InstanceDescription {
    std::string_view specifier;
    std::uint16_t id;
    std::string_view process{};
};

// An application error that a method may return.
struct ErrorDescription {
    const ara::core::ErrorDomain* domain;
    ara::core::ErrorDomain::CodeType code;
};

struct ServiceDescription {
    std::string_view name;
    std::uint16_t id;
    std::uint8_t major_version;
    std::uint32_t minor_version;
    bool counts_sessions;  // of events; requests are always counted, for their answers
    Serialization serialization;
    DiscoveryTimes times;
    ara::core::Span<const EventDescription> events;
    ara::core::Span<const InstanceDescription> instances;
    ara::core::Span<const ErrorDescription> errors{};
};

}  // namespace bench

#endif  // BENCH_DESCRIPTION_H_
