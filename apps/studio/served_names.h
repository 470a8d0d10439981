#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"
#include "engine/host.h"

namespace gsim::apps {

/// Returns the folder to serve: a named folder itself, the folder that contains a named file, or without a
/// name the working directory.
std::filesystem::path served_folder(const std::string& folder, const std::string& program);

/// Returns the page's name of a file that the command line names: relative to the served folder, or
/// "samples/wheel.nc" of an installation. The error is a message: the file does not exist, or lies elsewhere.
Result<std::string> served_name(const std::filesystem::path& folder, engine::NameKind kind,
                                const std::string& file);

/// Returns the file of a controller module that the command line names.
Result<std::string> served_module(const std::string& name);

}  // namespace gsim::apps
