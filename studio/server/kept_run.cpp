#include "studio/server/kept_run.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace gsim::studio {

namespace {

constexpr std::size_t kMostRuns = 4;
constexpr std::size_t kSmallestMessage = 8;

/// Returns a folder for long files: it must be on a disk, because /tmp may be in memory.
const char* folder_of_long_files() {
    const char* const chosen = std::getenv("TMPDIR");
    return chosen != nullptr ? chosen : "/var/tmp";
}

/// Reads all bytes; false: they do not exist, or not yet.
bool read_all(int file, char* bytes, std::size_t size, std::uint64_t at) {
    while (size > 0) {
        const ssize_t got = ::pread(file, bytes, size, static_cast<off_t>(at));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes += got;
        at += static_cast<std::uint64_t>(got);
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

}  // namespace

tl::expected<std::shared_ptr<KeptRun>, std::string> KeptRun::make() {
    const char* const folder = folder_of_long_files();
    os::Descriptor file(::open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
    if (file.number() < 0)
        return tl::unexpected(std::string("the run cannot be kept in '") + folder +
                              "': " + std::generic_category().message(errno));
    return std::make_shared<KeptRun>(std::move(file));
}

std::optional<std::string> KeptRun::message(std::size_t index) {
    const std::lock_guard lock(mutex_);
    const auto size_at = [this](std::uint64_t at) {
        std::uint32_t size = 0;
        return read_all(file_.number(), reinterpret_cast<char*>(&size), sizeof size, at) ? size : 0;
    };
    while (starts_.size() <= index + 1) {
        const std::uint32_t size = size_at(starts_.back());
        if (size < kSmallestMessage) return std::nullopt;
        starts_.push_back(starts_.back() + size);
    }
    std::string bytes(starts_[index + 1] - starts_[index], '\0');
    if (!read_all(file_.number(), bytes.data(), bytes.size(), starts_[index])) return std::nullopt;
    return bytes;
}

tl::expected<std::shared_ptr<KeptRun>, std::string> KeptRuns::add(const std::string& name) {
    auto run = KeptRun::make();
    if (!run) return run;
    const std::lock_guard lock(mutex_);
    runs_.remove_if([&name](const Named& each) { return each.name == name; });
    runs_.push_back({name, *run});
    if (runs_.size() > kMostRuns) runs_.pop_front();
    return run;
}

std::shared_ptr<KeptRun> KeptRuns::find(const std::string& name) {
    const std::lock_guard lock(mutex_);
    const auto found =
        std::find_if(runs_.begin(), runs_.end(), [&name](const Named& each) { return each.name == name; });
    return found == runs_.end() ? nullptr : found->run;
}

void KeptRuns::drop(const std::shared_ptr<KeptRun>& run) {
    const std::lock_guard lock(mutex_);
    runs_.remove_if([&run](const Named& each) { return each.run == run; });
}

}  // namespace gsim::studio
