#include "toolpath/json/json_reader.h"

#include <cstdint>
#include <memory>

#include <fmt/format.h>

#include "toolpath/json/json_handler.h"
#include "toolpath/model/validate.h"

namespace gsim::path {

namespace {

/// Max size of a path file: some millions of points, which take several times as much memory.
constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 30U;

}  // namespace

Result<PathFile> read_json(std::function<std::size_t(char*, std::size_t)> read, std::string file_name) {
    std::uint64_t size = 0;
    const auto bounded = [&size, &read](char* buffer, std::size_t capacity) {
        const std::size_t count = read(buffer, capacity);
        size += count;
        return size > kMaxBytes ? 0 : count;
    };
    // Not on the stack, because it holds a large buffer.
    const auto bytes = std::make_unique<JsonBytes>(bounded);
    JsonHandler handler(*bytes, file_name);
    const bool parsed =
        nlohmann::json::sax_parse(JsonBytes::Iterator(*bytes), JsonBytes::Iterator(), &handler);
    if (size > kMaxBytes)
        return Unexpected(
            fmt::format("{}: the maximum size of a path file is {} MiB", file_name, kMaxBytes >> 20U));
    if (!parsed) {
        return tl::unexpected(handler.error());
    }
    Result<PathFile> file = handler.finish();
    if (!file) return file;
    if (const auto error = validate(file->program)) {
        return tl::unexpected(file->with_location(error->where, error->message));
    }
    return file;
}

Result<PathFile> read_json(std::string_view text, std::string file_name) {
    const auto read = [&text](char* buffer, std::size_t size) {
        const std::size_t count = text.copy(buffer, size);
        text.remove_prefix(count);
        return count;
    };
    return read_json(read, std::move(file_name));
}

}  // namespace gsim::path
