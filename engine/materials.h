#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "engine/api.h"
#include "engine/diagnostic.h"
#include "engine/host.h"

namespace gsim::engine {

/// A material that a jet cuts (docs/waterjet.md).
struct CuttingMaterial {
    std::string name = {};
    double machinability = 0;  ///< Without unit: the higher, the faster it is cut.
    std::string like = {};     ///< The material with the same machinability; empty: it has its own.
    bool measured = false;     ///< The machinability follows from a cut that was tried.
    std::string source = {};   ///< Source of the number; may be empty.
};

/// Returns the materials of a file as CuttingOptions::materials names it, in its order.
GSIM_API tl::expected<std::vector<CuttingMaterial>, Error> cutting_materials(const Host& host,
                                                                             const std::string& file = {});

}  // namespace gsim::engine
