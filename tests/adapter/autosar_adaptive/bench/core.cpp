// What ara::core promises of results, futures and instance specifiers, and fields that can be set. Says `done`, or what is not so.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>

#include "ara/com/com_error_domain.h"
#include "ara/core/core_error_domain.h"
#include "ara/core/initialization.h"
#include "ara/core/instance_specifier.h"
#include "ara/core/promise.h"
#include "ara/per/key_value_storage.h"
#include "bench/proxy_base.h"
#include "bench/proxy_field.h"
#include "bench/skeleton_base.h"
#include "bench/skeleton_field.h"
#include "someip/application_error.h"

namespace {

using namespace std::chrono_literals;
using ara::com::ComErrc;
using ara::core::Future;
using ara::core::future_errc;
using ara::core::future_status;
using ara::core::Promise;
using ara::core::Result;

void Check(bool holds, int line) {
    if (!holds) {
        std::cout << "not so: core.cpp:" << line << std::endl;
        std::exit(1);
    }
}
#define CHECK(condition) Check(condition, __LINE__)

/// What does not compile on a platform of R23-11 must not compile here either.
void ConstantHandles() {
    using ara::per::KeyValueStorage;
    using Handle = ara::per::SharedHandle<KeyValueStorage>;
    static_assert(std::is_same_v<decltype(std::declval<const Handle&>().operator->()), const KeyValueStorage*>);
    static_assert(std::is_same_v<decltype(*std::declval<const Handle&>()), const KeyValueStorage&>);
    static_assert(std::is_same_v<decltype(std::declval<Handle&>().operator->()), KeyValueStorage*>);
    static_assert(!std::is_convertible_v<std::shared_ptr<KeyValueStorage>, Handle>);
}

void Results() {
    const Result<int> value{3};
    CHECK(value && value.Value() == 3 && value.ValueOr(4) == 3);
    const auto error = Result<int>::FromError(ComErrc::kNoClients);
    CHECK(!error && error.Error() == ComErrc::kNoClients && error.ValueOr(4) == 4);
    CHECK(error.CheckError(ComErrc::kNoClients) && !error.CheckError(ComErrc::kCouldNotExecute));
    CHECK(value.Bind([](int number) { return std::to_string(number); }).Value() == "3");
    CHECK(std::string{error.Error().Domain().Name()} == "Com");
    bool is_thrown = false;
    try {
        static_cast<void>(error.ValueOrThrow());
    } catch (const ara::com::ComException& exception) {
        is_thrown = exception.Error() == ComErrc::kNoClients;
    }
    CHECK(is_thrown);
}

void Futures() {
    Promise<int> promise;
    auto future = promise.get_future();
    CHECK(future.valid() && !future.is_ready() && future.wait_for(1ms) == future_status::timeout);
    std::thread setter{[&promise] { promise.set_value(5); }};
    CHECK(future.wait_for(10s) == future_status::ready && future.get() == 5 && !future.valid());
    setter.join();
    CHECK(future.GetResult().CheckError(future_errc::no_state));

    Future<int> broken;
    {
        Promise<int> ends;
        broken = ends.get_future();
    }
    CHECK(broken.GetResult().CheckError(future_errc::broken_promise));
}

void Continuations() {
    Promise<int> promise;
    auto text = promise.get_future()
                    .then([](Future<int> done) { return done.get() + 1; })
                    .then([](Future<int> done) { return std::to_string(done.get()); });
    CHECK(!text.is_ready());
    promise.set_value(1);
    CHECK(text.is_ready() && text.get() == "2");

    Promise<void> ready;
    ready.set_value();
    auto failed = ready.get_future().then(
        [](Future<void>) { return Result<int>::FromError(ComErrc::kCouldNotExecute); });
    CHECK(failed.GetResult().CheckError(ComErrc::kCouldNotExecute));
}

void Specifiers() {
    using ara::core::InstanceSpecifier;
    CHECK(InstanceSpecifier::Create("Executable/Root/Port").Value().ToString() == "Executable/Root/Port");
    for (const auto* const wrong : {"", "/a", "a/", "a//b", "a b"}) {
        CHECK(InstanceSpecifier::Create(wrong).CheckError(ara::core::CoreErrc::kInvalidMetaModelPath));
    }
    CHECK(ara::com::InstanceIdentifier::Create("SOME/IP:1:2").Value().InstanceId() == 2);
    for (const auto* const wrong : {"", "SOME/IP:", "SOME/IP:1", "SOME/IP:1:", "SOME/IP:1:2x", "SOME/IP:70000:1"}) {
        CHECK(ara::com::InstanceIdentifier::Create(wrong).CheckError(ComErrc::kInvalidInstanceIdentifierString));
    }
}

// -- a field that can be set ------------------------------------------------------------------------------------------

constexpr bench::EventDescription kEvents[] = {{"Limit", 0x8001, 1, true}};
constexpr bench::InstanceDescription kInstances[] = {{"A/B/Port", 7}};
constexpr std::uint16_t kGetter = 1;
constexpr std::uint16_t kSetter = 2;

}  // namespace

