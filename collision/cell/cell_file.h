#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "collision/cell/cell.h"
#include "geometry/mesh/mesh_file.h"

namespace gsim::cell {

/// The files that a cell file names; empty where it names none.
struct CellFiles {
    std::filesystem::path machine;
    std::filesystem::path machine_data;
};

/// What a cell file says of its machine. The error is "file:line:column: sentence", as in all of these.
/// `file_name` is for that, and for the files that it names, which are looked for in its folder.
tl::expected<CellFiles, std::string> read_cell_files(std::string_view toml_text, std::string_view file_name);

/// Reads a cell file (docs/cell-file.md) for a machine, strictly: what it does not know or does not
/// understand is an error. Reads the meshes that it names, too. `conveyors` are names of frames, in the world
/// where those stand at 0, to which things may be attached; Cell::carried begins with them. `faults`, where
/// given, gets all that is wrong, each as an error and the first one first.
tl::expected<Cell, std::string> read_cell(std::string_view toml_text, std::string_view file_name,
                                          const machine::Machine& machine,
                                          std::span<const std::string> conveyors = {},
                                          const MeshFiles& files = {},
                                          std::vector<std::string>* faults = nullptr);

}  // namespace gsim::cell
