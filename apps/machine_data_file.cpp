#include "apps/machine_data_file.h"

#include <cerrno>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "runtime/machine/text_file.h"
#include "runtime/simulation/output_file.h"

namespace gsim::apps {

namespace {

// What no disk is (a pipe, a terminal) has nothing to wait for.
bool reach_disk(std::FILE* file) {
    if (std::fflush(file) != 0) return false;
    return ::fsync(::fileno(file)) == 0 || errno == EINVAL || errno == EROFS;
}

}  // namespace

tl::expected<machine::MachineDataDocument, std::vector<std::string>> open_machine_data(
    const std::string& path, std::span<const machine::Axis> axes) {
    const auto text = machine::read_text_file(path);
    if (!text) return tl::unexpected(std::vector{text.error()});
    return machine::MachineDataDocument::read(*text, path, axes);
}

tl::expected<void, std::string> save_text(const std::string& path, std::string_view text) {
    tl::expected<simulation::OutputFile, std::string> file = simulation::OutputFile::open(path);
    if (!file) return tl::unexpected(std::move(file.error()));
    std::fwrite(text.data(), 1, text.size(), file->stream());
    if (!reach_disk(file->stream())) {
        return tl::unexpected(
            fmt::format("cannot write '{}': {}", path, std::generic_category().message(errno)));
    }
    return file->commit();
}

}  // namespace gsim::apps
