#pragma once

#include <string>

#include <httplib.h>

#include "base/text/json.h"

namespace gsim::studio {

/// Responds with JSON; bytes that are not UTF-8 are replaced.
inline void respond_json(httplib::Response& response, int status, const nlohmann::ordered_json& value) {
    response.status = status;
    response.set_content(value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace),
                         "application/json");
}

/// Responds with {"error": message}.
inline void respond_error(httplib::Response& response, int status, const std::string& message) {
    respond_json(response, status, {{"error", message}});
}

}  // namespace gsim::studio
