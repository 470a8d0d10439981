#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gsim::codegen {

/// Comments of RS274/NGC that do something: (MSG, text), (DEBUG, ..), (PRINT, ..), (LOG, ..), (LOGOPEN,
/// file), (LOGAPPEND, file), (LOGCLOSE), (PROBEOPEN file), (PROBECLOSE), (ABORT, ..), and those for Python:
/// (PY, ..), (PYRUN, file), (PYRELOAD). In DEBUG, PRINT, LOG and ABORT, #5 and #<name> stand for values, %d,
/// %f and %.4f for how the values behind are written. Appends the call of the library and a blank, or nothing
/// for any other comment. The error is a sentence.
std::optional<std::string> write_active_comment(std::string_view comment, std::string& out);

}  // namespace gsim::codegen
