#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace gsim::codegen {

/// Writes comments of RS274/NGC that act: (MSG, text), (DEBUG, ..), (PRINT, ..), (LOG, ..), (LOGOPEN, file),
/// (LOGAPPEND, file), (LOGCLOSE), (PROBEOPEN file), (PROBECLOSE), (ABORT, ..), and those for Python: (PY,
/// ..), (PYRUN, file), (PYRELOAD). In DEBUG, PRINT, LOG and ABORT, #5 and #<name> mean values, and %d, %f and
/// %.4f set the format of the values that follow. Appends the call of the library and a blank; appends no
/// text for any other comment.
Result<void> write_active_comment(std::string_view comment, std::string& out);

}  // namespace gsim::codegen
