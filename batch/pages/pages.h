#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "batch/pages/views.h"
#include "batch/store/sqlite.h"

namespace gsim::batch {

/// Which pages are wanted.
struct PagesOptions {
    std::string folder;
    std::int64_t since = 0;  ///< Number of the batch to compare with; 0: the last one before.
    std::optional<ViewMaker> views =
        std::nullopt;  ///< Of runs that fail or have changed there are pages, too.
};

/// Writes pages of the latest batch into a folder: a front page, and one for each program. What was written
/// there for a batch before is replaced or removed, other files stay. The same results give the same bytes.
/// The error is a sentence with the name of what cannot be written, or that there is no such batch.
tl::expected<void, std::string> write_pages(Database& results, const PagesOptions& options);

}  // namespace gsim::batch
