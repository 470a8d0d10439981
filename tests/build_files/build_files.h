#pragma once

#include <string>
#include <string_view>

namespace gsim::tests {

// One source has these folders (build_files.cpp.in). As definitions on the command line of each test they
// would make a compiler cache miss in every other clone.

/// The path of a file of the source tree: `source_path("samples/wheel.nc")`. The root itself with no
/// argument.
std::string source_path(std::string_view relative = {});
/// The path of a file of the build folder: `build_path("lib/test_modules/answers.so")`.
std::string build_path(std::string_view relative);
/// The path of a program of this build: `program_path("gsim-run")`.
std::string program_path(std::string_view name);
/// The controller module that has the planner of this build.
std::string default_module_path();

}  // namespace gsim::tests
