#pragma once

#include <memory>
#include <span>
#include <string>

#include "base/error.h"
#include "engine/host.h"
#include "geometry/mesh/mesh_file.h"
#include "runtime/monitors/cell_monitor.h"

namespace gsim::engine {

/// The bodies that a run or a study of a machine checks.
struct CellSource {
    std::string file;        ///< The cell file; empty: none, the machine's own bodies alone.
    std::string text;        ///< Its contents.
    bool collisions = true;  ///< Else bodies are not looked at.
    cell::MeshFiles files = {};
    /// The cell of a run that was read before, by read_cell_contents(); null: not yet read.
    std::shared_ptr<const cell::Cell> read = nullptr;
};

/// Returns the source of meshes.
cell::MeshFiles mesh_files(const Host& host);

/// Returns the bodies to check. It reads meshes of the machine; the error is a message.
Result<cell::Cell> read_bodies(const CellSource& cell_source, const machine::Machine& machine);

/// Returns the contents of the cell of a run. `conveyors` as in cell::read_cell().
Result<cell::Cell> read_cell_contents(const CellSource& cell_source, const machine::Machine& machine,
                                      std::span<const std::string> conveyors = {});

/// Returns the cell of a run, which has at least the frames of the machine.
Result<std::unique_ptr<simulation::CellMonitor>> make_cell_monitor(
    const CellSource& cell_source, const machine::Machine& machine,
    std::span<const std::string> conveyors = {});

}  // namespace gsim::engine
