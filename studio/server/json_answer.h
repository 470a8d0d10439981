#pragma once

#include <string>

#include <httplib.h>

#include "base/text/json.h"

namespace gsim::studio {

/// Responds with JSON; bytes that are not UTF-8 are replaced.
inline void answer_json(httplib::Response& response, int status, const nlohmann::ordered_json& value) {
    response.status = status;
    response.set_content(value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace),
                         "application/json");
}

/// Responds with {"error": sentence}.
inline void answer_error(httplib::Response& response, int status, const std::string& sentence) {
    answer_json(response, status, {{"error", sentence}});
}

}  // namespace gsim::studio
