#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "batch/pages/changes.h"
#include "batch/pages/nightly_report.h"

namespace gsim::batch {

/// Maximum of rows in each list on the front page; the number of further rows is printed.
inline constexpr std::size_t kMaxListed = 200;

/// Reasons why cases were run again, as markup, by the indices of the cases.
using ReasonsByCase = std::map<std::size_t, std::string>;

/// Returns the front page: the batch, the changes, the failures, and the first cases of all.
std::string front_page(const NightlyReport& report, const Changes& changes,
                       const ReasonsByCase& reasons_by_case);

}  // namespace gsim::batch
