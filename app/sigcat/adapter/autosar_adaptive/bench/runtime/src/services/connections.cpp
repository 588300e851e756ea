// What proxies and skeletons call: each takes the lock and hands over to the runtime.
#include <cstdlib>
#include <utility>

#include "ara/com/com_error_domain.h"
#include "bench/event_receiver.h"
#include "bench/find_service.h"
#include "bench/proxy_connection.h"
#include "bench/skeleton_connection.h"
#include "services/runtime.h"
#include "someip/application_error.h"

namespace bench {
namespace {

using ara::com::ComErrc;
using ara::core::Result;

// Which process of its executable this is; execution management would know.
std::string_view ThisProcess() {
    const char* const named = std::getenv("BENCH_PROCESS");
    return named != nullptr ? named : "";
}

// The instance that a port means in this process.
Result<std::uint16_t> InstanceOf(const ServiceDescription& service, const ara::core::InstanceSpecifier& port) {
    for (const auto& instance : service.instances) {
        if (instance.specifier == port.ToString() && instance.process == ThisProcess()) {
            return instance.id;
        }
    }
    return Result<std::uint16_t>::FromError(ComErrc::kInstanceIDNotResolvable);
}

Result<std::uint16_t> InstanceOf(const ServiceDescription& service, const ara::com::InstanceIdentifier& instance) {
    if (instance.ServiceId() != service.id) {
        return Result<std::uint16_t>::FromError(ComErrc::kInstanceIDNotResolvable);
    }
    return instance.InstanceId();
}

template <typename Instance>
Result<Handles> FoundNow(const ServiceDescription& service, const Instance& named) {
    const auto instance = InstanceOf(service, named);
    if (!instance) {
        return Result<Handles>{instance.Error()};
    }
    const auto lock = Runtime::Get().Locked();
    return Runtime::Get().Used().Found(service, instance.Value());
}

template <typename Instance>
Result<ara::com::FindServiceHandle> Search(const ServiceDescription& service,
                                           ara::com::FindServiceHandler<Handle> handler, const Instance& named) {
    const auto instance = InstanceOf(service, named);
    if (!instance) {
        return Result<ara::com::FindServiceHandle>{instance.Error()};
    }
    Runtime& runtime = Runtime::Get();
    const auto lock = runtime.Locked();
    if (!runtime.IsRunning()) {
        return Result<ara::com::FindServiceHandle>::FromError(ComErrc::kNetworkBindingFailure);
    }
    const auto search = runtime.Sought().Start(service, instance.Value(), std::move(handler));
    runtime.Wake();
    return ara::com::FindServiceHandle{search};
}

template <typename Instance>
std::shared_ptr<ProvidedInstance> Provided(const ServiceDescription& service, const Instance& named,
                                           ara::com::MethodCallProcessingMode mode) {
    return std::make_shared<ProvidedInstance>(service, InstanceOf(service, named).ValueOrThrow(), mode);
}

}  // namespace

// -- searches ---------------------------------------------------------------------------------------------------------

ara::com::InstanceIdentifier Handle::GetInstanceId() const {
    return ara::com::InstanceIdentifier{"SOME/IP:" + std::to_string(service_->id) + ":" + std::to_string(instance_)};
}

Result<Handles> FindService(const ServiceDescription& service, const ara::core::InstanceSpecifier& port) {
    return FoundNow(service, port);
}

Result<Handles> FindService(const ServiceDescription& service, const ara::com::InstanceIdentifier& instance) {
    return FoundNow(service, instance);
}

Result<ara::com::FindServiceHandle> StartFindService(const ServiceDescription& service,
                                                     ara::com::FindServiceHandler<Handle> handler,
                                                     const ara::core::InstanceSpecifier& port) {
    return Search(service, std::move(handler), port);
}

Result<ara::com::FindServiceHandle> StartFindService(const ServiceDescription& service,
                                                     ara::com::FindServiceHandler<Handle> handler,
                                                     const ara::com::InstanceIdentifier& instance) {
    return Search(service, std::move(handler), instance);
}

void StopFindService(ara::com::FindServiceHandle handle) {
    Runtime& runtime = Runtime::Get();
    auto lock = runtime.Locked();
    const auto owner = runtime.Sought().Stop(handle.Search());
    lock.unlock();
    if (owner != nullptr) {
        runtime.Handlers().Retire(owner.get());
    }
}

// -- proxies ----------------------------------------------------------------------------------------------------------

ara::core::ErrorCode ProxyConnection::Malformed() noexcept {
    return {ComErrc::kCommunicationStackError, static_cast<std::int32_t>(ReturnCode::kMalformedMessage)};
}

void ProxyConnection::Request(std::uint16_t method, const Bytes& arguments, Answer answer) const {
    Runtime& runtime = Runtime::Get();
    auto lock = runtime.Locked();
    if (!runtime.IsRunning() || !runtime.Used().Call(handle_, method, arguments, answer)) {
        lock.unlock();
        answer(Result<ByteView>::FromError(ComErrc::kServiceNotAvailable));
    }
}

EventReceiver::EventReceiver(const std::shared_ptr<ProxyConnection>& connection, const EventDescription& event)
    : connection_{connection},
      queue_{std::make_shared<EventQueue>(connection->GetHandle(), event, Runtime::Get().Handlers())} {}

EventReceiver& EventReceiver::operator=(EventReceiver&& other) noexcept {
    if (this != &other) {
        EventReceiver ended{std::move(*this)};
        connection_ = std::move(other.connection_);
        queue_ = std::move(other.queue_);
    }
    return *this;
}

EventReceiver::~EventReceiver() {
    if (queue_ != nullptr) {
        queue_->SetReceiveHandler(nullptr);
        queue_->SetStateHandler(nullptr);
        Unsubscribe();
    }
}

Result<void> EventReceiver::Subscribe(std::size_t maxSampleCount) {
    Runtime& runtime = Runtime::Get();
    const auto lock = runtime.Locked();
    if (!runtime.IsRunning()) {
        return Result<void>::FromError(ComErrc::kNetworkBindingFailure);
    }
    const std::size_t before = queue_->Count();
    if (maxSampleCount == 0 || (before != 0 && before != maxSampleCount)) {
        return Result<void>::FromError(ComErrc::kMaxSampleCountNotRealizable);
    }
    if (before == 0) {
        queue_->Open(maxSampleCount);
        runtime.Used().Subscribe(queue_);
    }
    return {};
}

void EventReceiver::Unsubscribe() {
    Runtime& runtime = Runtime::Get();
    const auto lock = runtime.Locked();
    if (queue_->Count() != 0) {
        queue_->Close();
        if (runtime.IsRunning()) {
            runtime.Used().Unsubscribe(queue_);
        }
    }
}

ara::com::SubscriptionState EventReceiver::GetSubscriptionState() const { return queue_->State(); }

Result<void> EventReceiver::SetSubscriptionStateChangeHandler(ara::com::SubscriptionStateChangeHandler handler) {
    queue_->SetStateHandler(std::move(handler));
    return {};
}

void EventReceiver::UnsetSubscriptionStateChangeHandler() { queue_->SetStateHandler(nullptr); }

Result<void> EventReceiver::SetReceiveHandler(ara::com::EventReceiveHandler handler) {
    queue_->SetReceiveHandler(std::move(handler));
    return {};
}

Result<void> EventReceiver::UnsetReceiveHandler() {
    queue_->SetReceiveHandler(nullptr);
    return {};
}

std::size_t EventReceiver::GetFreeSampleCount() const noexcept { return queue_->Free(); }

std::optional<Received> EventReceiver::Next() { return queue_->Pop(); }

void EventReceiver::TellMalformed() const { queue_->TellMalformed(); }

// -- skeletons --------------------------------------------------------------------------------------------------------

SkeletonConnection::SkeletonConnection(const ServiceDescription& service, const ara::core::InstanceSpecifier& port,
                                       ara::com::MethodCallProcessingMode mode)
    : service_{service}, instance_{Provided(service, port, mode)} {}

SkeletonConnection::SkeletonConnection(const ServiceDescription& service, const ara::com::InstanceIdentifier& instance,
                                       ara::com::MethodCallProcessingMode mode)
    : service_{service}, instance_{Provided(service, instance, mode)} {}

SkeletonConnection::~SkeletonConnection() { StopOfferService(); }

Result<void> SkeletonConnection::OfferService() {
    const auto lock = Runtime::Get().Locked();
    return Runtime::Get().Offered().Offer(instance_);
}

void SkeletonConnection::StopOfferService() {
    Runtime& runtime = Runtime::Get();
    auto lock = runtime.Locked();
    runtime.Offered().StopOffer(*instance_);
    lock.unlock();
    runtime.Handlers().Retire(instance_.get());
}

ara::core::Future<bool> SkeletonConnection::ProcessNextMethodCall() {
    ara::core::Promise<bool> promise;
    auto future = promise.get_future();
    if (instance_->mode != ara::com::MethodCallProcessingMode::kPoll) {
        promise.SetError(ComErrc::kWrongMethodCallProcessingMode);
        return future;
    }
    auto lock = Runtime::Get().Locked();
    auto& waiting = instance_->waiting;
    if (waiting.empty()) {
        promise.set_value(false);
        return future;
    }
    const auto request = std::move(waiting.front());
    waiting.pop_front();
    lock.unlock();
    Process(request);
    promise.set_value(true);
    return future;
}

Result<void> SkeletonConnection::Send(const EventDescription& event, const Writer& value) {
    const auto lock = Runtime::Get().Locked();
    if (!instance_->is_offered) {
        return Result<void>::FromError(ComErrc::kServiceNotOffered);
    }
    Runtime::Get().Offered().Send(*instance_, event, value.Payload());
    return {};
}

void SkeletonConnection::AddField(const EventDescription& notifier, std::uint16_t getter) {
    const auto lock = Runtime::Get().Locked();
    instance_->fields[notifier.id] = getter;
    if (getter != 0) {
        instance_->getters[getter] = notifier.id;
    }
}

bool SkeletonConnection::Keep(const EventDescription& notifier, const Writer& value) {
    const auto lock = Runtime::Get().Locked();
    instance_->values[notifier.id] = value.Payload();
    instance_->payloads.erase(notifier.id);
    return instance_->is_offered;
}

void SkeletonConnection::AddSetter(std::uint16_t setter) {
    const auto lock = Runtime::Get().Locked();
    instance_->setters.insert(setter);
}

void SkeletonConnection::SetHandler(std::uint16_t method, Handler handler) {
    const auto lock = Runtime::Get().Locked();
    instance_->handlers[method] = std::make_shared<const Handler>(std::move(handler));
}

void Reply::Send(const Writer& values) const {
    const auto lock = Runtime::Get().Locked();
    Runtime::Get().Offered().Reply(*caller_, ReturnCode::kOk, values.Payload());
}

void Reply::Fail(const ara::core::ErrorCode& error) const {
    const auto lock = Runtime::Get().Locked();
    const auto instance = caller_->instance.lock();
    const bool is_modelled = instance != nullptr && IsModelled(error, instance->service);
    Runtime::Get().Offered().Reply(*caller_, ReturnCode::kNotOk, is_modelled ? WrittenError(error) : Bytes{});
}

void Reply::FailMalformed() const {
    const auto lock = Runtime::Get().Locked();
    Runtime::Get().Offered().Reply(*caller_, ReturnCode::kMalformedMessage, {});
}

}  // namespace bench
