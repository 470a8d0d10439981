#include <cmath>
#include <string_view>

#include "engine/c/handles.h"

namespace gsim::engine {

namespace {

struct TextKey {
    std::string_view key;
    std::string* (*value)(Request&);
};

constexpr TextKey kTextKeys[] = {
    {"program", [](Request& r) { return &r.program; }},
    {"machine", [](Request& r) { return &r.machine; }},
    {"machine_data", [](Request& r) { return &r.machine_data; }},
    {"cell", [](Request& r) { return &r.cell; }},
    {"setup", [](Request& r) { return &r.setup; }},
    {"robots", [](Request& r) { return &r.robots; }},
    {"variables", [](Request& r) { return &r.variables; }},
    {"library", [](Request& r) { return &r.library; }},
    {"probe", [](Request& r) { return &r.probe; }},
    {"dialect", [](Request& r) { return &r.language.dialect; }},
    {"unknown", [](Request& r) { return &r.language.unknown; }},
    {"overrides", [](Request& r) { return &r.overrides.file; }},
};

/// A number, with its minimum and its setter.
struct NumberKey {
    std::string_view key;
    double min;
    double max;
    void (*set)(Request&, double);
};

constexpr double kMaxCount = 1e18;
constexpr double kMaxSeconds = 1e15;

constexpr NumberKey kNumberKeys[] = {
    {"machine_s", 0, kMaxSeconds, [](Request& r, double v) { r.limits.machine_s = v; }},
    {"cpu_s", 0, kMaxSeconds, [](Request& r, double v) { r.limits.cpu_s = v; }},
    {"blocks", 1, kMaxCount, [](Request& r, double v) { r.limits.blocks = static_cast<std::uint64_t>(v); }},
    {"steps", 0, kMaxCount, [](Request& r, double v) { r.limits.steps = static_cast<std::uint64_t>(v); }},
    {"memory_bytes", 1 << 24, kMaxCount,
     [](Request& r, double v) { r.limits.memory_bytes = static_cast<std::uint64_t>(v); }},
    {"passes", 1, 1e6, [](Request& r, double v) { r.execution.passes = static_cast<std::uint64_t>(v); }},
    {"feed_override_percent", 0, 1e6, [](Request& r, double v) { r.overrides.feed_percent = v; }},
    {"rapid_override_percent", 0, 1e6, [](Request& r, double v) { r.overrides.rapid_percent = v; }},
    {"spindle_override_percent", 0, 1e6, [](Request& r, double v) { r.overrides.spindle_percent = v; }},
    {"stop_at_first", 0, 1, [](Request& r, double v) { r.execution.stop_at_first = v != 0; }},
    {"collisions", 0, 1, [](Request& r, double v) { r.collisions = v != 0; }},
    {"block_delete", 0, 1, [](Request& r, double v) { r.execution.block_delete = v != 0; }},
    {"optional_stop", 0, 1, [](Request& r, double v) { r.execution.optional_stop = v != 0; }},
    {"explain", 0, 1, [](Request& r, double v) { r.explain = v != 0; }},
};

Files files_from_callback(gsim_read_file read, void* user) {
    return Files::given([read, user](const std::string& name) -> std::optional<std::string> {
        gsim_bytes bytes;
        if (read(user, name.c_str(), &bytes) == 0) return std::nullopt;
        return std::move(bytes.bytes);
    });
}

}  // namespace

Request make_request(const gsim_request& given) {
    Request request = given.request;
    request.cancel = Cancel();
    if (given.text) request.text = Text(*given.text, given.text_name);
    return request;
}

}  // namespace gsim::engine

using namespace gsim::engine;

gsim_request* gsim_request_create() {
    return new (std::nothrow) gsim_request();
}

void gsim_request_destroy(gsim_request* request) {
    delete request;
}

int32_t gsim_request_set_text(gsim_request* request, const char* key, const char* value) {
    return call_noexcept([&] {
        for (const TextKey& known : kTextKeys) {
            if (known.key != key) continue;
            *known.value(request->request) = value;
            return GSIM_OK;
        }
        return GSIM_FAILED;
    });
}

int32_t gsim_request_set_number(gsim_request* request, const char* key, double value) {
    for (const NumberKey& known : kNumberKeys) {
        if (known.key != key) continue;
        if (!(value >= known.min && value <= known.max)) return GSIM_FAILED;
        known.set(request->request, value);
        return GSIM_OK;
    }
    return GSIM_FAILED;
}

int32_t gsim_request_set_program(gsim_request* request, const char* text, size_t size, const char* name) {
    return call_noexcept([&] {
        request->text.emplace(text, size);
        request->text_name = name;
        return GSIM_OK;
    });
}

int32_t gsim_request_set_files(gsim_request* request, gsim_read_file read, void* user) {
    return call_noexcept([&] {
        request->request.host.files = read == nullptr ? Files() : files_from_callback(read, user);
        return GSIM_OK;
    });
}

int32_t gsim_bytes_append(gsim_bytes* bytes, const void* data, size_t size) {
    return call_noexcept([&] {
        bytes->bytes.append(static_cast<const char*>(data), size);
        return GSIM_OK;
    });
}
