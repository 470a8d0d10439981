#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/machine/machine_data_document.h"

namespace gsim::apps {

/// Reads a file of machine data. The errors are sentences: what is wrong with its lines, each with its place,
/// or why there is no such file.
tl::expected<machine::MachineDataDocument, std::vector<std::string>> open_machine_data(
    const std::string& path, std::span<const machine::Axis> axes);

/// Writes a file so that at each moment either the old one or the new one stands there whole, also when the
/// power fails: beside it, to the disk, then renamed. Permissions stay; where the name is a symbolic link,
/// its target is replaced. The error is a sentence.
tl::expected<void, std::string> save_text(const std::string& path, std::string_view text);

}  // namespace gsim::apps
