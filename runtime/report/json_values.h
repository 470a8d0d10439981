#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "base/text/json.h"
#include "base/text/json_text.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

// Values of reports as JSON.

using Json = nlohmann::ordered_json;

inline Json number(double value) {
    return std::isfinite(value) ? Json(text::rounded(value)) : Json(nullptr);
}

inline Json number(const std::optional<double>& value) {
    return value ? number(*value) : Json(nullptr);
}

inline Json file(const Report& report, const SourceLocation& location) {
    return location.file < report.source.files.size() ? Json(report.source.files[location.file])
                                                      : Json(nullptr);
}

inline Json line(const SourceLocation& location) {
    return location.line > 0 ? Json(location.line) : Json(nullptr);
}

inline Json letter(char axis) {
    return Json(std::string(1, axis));
}

}  // namespace gsim::simulation
