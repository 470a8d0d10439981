#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"
#include "base/os/files.h"
#include "cam/drawing/drawing.h"

namespace gsim::drawing {

/// Reads a drawing by its file name extension, .dxf or .svg. The error names the file.
Result<Drawing> read_drawing(const std::filesystem::path& path, const ReadOptions& options,
                             os::NameSource name_source = os::NameSource::in_file,
                             const os::Files& files = os::disk());

}  // namespace gsim::drawing
