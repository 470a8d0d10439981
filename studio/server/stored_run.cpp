#include "studio/server/stored_run.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace gsim::studio {

namespace {

constexpr std::size_t kMaxRuns = 4;
constexpr std::size_t kMinMessageBytes = 8;

/// Returns a folder for long files: it must be on a disk, because /tmp may be in memory.
const char* large_temporary_folder() {
    const char* const temporary_folder = std::getenv("TMPDIR");
    return temporary_folder != nullptr ? temporary_folder : "/var/tmp";
}

/// Reads all bytes; false: they do not exist, or not yet.
bool read_all(int file, char* bytes, std::size_t size, std::uint64_t at) {
    while (size > 0) {
        const ssize_t bytes_read = ::pread(file, bytes, size, static_cast<off_t>(at));
        if (bytes_read < 0 && errno == EINTR) continue;
        if (bytes_read <= 0) return false;
        bytes += bytes_read;
        at += static_cast<std::uint64_t>(bytes_read);
        size -= static_cast<std::size_t>(bytes_read);
    }
    return true;
}

}  // namespace

Result<std::shared_ptr<StoredRun>> StoredRun::make() {
    const char* const folder = large_temporary_folder();
    os::Descriptor file(::open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
    if (file.number() < 0)
        return tl::unexpected(std::string("the run cannot be stored in '") + folder +
                              "': " + std::generic_category().message(errno));
    return std::make_shared<StoredRun>(std::move(file));
}

std::optional<std::string> StoredRun::message(std::size_t index) {
    const std::lock_guard lock(mutex_);
    const auto abs_error_at = [this](std::uint64_t at) {
        std::uint32_t size = 0;
        return read_all(file_.number(), reinterpret_cast<char*>(&size), sizeof size, at) ? size : 0;
    };
    while (message_offsets_.size() <= index + 1) {
        const std::uint32_t size = abs_error_at(message_offsets_.back());
        if (size < kMinMessageBytes) return std::nullopt;
        message_offsets_.push_back(message_offsets_.back() + size);
    }
    std::string bytes(message_offsets_[index + 1] - message_offsets_[index], '\0');
    if (!read_all(file_.number(), bytes.data(), bytes.size(), message_offsets_[index])) return std::nullopt;
    return bytes;
}

Result<std::shared_ptr<StoredRun>> StoredRuns::add(const std::string& name) {
    auto run = StoredRun::make();
    if (!run) return run;
    const std::lock_guard lock(mutex_);
    runs_.remove_if([&name](const NamedRun& each) { return each.name == name; });
    runs_.push_back({name, *run});
    if (runs_.size() > kMaxRuns) runs_.pop_front();
    return run;
}

std::shared_ptr<StoredRun> StoredRuns::find(const std::string& name) {
    const std::lock_guard lock(mutex_);
    const auto found =
        std::find_if(runs_.begin(), runs_.end(), [&name](const NamedRun& each) { return each.name == name; });
    return found == runs_.end() ? nullptr : found->run;
}

void StoredRuns::drop(const std::shared_ptr<StoredRun>& run) {
    const std::lock_guard lock(mutex_);
    runs_.remove_if([&run](const NamedRun& each) { return each.run == run; });
}

}  // namespace gsim::studio
