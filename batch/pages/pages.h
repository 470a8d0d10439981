#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include "batch/store/sqlite.h"

namespace gsim::batch {

/// Writes pages of the latest batch into a folder: a front page, and one for each program. `since` is the
/// number of the batch that it is compared with, 0: the last one before. What was written there for a batch
/// before is replaced or removed, other files stay. The same results give the same bytes. The error is a
/// sentence with the name of what cannot be written, or that there is no such batch.
tl::expected<void, std::string> write_pages(Database& results, const std::string& folder, std::int64_t since);

}  // namespace gsim::batch
