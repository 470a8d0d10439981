#pragma once

#include <string>

namespace gsim::round_trip {

/// A random program of a dialect on X, Y and Z: lines, arcs and rapids under all feed modes, path modes, work
/// offsets, speeds, tools and switches that the dialect has, in a main program and a subprogram.
std::string random_modes(const std::string& dialect, unsigned seed);

}  // namespace gsim::round_trip
