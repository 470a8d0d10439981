#include "engine/src/paths/path_input.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/os/input_file.h"
#include "runtime/script/paths/path_script.h"
#include "toolpath/json/json_reader.h"

namespace gsim::engine {

namespace {

constexpr std::size_t kMostGivenBytes = std::size_t{1} << 30U;

using Read = tl::expected<path::PathFile, PathError>;

PathError unreadable_error(std::string message) {
    return {.in_path = false, .message = std::move(message)};
}

Read to_path_error(tl::expected<path::PathFile, std::string> read) {
    return std::move(read).map_error(
        [](std::string error) { return PathError{.in_path = true, .message = std::move(error)}; });
}

// Reads in parts, because a path may be long.
Read read_system_file(const std::string& name) {
    const auto file = os::open_input(name, os::NameSource::command_line);
    if (!file)
        return tl::unexpected(unreadable_error(fmt::format("cannot read '{}': {}", name, file.error())));
    const auto read = [&](char* buffer, std::size_t size) -> tl::expected<std::size_t, std::string> {
        const std::size_t count = std::fread(buffer, 1, size, file->get());
        if (std::ferror(file->get()) == 0) return count;
        return tl::unexpected(
            fmt::format("cannot read '{}': {}", name, std::generic_category().message(errno)));
    };
    return read_path_bytes(read, name);
}

}  // namespace

// After a read error, the part read before is not reported as an erroneous path.
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
    return error ? tl::unexpected(unreadable_error(*std::move(error))) : to_path_error(std::move(found));
}

Read read_path(const os::Files& files, const std::string& name, const script::LuaState::Limits& limits,
               os::CpuLimit* cpu) {
    const bool is_script = std::filesystem::path(name).extension() == ".lua";
    if (!is_script && files.are_system_files()) return read_system_file(name);
    const auto text = is_script ? files.read_text(name, os::NameSource::command_line)
                                : files.read(name, os::NameSource::command_line, kMostGivenBytes);
    if (!text) return tl::unexpected(unreadable_error(text.error()));
    return to_path_error(is_script ? script::run_path_script(*text, name, limits, cpu)
                                   : path::read_json(*text, name));
}

}  // namespace gsim::engine
