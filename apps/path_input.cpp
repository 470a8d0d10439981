#include "apps/path_input.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/os/input_file.h"
#include "runtime/path/json_reader.h"
#include "runtime/script/path_script.h"

namespace gsim::apps {

namespace {

using Read = tl::expected<path::PathFile, PathError>;

PathError unreadable(std::string sentence) {
    return {.in_path = false, .message = std::move(sentence)};
}

Read judged(tl::expected<path::PathFile, std::string> read) {
    return std::move(read).map_error(
        [](std::string fault) { return PathError{.in_path = true, .message = std::move(fault)}; });
}

// What was read before reading failed is no path with a mistake.
Read read_stream(std::FILE* stream, const std::string& name) {
    int error = 0;
    const auto read = [&](char* buffer, std::size_t size) {
        const std::size_t count = std::fread(buffer, 1, size, stream);
        if (std::ferror(stream) != 0 && error == 0) error = errno;
        return error == 0 ? count : 0;
    };
    auto found = path::read_json(read, name);
    if (error == 0) return judged(std::move(found));
    return tl::unexpected(
        unreadable(fmt::format("cannot read '{}': {}", name, std::generic_category().message(error))));
}

Read read_file(const std::string& name) {
    const auto file = os::open_input(name, os::NamedBy::command_line);
    if (file) return read_stream(file->get(), name);
    return tl::unexpected(unreadable(fmt::format("cannot read '{}': {}", name, file.error())));
}

}  // namespace

Read read_path(const std::string& name, const script::LuaState::Limits& limits, os::CpuLimit* cpu) {
    if (name == "-") return read_stream(stdin, "stdin");
    if (std::filesystem::path(name).extension() != ".lua") return read_file(name);
    const auto text = os::read_text_file(name, os::NamedBy::command_line);
    if (!text) return tl::unexpected(unreadable(text.error()));
    return judged(script::run_path_script(*text, name, limits, cpu));
}

}  // namespace gsim::apps
