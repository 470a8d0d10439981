#pragma once

#include <string>

#include "base/error.h"
#include "base/os/input_file.h"
#include "base/os/output_file.h"
#include "cli/print.h"

namespace gsim::batch {

/// Writes a text to a file, or to standard output for "-"; does nothing if no file is named.
inline Result<void> write_text(const std::string& file, const std::string& text) {
    if (file.empty()) return {};
    if (file != os::kStandardStream) return os::write_file(file, text);
    apps::print(text);
    return {};
}

}  // namespace gsim::batch
