#pragma once

#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/error.h"
#include "cam/cutting/autopath.h"
#include "engine/diagnostic.h"
#include "engine/drawing_path.h"

namespace gsim::engine {

/// The cutting machine and its surroundings.
class CuttingCell {
  public:
    /// Reads machine, machine data and cell, with all their meshes.
    static tl::expected<CuttingCell, Error> read(const Host& host, const CuttingCellOptions& work_cell);
    CuttingCell(CuttingCell&&) noexcept;
    CuttingCell& operator=(CuttingCell&&) noexcept;
    ~CuttingCell();

    /// Returns messages about the controller's settings that are not imported, and about missing bodies,
    /// without which no check is made.
    const std::vector<std::string>& notes() const;
    /// Reroutes the moves between cuts past the surroundings, and counts them. The error is a message, or
    /// several lines: cuts that the machine does not reach, cuts with obstacles, paths that were not found.
    Result<void> avoid_collisions(cutting::Autopath& autopath_result, CuttingMetrics& metrics) const;

  private:
    struct Parts;
    explicit CuttingCell(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

}  // namespace gsim::engine
