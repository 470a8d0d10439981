#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "batch/pages/nightly_report.h"

namespace gsim::batch {

inline constexpr const char* kFrontPage = "index.html";

/// Returns the part of the table of all cases on a page, counted from 0, and links to the other parts.
std::string cases_text(const NightlyReport& report, std::size_t part);

/// Returns the pages of the further parts, by their names: the front page has the first one.
std::vector<std::pair<std::string, std::string>> additional_pages(const NightlyReport& report);

}  // namespace gsim::batch
