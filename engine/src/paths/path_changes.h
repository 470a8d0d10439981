#pragma once

#include <string>

#include "base/error.h"
#include "codegen/post/post.h"
#include "engine/path_translation.h"
#include "machine/data/machine_data.h"
#include "machine/model/machine.h"
#include "toolpath/model/source_location.h"

namespace gsim::engine {

/// The origin of the numbers of a path.
struct PathContext {
    const machine::Machine& machine;
    const machine::MachineData* data = nullptr;  ///< Null: work offsets are at the machine's zero.
    const codegen::Post& post;
};

/// Applies the changes of a request to a path that has been read, with complete frames and points. The error
/// names the source location in its file.
Result<void> change_path(path::PathFile& file, const PathContext& context, const PathChanges& changes);

}  // namespace gsim::engine
