#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::solid {

/// Runs gsim-solid, the program that reads STEP and IGES files through OpenCASCADE, on a file: the packet
/// that it answers with. It is a process of its own because OpenCASCADE crashes on some damaged files, prints
/// to standard output, keeps global state, and takes 40 ms to load, which programs that read no such file
/// need not wait for.
///
/// The error is a sentence that names the file: it is not there, or too large, or gsim-solid says what is
/// wrong with it, or crashed, or this build has no gsim-solid.
tl::expected<std::string, std::string> ask_reader(const std::string& question,
                                                  const std::filesystem::path& file,
                                                  const std::vector<std::string>& settings);

}  // namespace gsim::solid
