#pragma once

#include <string>

#include <tl/expected.hpp>

#include "engine/contours.h"

namespace gsim::engine {

/// Implements Host::read_contours with the program that reads STEP and IGES files.
tl::expected<Contours, std::string> read_contours(const std::string& file, const ContourSelection& selection);

}  // namespace gsim::engine
