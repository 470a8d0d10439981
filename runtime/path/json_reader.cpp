#include "runtime/path/json_reader.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "runtime/path/json_handler.h"
#include "runtime/path/validate.h"

namespace gsim::path {

namespace {

/// Of a path file: some millions of points, which take some times as much memory.
constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 30U;

}  // namespace

tl::expected<PathFile, std::string> read_json(std::function<std::size_t(char*, std::size_t)> read,
                                              std::string file_name) {
    std::uint64_t size = 0;
    const auto bounded = [&size, &read](char* buffer, std::size_t capacity) {
        const std::size_t count = read(buffer, capacity);
        size += count;
        return size > kMaxBytes ? 0 : count;
    };
    // Not on the stack: it holds a large buffer.
    const auto bytes = std::make_unique<JsonBytes>(bounded);
    JsonHandler handler(*bytes, file_name);
    const bool parsed =
        nlohmann::json::sax_parse(JsonBytes::Iterator(*bytes), JsonBytes::Iterator(), &handler);
    if (size > kMaxBytes)
        return tl::unexpected(fmt::format("{}: paths of up to {} MiB are read", file_name, kMaxBytes >> 20U));
    if (!parsed) {
        return tl::unexpected(handler.error());
    }
    tl::expected<PathFile, std::string> file = handler.finish();
    if (!file) return file;
    if (const auto fault = validate(file->program)) {
        return tl::unexpected(file->located(fault->where, fault->sentence));
    }
    return file;
}

tl::expected<PathFile, std::string> read_json(std::string_view text, std::string file_name) {
    const auto read = [&text](char* buffer, std::size_t size) {
        const std::size_t count = text.copy(buffer, size);
        text.remove_prefix(count);
        return count;
    };
    return read_json(read, std::move(file_name));
}

tl::expected<PathFile, std::string> load_json(const std::filesystem::path& path, os::NamedBy named_by) {
    const auto cannot_read = [&path](const std::string& why) {
        return tl::unexpected(fmt::format("cannot read '{}': {}", path.string(), why));
    };
    const auto file = os::open_input(path, named_by);
    if (!file) return cannot_read(file.error());
    auto read = [&file](char* buffer, std::size_t size) { return std::fread(buffer, 1, size, file->get()); };
    tl::expected<PathFile, std::string> result = read_json(read, path.string());
    if (std::ferror(file->get()) != 0) return cannot_read(std::generic_category().message(errno));
    return result;
}

}  // namespace gsim::path
