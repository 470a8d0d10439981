#pragma once

#include <map>
#include <optional>
#include <string>

#include "engine/request.h"

namespace gsim::engine {

/// Returns files by their names, and no others: a program that would read files of the system finds none
/// there.
inline Files given(std::map<std::string, std::string> files) {
    return Files::given([files = std::move(files)](const std::string& name) -> std::optional<std::string> {
        const auto file = files.find(name);
        if (file == files.end()) return std::nullopt;
        return file->second;
    });
}

inline Request make_request(const std::string& program, std::map<std::string, std::string> files) {
    Request request;
    request.program = program;
    request.host.files = given(std::move(files));
    return request;
}

}  // namespace gsim::engine
