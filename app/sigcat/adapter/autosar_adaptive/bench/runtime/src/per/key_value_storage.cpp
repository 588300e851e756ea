#include "ara/per/key_value_storage.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <unistd.h>

namespace ara::per {

namespace {

using Lock = std::lock_guard<std::mutex>;

// A file is: the length of a key, the key, the length of a value, the value; and so on.
void Put(std::string& bytes, const std::string& text) {
    const auto size = static_cast<std::uint32_t>(text.size());
    bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes += text;
}

bool Take(const std::string& bytes, std::size_t& at, std::string& text) {
    std::uint32_t size = 0;
    if (bytes.size() - at < sizeof size) {
        return false;
    }
    std::memcpy(&size, bytes.data() + at, sizeof size);
    at += sizeof size;
    if (bytes.size() - at < size) {
        return false;
    }
    text.assign(bytes, at, size);
    at += size;
    return true;
}

std::string Content(const std::string& name) {
    std::string content;
    if (std::FILE* const file = std::fopen(name.c_str(), "rb"); file != nullptr) {
        char part[4096];
        for (std::size_t got = 1; got > 0;) {
            got = std::fread(part, 1, sizeof part, file);
            content.append(part, got);
        }
        std::fclose(file);
    }
    return content;
}

bool WriteWhole(int file, const std::string& content) {
    std::size_t written = 0;
    while (written < content.size()) {
        const auto now = ::write(file, content.data() + written, content.size() - written);
        if (now <= 0) {
            return false;
        }
        written += static_cast<std::size_t>(now);
    }
    return ::fsync(file) == 0;
}

// Beside the old file first, which is there until the new one is whole.
bool Replace(const std::string& name, const std::string& content) {
    const std::string beside = name + ".new";
    const int file = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file < 0) {
        return false;
    }
    const bool is_whole = WriteWhole(file, content);
    return (::close(file) == 0) && is_whole && std::rename(beside.c_str(), name.c_str()) == 0;
}

std::string FileOf(const ara::core::InstanceSpecifier& port) {
    const char* const folder = std::getenv("BENCH_STORAGE");
    if (folder == nullptr) {
        return {};
    }
    std::string name{port.ToString()};
    std::replace(name.begin(), name.end(), '/', '.');
    return std::string{folder} + "/" + name;
}

}  // namespace

const char* PerErrorDomain::Message(CodeType code) const noexcept {
    switch (static_cast<Errc>(code)) {
        case Errc::kStorageNotFound:
            return "there is no such storage";
        case Errc::kKeyNotFound:
            return "there is no such key";
        case Errc::kIllegalWriteAccess:
            return "the storage is read only";
        case Errc::kPhysicalStorageFailure:
            return "the file cannot be written";
        case Errc::kIntegrityCorrupted:
            return "the file is damaged";
        case Errc::kDataTypeMismatch:
            return "the value has another type";
    }
    return "error of persistency";
}

const ara::core::ErrorDomain& GetPerErrorDomain() noexcept {
    static const PerErrorDomain domain;
    return domain;
}

ara::core::Result<ara::core::Vector<ara::core::String>> KeyValueStorage::GetAllKeys() const noexcept {
    const Lock lock{mutex_};
    ara::core::Vector<ara::core::String> keys;
    for (const auto& each : values_) {
        keys.push_back(each.first);
    }
    return keys;
}

ara::core::Result<bool> KeyValueStorage::KeyExists(ara::core::StringView key) const noexcept {
    const Lock lock{mutex_};
    return values_.find(key) != values_.end();
}

ara::core::Result<void> KeyValueStorage::RemoveKey(ara::core::StringView key) noexcept {
    const Lock lock{mutex_};
    const auto found = values_.find(key);
    if (found == values_.end()) {
        return ara::core::Result<void>::FromError(PerErrc::kKeyNotFound);
    }
    values_.erase(found);
    return {};
}

ara::core::Result<void> KeyValueStorage::RemoveAllKeys() noexcept {
    const Lock lock{mutex_};
    values_.clear();
    return {};
}

ara::core::Result<void> KeyValueStorage::Get(ara::core::StringView key, void* value, std::size_t size) const noexcept {
    const Lock lock{mutex_};
    const auto found = values_.find(key);
    if (found == values_.end()) {
        return ara::core::Result<void>::FromError(PerErrc::kKeyNotFound);
    }
    if (found->second.size() != size) {
        return ara::core::Result<void>::FromError(PerErrc::kDataTypeMismatch);
    }
    std::memcpy(value, found->second.data(), size);
    return {};
}

ara::core::Result<void> KeyValueStorage::Set(ara::core::StringView key, const void* value, std::size_t size) noexcept {
    const Lock lock{mutex_};
    values_[std::string{key}].assign(static_cast<const char*>(value), size);
    return {};
}

ara::core::Result<void> KeyValueStorage::SyncToStorage() const noexcept {
    const Lock lock{mutex_};
    std::string content;
    for (const auto& each : values_) {
        Put(content, each.first);
        Put(content, each.second);
    }
    if (!file_.empty() && !Replace(file_, content)) {
        return ara::core::Result<void>::FromError(PerErrc::kPhysicalStorageFailure);
    }
    return {};
}

ara::core::Result<void> KeyValueStorage::DiscardPendingChanges() noexcept {
    const Lock lock{mutex_};
    const std::string content = Content(file_);
    Values values;
    std::string key;
    for (std::size_t at = 0; at < content.size();) {
        if (!Take(content, at, key) || !Take(content, at, values[key])) {
            return ara::core::Result<void>::FromError(PerErrc::kIntegrityCorrupted);
        }
    }
    values_ = std::move(values);
    return {};
}

ara::core::Result<SharedHandle<KeyValueStorage>> OpenKeyValueStorage(const ara::core::InstanceSpecifier& kvs) noexcept {
    auto storage = std::make_shared<KeyValueStorage>(FileOf(kvs));
    const auto read = storage->DiscardPendingChanges();
    if (!read) {
        return ara::core::Result<SharedHandle<KeyValueStorage>>{read.Error()};
    }
    return SharedHandle<KeyValueStorage>{std::move(storage)};
}

}  // namespace ara::per
