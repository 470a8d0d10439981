#pragma once

#include <string>

#include "base/error.h"
#include "cam/solid/plate.h"
#include "engine/drawing_path.h"

namespace gsim::engine {

/// Reads a drawing, or a flat part through the host. The error is a message: why it cannot be read, or which
/// option is not for such a file.
Result<solid::Plate> read_drawing_input(const Host& host, const std::string& file,
                                        const DrawingOptions& drawing_options);

}  // namespace gsim::engine
