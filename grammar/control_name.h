#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "grammar/dialect.h"

namespace gsim::grammar {

/// What the name of a dialect, or of a control, means.
struct ControlName {
    const Dialect* dialect = nullptr;
    /// Where the control's own language is only near to the dialect: what to mind, as a sentence. Else empty.
    std::string caution = {};
};

/// The dialect for programs of a control, by names as people write them: "linuxcnc", "Allen-Bradley",
/// "9/Series", "haas". Upper and lower case, blanks, dots, dashes and slashes do not count. The error is a
/// sentence.
tl::expected<ControlName, std::string> control_named(std::string_view name);

/// All names, the dialects' own first.
std::vector<std::string> control_names();

/// A table of the names for the documentation: control, dialect, what to mind.
std::string control_table();

}  // namespace gsim::grammar