extern const bench::ServiceDescription kLimits;
const bench::ServiceDescription kLimits{
    "Limits", 0x2000, 1, 0, true, {true, 1, 4, 4, 0, false}, {1, 2, 3, 10, 100, 1, 1, 1, 0, 1}, kEvents, kInstances};

namespace {

class Skeleton : public bench::SkeletonBase<kLimits> {
public:
    Skeleton()
        : SkeletonBase{ara::core::InstanceSpecifier{"A/B/Port"}, ara::com::MethodCallProcessingMode::kEvent},
          Limit{connection_, kEvents[0], kGetter, kSetter} {}

    bench::WritableSkeletonField<float> Limit;
};

class Proxy : public bench::ProxyBase<kLimits> {
public:
    explicit Proxy(const HandleType& handle) : ProxyBase{handle}, Limit{connection_, kEvents[0], kGetter, kSetter} {}

    bench::WritableProxyField<float> Limit;
};

Proxy::HandleType Found() {
    Promise<Proxy::HandleType> found;
    auto handle = found.get_future();
    const auto search = Proxy::StartFindService(
        [&found](const auto& handles, ara::com::FindServiceHandle) {
            if (!handles.empty()) {
                found.set_value(handles.front());
            }
        },
        ara::com::InstanceIdentifier{"SOME/IP:8192:7"});
    const auto result = handle.get();
    Proxy::StopFindService(search.Value());
    return result;
}

void Fields() {
    Skeleton skeleton;
    CHECK(skeleton.OfferService().CheckError(ComErrc::kFieldValueIsNotValid));
    CHECK(skeleton.Limit.Update(1.0F).HasValue());
    CHECK(skeleton.OfferService().CheckError(ComErrc::kSetHandlerNotSet));
    // Sets no more than 100, and refuses what is below 0.
    CHECK(skeleton.Limit
              .RegisterSetHandler([](const float& wanted) {
                  Promise<float> set;
                  wanted < 0 ? set.SetError(ComErrc::kCouldNotExecute) : set.set_value(wanted < 100 ? wanted : 100);
                  return set.get_future();
              })
              .HasValue());
    CHECK(skeleton.OfferService().HasValue());
    Skeleton second;
    CHECK(second.Limit.Update(1.0F).HasValue());
    CHECK(second.Limit.RegisterSetHandler([](const float&) { return Promise<float>{}.get_future(); }).HasValue());
    CHECK(second.OfferService().CheckError(ComErrc::kNetworkBindingFailure));

    Proxy proxy{Found()};
    CHECK(proxy.GetHandle().GetInstanceId().ToString() == "SOME/IP:8192:7");
    CHECK(proxy.Limit.Subscribe(0).CheckError(ComErrc::kMaxSampleCountNotRealizable));
    CHECK(proxy.Limit.Subscribe(1).HasValue() && proxy.Limit.Subscribe(1).HasValue());
    CHECK(proxy.Limit.Subscribe(2).CheckError(ComErrc::kMaxSampleCountNotRealizable));
    CHECK(proxy.Limit.Get().get() == 1.0F);
    CHECK(proxy.Limit.Set(50.0F).get() == 50.0F && proxy.Limit.Set(500.0F).get() == 100.0F);
    CHECK(proxy.Limit.Get().get() == 100.0F);
    CHECK(proxy.Limit.Set(-1.0F).GetResult().CheckError(ComErrc::kCommunicationStackError));

    CHECK(skeleton.Limit
              .RegisterGetHandler([] {
                  Promise<float> asked;
                  asked.set_value(3.0F);
                  return asked.get_future();
              })
              .HasValue());
    CHECK(proxy.Limit.Get().get() == 3.0F);
}

// Who holds all samples gets no more; a sample that is let go makes room, even when its proxy is gone.
void Samples() {
    Skeleton skeleton;
    CHECK(skeleton.Limit.Update(1.0F).HasValue());
    CHECK(skeleton.Limit.RegisterSetHandler([](const float&) { return Promise<float>{}.get_future(); }).HasValue());
    CHECK(skeleton.OfferService().HasValue());
    ara::com::SamplePtr<const float> held;
    {
        Proxy proxy{Found()};
        CHECK(proxy.Limit.Subscribe(1).HasValue() && proxy.Limit.GetFreeSampleCount() == 1);
        Promise<void> arrived;
        auto waits = arrived.get_future();
        CHECK(proxy.Limit.SetReceiveHandler([&arrived] { arrived.set_value(); }).HasValue());
        waits.wait();
        CHECK(proxy.Limit.UnsetReceiveHandler().HasValue());
        const auto count = proxy.Limit.GetNewSamples([&held](auto sample) { held = std::move(sample); });
        CHECK(count.Value() == 1 && *held == 1.0F && proxy.Limit.GetFreeSampleCount() == 0);
        CHECK(proxy.Limit.GetNewSamples([](auto) {}).CheckError(ComErrc::kMaxSamplesExceeded));
        held = nullptr;
        CHECK(proxy.Limit.GetFreeSampleCount() == 1 && proxy.Limit.GetNewSamples([](auto) {}).Value() == 0);
        CHECK(skeleton.Limit.Update(2.0F).HasValue());
        while (proxy.Limit.GetNewSamples([&held](auto sample) { held = std::move(sample); }).ValueOr(1) == 0) {
            std::this_thread::sleep_for(1ms);
        }
    }
    CHECK(*held == 2.0F);
}

// AUTOSAR Classic answers with a return code beyond 0x1F (SWS_CM_10358), AUTOSAR adaptive with a payload (SWS_CM_10428).
void ApplicationErrors() {
    static const bench::ErrorDescription errors[] = {{&ara::com::GetComErrorDomain(), 1},
                                                     {&ara::com::GetComErrorDomain(), 2}};
    bench::ServiceDescription service{};
    service.errors = errors;
    const auto error = [&service](bench::MessageType type, std::uint8_t code, bench::ByteView payload) {
        const auto return_code = static_cast<bench::ReturnCode>(code);
        return bench::ReadError({{1, 2, 3, 4, 1, 1, static_cast<std::uint8_t>(type), return_code}, payload}, service);
    };
    CHECK(error(bench::MessageType::kResponse, 0x21, {}) == ara::core::ErrorCode{ComErrc{2}});
    CHECK(!error(bench::MessageType::kResponse, 0x22, {}).has_value());
    const bench::Bytes whole = bench::WrittenError(ComErrc{1});
    CHECK(error(bench::MessageType::kError, 0x01, bench::ByteView{whole}) == ara::core::ErrorCode{ComErrc{1}});
    CHECK(!error(bench::MessageType::kError, 0x01, bench::ByteView{whole}.first(whole.size() - 1)).has_value());
    CHECK(!error(bench::MessageType::kError, 0x04, bench::ByteView{whole}).has_value());
    CHECK(!error(bench::MessageType::kError, 0x01, bench::ByteView{bench::WrittenError(ComErrc{3})}).has_value());
}

}  // namespace

int main() {
    ConstantHandles();
    Results();
    Futures();
    Continuations();
    Specifiers();
    ApplicationErrors();
    CHECK(ara::core::Initialize().HasValue());
    Fields();
    Samples();
    CHECK(ara::core::Deinitialize().HasValue());
    std::cout << "done" << std::endl;
    return 0;
}
