#include "batch/work/input_files.h"

#include <utility>

#include <sys/stat.h>

#include "base/os/input_file.h"
#include "batch/work/sha256.h"

namespace gsim::batch {

namespace {

constexpr std::size_t kMaxCachedBytes = std::size_t{64} << 20U;  // of all files that are kept
constexpr std::size_t kMaxFileBytes = std::size_t{2} << 30U;
constexpr std::int64_t kNsPerS = 1'000'000'000;

}  // namespace

std::optional<FileState> file_state(const std::string& name) {
    struct stat info {};
    if (::stat(name.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return std::nullopt;
    return FileState{info.st_dev, info.st_ino, static_cast<std::uint64_t>(info.st_size),
                     info.st_mtim.tv_sec * kNsPerS + info.st_mtim.tv_nsec};
}

std::shared_ptr<const InputFiles::Content> InputFiles::get(const std::string& name) {
    const auto state = file_state(name);
    if (!state) return nullptr;
    if (const auto found = files_.find(name);
        found != files_.end() && found->second.state == *state && found->second.content != nullptr) {
        names_by_last_use_.splice(names_by_last_use_.begin(), names_by_last_use_, found->second.position);
        return found->second.content;
    }
    auto bytes = os::read_input(name, os::NameSource::command_line, kMaxFileBytes);
    if (!bytes) return nullptr;
    std::string hash = sha256(*bytes);
    auto content = std::make_shared<const Content>(Content{*std::move(bytes), hash});
    store(name, {.state = *state, .sha256 = std::move(hash), .content = content, .position = {}});
    return content;
}

std::string InputFiles::file_hash(const std::string& name) {
    const auto state = file_state(name);
    if (!state) return {};
    if (const auto found = files_.find(name); found != files_.end() && found->second.state == *state)
        return found->second.sha256;
    const auto bytes = os::read_input(name, os::NameSource::command_line, kMaxFileBytes);
    if (!bytes) return {};
    std::string hash = sha256(*bytes);
    store(name, {.state = *state, .sha256 = hash, .content = nullptr, .position = {}});
    return hash;
}

void InputFiles::store(const std::string& name, CacheEntry entry) {
    if (const auto old = files_.find(name); old != files_.end() && old->second.content != nullptr) {
        bytes_ -= old->second.content->bytes.size();
        names_by_last_use_.erase(old->second.position);
    }
    if (entry.content != nullptr) {
        bytes_ += entry.content->bytes.size();
        entry.position = names_by_last_use_.insert(names_by_last_use_.begin(), name);
    }
    files_.insert_or_assign(name, std::move(entry));
    while (bytes_ > kMaxCachedBytes && !names_by_last_use_.empty()) evict_oldest();
}

void InputFiles::evict_oldest() {
    CacheEntry& oldest = files_.at(names_by_last_use_.back());
    bytes_ -= oldest.content->bytes.size();
    oldest.content = nullptr;
    names_by_last_use_.pop_back();
}

}  // namespace gsim::batch
