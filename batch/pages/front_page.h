#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "batch/pages/changes.h"
#include "batch/pages/night.h"

namespace gsim::batch {

/// Maximum of rows in each list on the front page; the number of further rows is printed.
inline constexpr std::size_t kMostListed = 200;

/// Reasons why cases were run again, as markup, by the indices of the cases.
using Whys = std::map<std::size_t, std::string>;

/// Returns the front page: the batch, the changes, the failures, and the first cases of all.
std::string front_page(const Night& night, const Changes& changes, const Whys& whys);

}  // namespace gsim::batch
