// Engine in a page's worker: exports one function for requests, and calls two functions of the page.

#include <cstdlib>
#include <optional>
#include <string>

#include <emscripten.h>

#include "studio/engine/session.h"

// The page allocates its response by malloc(); 0: the file does not exist.
EM_JS(char*, studio_read, (const char* name, double* size), {
    const bytes = Module["readFile"](UTF8ToString(name));
    if (!bytes) return 0;
    const place = _malloc(bytes.length + 1);
    if (!place) throw new Error("out of memory: a file of " + bytes.length + " bytes");
    HEAPU8.set(bytes, place);
    HEAPF64[size >> 3] = bytes.length;
    return place;
});

EM_JS(void, studio_send_message, (const char* bytes, double size),
      { Module["post"](HEAPU8.slice(bytes >>> 0, (bytes >>> 0) + size)); });

namespace {

std::optional<std::string> read_file(const std::string& name) {
    double size = 0;
    char* const bytes = studio_read(name.c_str(), &size);
    if (bytes == nullptr) return std::nullopt;
    std::string text(bytes, static_cast<std::size_t>(size));
    std::free(bytes);
    return text;
}

}  // namespace

extern "C" EMSCRIPTEN_KEEPALIVE void gsim_studio_serve(const char* request_json) {
    gsim::engine::Host host;
    host.files = gsim::engine::Files::given(read_file);
    gsim::studio::handle_request(request_json, host, [](const std::string& bytes) {
        studio_send_message(bytes.data(), static_cast<double>(bytes.size()));
    });
}
