#pragma once

#include <optional>
#include <string>

#include "base/error.h"

namespace gsim::text {

/// Format of the files that people keep and of reports (docs/versions.md). It rises if a reader of before
/// would misunderstand a new file.
inline constexpr int kFileFormat = 1;

/// Returns an error if a file says that it has another format than kFileFormat.
std::optional<Error> find_format_error(double format);

}  // namespace gsim::text
