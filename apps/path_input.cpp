#include "apps/path_input.h"

#include <cstdio>

#include "runtime/path/json_reader.h"

namespace gsim::apps {

tl::expected<path::PathFile, std::string> read_path(const std::string& name) {
    if (name != "-") return path::load_json(name);
    return path::read_json([](char* buffer, std::size_t size) { return std::fread(buffer, 1, size, stdin); },
                           "stdin");
}

}  // namespace gsim::apps
