#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/error.h"
#include "batch/pages/views.h"
#include "batch/store/sqlite.h"

namespace gsim::batch {

/// Selection of pages.
struct PagesOptions {
    std::string folder;
    std::int64_t since = 0;  ///< Number of the batch to compare with; 0: the last one before.
    std::optional<ViewGenerator> views =
        std::nullopt;  ///< Set: runs that fail or have changed get pages, too.
};

/// Writes pages of the latest batch into a folder: a front page, and one for each program. Pages of a
/// previous batch are replaced or removed, other files stay. The same results give the same bytes. The error
/// is a message that names the file that cannot be written, or says that no such batch exists.
Result<void> write_pages(Database& results, const PagesOptions& options);

}  // namespace gsim::batch
