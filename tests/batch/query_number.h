#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "batch/store/sqlite.h"

namespace gsim::batch {

/// Returns the one number that a query of a file of results yields, or none as long as the file or table is
/// missing.
inline std::optional<double> one_number(const std::filesystem::path& file, const std::string& query) {
    auto results = Database::open(file.string(), true);
    if (!results) return std::nullopt;
    auto statement = results->prepare(query);
    if (!statement || !statement->step().value_or(false)) return std::nullopt;
    return statement->number(0);
}

}  // namespace gsim::batch
