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

PathError unreadable(std::string sentence) {
    return {.in_path = false, .message = std::move(sentence)};
}

Read judged(tl::expected<path::PathFile, std::string> read) {
    return std::move(read).map_error(
        [](std::string fault) { return PathError{.in_path = true, .message = std::move(fault)}; });
}

// Reads in parts, because a path may be long.
Read read_system_file(const std::string& name) {
    const auto file = os::open_input(name, os::NamedBy::command_line);
    if (!file) return tl::unexpected(unreadable(fmt::format("cannot read '{}': {}", name, file.error())));
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
    std::optional<std::string> fault;
    const auto until_fault = [&](char* buffer, std::size_t size) -> std::size_t {
        if (fault) return 0;
        auto count = read(buffer, size);
        if (count) return *count;
        fault = std::move(count.error());
        return 0;
    };
    auto found = path::read_json(until_fault, name);
    return fault ? tl::unexpected(unreadable(*std::move(fault))) : judged(std::move(found));
}

Read read_path(const os::Files& files, const std::string& name, const script::LuaState::Limits& limits,
               os::CpuLimit* cpu) {
    const bool is_script = std::filesystem::path(name).extension() == ".lua";
    if (!is_script && files.are_of_system()) return read_system_file(name);
    const auto text = is_script ? files.read_text(name, os::NamedBy::command_line)
                                : files.read(name, os::NamedBy::command_line, kMostGivenBytes);
    if (!text) return tl::unexpected(unreadable(text.error()));
    return judged(is_script ? script::run_path_script(*text, name, limits, cpu)
                            : path::read_json(*text, name));
}

}  // namespace gsim::engine
