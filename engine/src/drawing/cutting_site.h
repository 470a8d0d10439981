#pragma once

#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cam/cutting/autopath.h"
#include "engine/diagnostic.h"
#include "engine/drawing_path.h"

namespace gsim::engine {

/// The machine that is to cut, and what stands round it.
class CuttingSite {
  public:
    /// Reads machine, machine data and cell, with all their meshes.
    static tl::expected<CuttingSite, Failure> read(const Host& host, const CuttingPlace& place);
    CuttingSite(CuttingSite&&) noexcept;
    CuttingSite& operator=(CuttingSite&&) noexcept;
    ~CuttingSite();

    /// What of a control's settings is not taken over, and that nothing is looked at where there are no
    /// bodies, in sentences.
    const std::vector<std::string>& notes() const;
    /// Leads the ways between cuts past what stands there, and notes how many. The error is a sentence, or
    /// several lines: cuts that the machine does not reach, that something is in the way of, ways that were
    /// not found.
    tl::expected<void, std::string> clear_ways(cutting::Autopath& made, CuttingFigures& figures) const;

  private:
    struct Parts;
    explicit CuttingSite(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

}  // namespace gsim::engine
