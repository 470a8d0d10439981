#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "batch/pages/changes.h"
#include "batch/pages/night.h"

namespace gsim::batch {

/// Rows of each list on the front page; how many more there are is said.
inline constexpr std::size_t kMostListed = 200;

/// Why cases were run anew, as markup, by their places.
using Whys = std::map<std::size_t, std::string>;

/// The front page: the batch, what has changed, what fails, and the first cases of all.
std::string front_page(const Night& night, const Changes& changes, const Whys& whys);

}  // namespace gsim::batch
