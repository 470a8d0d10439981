#include "engine/src/paths/path_input.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/os/input_file.h"
#include "engine/src/conversions.h"
#include "runtime/script/paths/path_script.h"
#include "toolpath/json/json_reader.h"

namespace gsim::engine {

namespace {

constexpr std::size_t kMaxInputBytes = std::size_t{1} << 30U;

using text::DiagnosticKind;
using Read = tl::expected<path::PathFile, Error>;

tl::unexpected<Error> unreadable_error(const gsim::Error& error) {
    return tl::unexpected(make_error(DiagnosticKind::file, error));
}

// Reads in parts, because a path may be long.
Read read_system_file(const std::string& name) {
    const auto file = os::open_input(name, os::NameSource::command_line);
    if (!file) return unreadable_error(fmt::format("cannot read '{}': {}", name, file.error().message));
    const auto read = [&](char* buffer, std::size_t size) -> tl::expected<std::size_t, std::string> {
        const std::size_t count = std::fread(buffer, 1, size, file->get());
        if (std::ferror(file->get()) == 0) return count;
        return tl::unexpected(
            fmt::format("cannot read '{}': {}", name, std::generic_category().message(errno)));
    };
    return read_path_bytes(read, name);
}

}  // namespace

Error path_error(const gsim::Error& error) {
    Error result = make_error(DiagnosticKind::path, error);
    result.in_program = true;
    return result;
}

// If reading fails, the part read so far is not reported as an erroneous path.
Read read_path_bytes(const PathRequest::ReadBytes& read, const std::string& name) {
    std::optional<std::string> error;
    const auto read_until_error = [&](char* buffer, std::size_t size) -> std::size_t {
        if (error) return 0;
        auto count = read(buffer, size);
        if (count) return *count;
        error = std::move(count.error());
        return 0;
    };
    auto found = path::read_json(read_until_error, name);
    if (error) return unreadable_error(*error);
    return std::move(found).map_error(path_error);
}

Read read_path(const os::Files& files, const std::string& name, const script::LuaState::Limits& limits,
               os::CpuLimit* cpu) {
    const bool is_script = std::filesystem::path(name).extension() == ".lua";
    if (!is_script && files.are_system_files()) return read_system_file(name);
    const auto text = is_script ? files.read_text(name, os::NameSource::command_line)
                                : files.read(name, os::NameSource::command_line, kMaxInputBytes);
    if (!text) return unreadable_error(text.error());
    auto found = is_script ? script::run_path_script(*text, name, limits, cpu) : path::read_json(*text, name);
    return std::move(found).map_error(path_error);
}

}  // namespace gsim::engine
