#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "grammar/dialect.h"

namespace gsim::grammar {

/// Meaning of the name of a dialect, or of a controller.
struct ControllerName {
    const Dialect* dialect = nullptr;
    /// Message with the differences if the controller's own language is only similar to the dialect. Else
    /// empty.
    std::string caution = {};
};

/// Returns the dialect for programs of a controller, by common names: "linuxcnc", "Allen-Bradley",
/// "9/Series", "haas". Upper and lower case, blanks, dots, dashes and slashes do not count. The error is a
/// message.
tl::expected<ControllerName, std::string> find_controller(std::string_view name);

/// Returns all names, the dialects' own first.
std::vector<std::string> controller_names();

/// Returns a table of the names for the documentation: controller, dialect, differences.
std::string controller_table();

}  // namespace gsim::grammar
