#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "collision/cell/cell.h"
#include "geometry/mesh/mesh_file.h"

namespace gsim::cell {

/// Files that a cell file names; empty if it names none.
struct CellFiles {
    std::filesystem::path machine;
    std::filesystem::path machine_data;
};

/// Returns what a cell file says of its machine. The error is "file:line:column: message", as in all of
/// these. `file_name` is for that, and for the files that it names, which are searched in its folder.
Result<CellFiles> read_cell_files(std::string_view toml_text, std::string_view file_name);

/// Reads a cell file (docs/cell-file.md) for a machine, strictly: unknown or unclear content is an error.
/// Also reads the meshes that it names. `conveyors` are names of frames to which things may be attached, in
/// the world at the conveyor position 0; Cell::carried begins with them. `errors`, if given, receives all
/// errors, the first one first.
Result<Cell> read_cell(std::string_view toml_text, std::string_view file_name,
                       const machine::Machine& machine, std::span<const std::string> conveyors = {},
                       const MeshFiles& files = {}, std::vector<std::string>* errors = nullptr);

}  // namespace gsim::cell
