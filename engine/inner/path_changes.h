#pragma once

#include <string>

#include <tl/expected.hpp>

#include "engine/path_translation.h"
#include "runtime/machine/machine.h"
#include "runtime/path/place.h"

namespace gsim::engine {

/// Makes the changes of a request in a path that has been read. The error names the place in its file.
tl::expected<void, std::string> change_path(path::PathFile& file, const machine::Machine& machine,
                                            const PathChanges& changes);

}  // namespace gsim::engine
