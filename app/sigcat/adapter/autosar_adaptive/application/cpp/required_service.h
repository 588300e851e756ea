// A service that is used. It may come at any time, go, and come again.

#ifndef APPLICATION_REQUIRED_SERVICE_H
#define APPLICATION_REQUIRED_SERVICE_H

#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include "ara/com/types.h"
#include "ara/core/instance_specifier.h"
#include "ara/core/optional.h"
#include "ara/log/logger.h"

namespace application {

template <typename Proxy>
class RequiredService final {
public:
    using Connect = std::function<void(Proxy&)>;

    /// `connect` subscribes to what is used of the service, once for each instance that is found.
    RequiredService(const char* port, ara::log::Logger& logger, Connect connect)
        : port_{port}, logger_(logger), connect_{std::move(connect)} {}

    void Find() {
        auto search = Proxy::StartFindService(
            [this](ara::com::ServiceHandleContainer<typename Proxy::HandleType> handles, ara::com::FindServiceHandle) {
                Found(handles);
            },
            ara::core::InstanceSpecifier{port_});
        if (search.HasValue()) {
            search_.emplace(search.Value());
        } else {
            logger_.LogError() << port_ << " cannot be looked for: " << search.Error().Message();
        }
    }

    /// Ends the search and gives the proxy back to the platform.
    void Leave() {
        if (search_.has_value()) {
            Proxy::StopFindService(*search_);
            search_.reset();
        }
        std::shared_ptr<Proxy> left;
        {
            const std::lock_guard<std::mutex> lock{mutex_};
            left.swap(proxy_);
        }
    }

    /// The proxy; none before the service was found.
    std::shared_ptr<Proxy> Get() const {
        const std::lock_guard<std::mutex> lock{mutex_};
        return proxy_;
    }

private:
    using Handles = ara::com::ServiceHandleContainer<typename Proxy::HandleType>;

    // The platform itself renews the subscriptions of a proxy whose service comes again.
    void Found(const Handles& handles) {
        logger_.LogInfo() << port_ << (handles.empty() ? " is not available" : " is available");
        if (handles.empty() || Get() != nullptr) {
            return;
        }
        const auto made = std::make_shared<Proxy>(*handles.begin());
        {
            const std::lock_guard<std::mutex> lock{mutex_};
            proxy_ = made;
        }
        connect_(*made);
    }

    const char* port_;
    ara::log::Logger& logger_;
    Connect connect_;
    mutable std::mutex mutex_;
    std::shared_ptr<Proxy> proxy_;
    ara::core::Optional<ara::com::FindServiceHandle> search_;
};

}  // namespace application

#endif  // APPLICATION_REQUIRED_SERVICE_H
