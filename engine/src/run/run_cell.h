#pragma once

#include <memory>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "engine/host.h"
#include "geometry/mesh/mesh_file.h"
#include "runtime/monitors/cell_watch.h"

namespace gsim::engine {

/// What a run or a study of a machine is to look at.
struct CellChoice {
    std::string file;        ///< The cell file; empty: none, the machine's own bodies alone.
    std::string text;        ///< What stands in it.
    bool collisions = true;  ///< Else bodies are not looked at.
    cell::MeshFiles files = {};
    /// The cell of a run as it was read before, by read_cell_of_run(); null: it is to be read.
    std::shared_ptr<const cell::Cell> read = nullptr;
};

/// Where meshes come from.
cell::MeshFiles mesh_files(const Host& host);

/// The bodies to look at. Meshes of the machine are read here; the error is a sentence.
tl::expected<cell::Cell, std::string> read_bodies(const CellChoice& choice, const machine::Machine& machine);

/// What the cell of a run consists of. `conveyors` as in cell::load_cell(). The error is a sentence.
tl::expected<cell::Cell, std::string> read_cell_of_run(const CellChoice& choice,
                                                       const machine::Machine& machine,
                                                       std::span<const std::string> conveyors = {});

/// The cell of a run, which has the frames of the machine at least. The error is a sentence.
tl::expected<std::unique_ptr<simulation::CellWatch>, std::string> read_run_cell(
    const CellChoice& choice, const machine::Machine& machine, std::span<const std::string> conveyors = {});

}  // namespace gsim::engine
