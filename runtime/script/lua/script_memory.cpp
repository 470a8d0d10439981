#include "runtime/script/lua/script_memory.h"

#include <string_view>

#include <fmt/format.h>

namespace gsim::script {

namespace {

std::string megabytes(std::size_t bytes) {
    constexpr double kMegabyte = 1U << 20U;
    constexpr std::size_t kSmall = std::size_t{100} << 10U;
    return bytes < kSmall ? fmt::format("{} bytes", bytes)
                          : fmt::format("{:.1f} MB", static_cast<double>(bytes) / kMegabyte);
}

}  // namespace

void ScriptMemory::reject(const char* what, std::size_t requested_bytes, bool is_system_failure) {
    is_rejected_ = true;
    error_ = {what, requested_bytes, bytes_, is_system_failure};
    if (const char* max = largest_memory_user(); max != nullptr && requested_bytes < bytes_ / 2)
        error_.what = max;
}

void ScriptMemory::add_external(std::size_t bytes, const char* what) {
    external_bytes(what) += bytes;
    bytes_ += bytes;
}

void ScriptMemory::release_external(std::size_t bytes, const char* what) {
    external_bytes(what) -= bytes;
    bytes_ -= bytes;
}

std::size_t& ScriptMemory::external_bytes(const char* what) {
    const auto found = std::find_if(external_.begin(), external_.end(), [what](const External& each) {
        return std::string_view(each.what) == what;
    });
    return found != external_.end() ? found->bytes : external_.emplace_back(External{what, 0}).bytes;
}

/// Returns what holds more than half of the memory outside of Lua, or null. That is reported as the consumer
/// that needs too much, even if another one requests the last part.
const char* ScriptMemory::largest_memory_user() const {
    for (const External& each : external_) {
        if (each.bytes > bytes_ / 2) return each.what;
    }
    return nullptr;
}

std::string ScriptMemory::error() const {
    const std::string amounts =
        fmt::format("{} are used, and {} more are requested", megabytes(error_.retained_bytes),
                    megabytes(error_.requested_bytes));
    if (error_.is_system_failure)
        return fmt::format("{} needs more memory than the system provides: {}", error_.what, amounts);
    return fmt::format("{} needs more memory than the run may use, {} MB (--memory): {}", error_.what,
                       limit_bytes_ >> 20U, amounts);
}

}  // namespace gsim::script
