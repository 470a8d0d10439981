#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "codegen/post/post.h"
#include "machine/data/machine_data.h"
#include "toolpath/model/source_location.h"

namespace gsim::engine {

/// Sources for the positions of the fixed and reference points of a path.
struct PointTables {
    const machine::Machine& machine;
    const machine::MachineData* data = nullptr;  ///< Null: none.
    std::string data_name = {};                  ///< Name of their file, for messages.
};

/// Sets the positions of the machine points of a path. The machine data define fixed points, and reference
/// points with a name. For other reference points, the machine file or the machine data may have home
/// positions. Axes that paths do not move are left out. Returns messages for the user about them. The error
/// is "file:line:column: message": an unknown fixed point, or the post has no word for the path to it.
Result<std::vector<std::string>> complete_points(path::PathFile& file, const PointTables& tables,
                                                 const codegen::Post& post);

}  // namespace gsim::engine
