#include "batch/work/input_files.h"

#include <utility>

#include <sys/stat.h>

#include "base/os/input_file.h"
#include "batch/work/sha256.h"

namespace gsim::batch {

namespace {

constexpr std::size_t kMaxKeptBytes = std::size_t{64} << 20U;  // of all files that are kept
constexpr std::size_t kMostOfFile = std::size_t{2} << 30U;
constexpr std::int64_t kNsPerS = 1'000'000'000;

}  // namespace

std::optional<FileState> state_of(const std::string& name) {
    struct stat info {};
    if (::stat(name.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return std::nullopt;
    return FileState{info.st_dev, info.st_ino, static_cast<std::uint64_t>(info.st_size),
                     info.st_mtim.tv_sec * kNsPerS + info.st_mtim.tv_nsec};
}

std::shared_ptr<const InputFiles::Content> InputFiles::get(const std::string& name) {
    const auto state = state_of(name);
    if (!state) return nullptr;
    if (const auto found = files_.find(name);
        found != files_.end() && found->second.state == *state && found->second.content != nullptr) {
        used_.splice(used_.begin(), used_, found->second.place);
        return found->second.content;
    }
    auto bytes = os::read_input(name, os::NamedBy::command_line, kMostOfFile);
    if (!bytes) return nullptr;
    std::string hash = sha256(*bytes);
    auto content = std::make_shared<const Content>(Content{*std::move(bytes), hash});
    keep(name, {.state = *state, .sha256 = std::move(hash), .content = content, .place = {}});
    return content;
}

std::string InputFiles::hash_of(const std::string& name) {
    const auto state = state_of(name);
    if (!state) return {};
    if (const auto found = files_.find(name); found != files_.end() && found->second.state == *state)
        return found->second.sha256;
    const auto bytes = os::read_input(name, os::NamedBy::command_line, kMostOfFile);
    if (!bytes) return {};
    std::string hash = sha256(*bytes);
    keep(name, {.state = *state, .sha256 = hash, .content = nullptr, .place = {}});
    return hash;
}

void InputFiles::keep(const std::string& name, Kept kept) {
    if (const auto old = files_.find(name); old != files_.end() && old->second.content != nullptr) {
        bytes_ -= old->second.content->bytes.size();
        used_.erase(old->second.place);
    }
    if (kept.content != nullptr) {
        bytes_ += kept.content->bytes.size();
        kept.place = used_.insert(used_.begin(), name);
    }
    files_.insert_or_assign(name, std::move(kept));
    while (bytes_ > kMaxKeptBytes && !used_.empty()) forget_oldest();
}

void InputFiles::forget_oldest() {
    Kept& oldest = files_.at(used_.back());
    bytes_ -= oldest.content->bytes.size();
    oldest.content = nullptr;
    used_.pop_back();
}

}  // namespace gsim::batch
