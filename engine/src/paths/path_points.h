#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "codegen/post/post.h"
#include "machine/data/machine_data.h"
#include "toolpath/model/place.h"

namespace gsim::engine {

/// What says where the fixed and reference points of a path lie.
struct PointTables {
    const machine::Machine& machine;
    const machine::MachineData* data = nullptr;  ///< Null: there are none.
    std::string data_name = {};                  ///< Of their file, for sentences.
};

/// Fills in where the machine points of a path lie: fixed points, and reference points with a name, by the
/// machine data; other reference points as far as the machine file or the machine data have home positions.
/// Axes that paths do not move are left out. Gives what the user should know of them, in sentences. The error
/// is "file:line:column: sentence": nobody knows a fixed point, or the post has no word for the way there.
tl::expected<std::vector<std::string>, std::string> complete_points(path::PathFile& file,
                                                                    const PointTables& tables,
                                                                    const codegen::Post& post);

}  // namespace gsim::engine
