#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "engine/host.h"

namespace gsim::apps {

/// The folder that is served for what was named: a folder as it is, of a file the one in which it lies, and
/// without a name the one that one stands in.
std::filesystem::path served_folder(const std::string& folder, const std::string& program);

/// A file that the command line names, as the page names it: from the folder that is served, or
/// "samples/wheel.nc" of an installation. The error is a sentence: it is not there, or lies elsewhere.
tl::expected<std::string, std::string> served_name(const std::filesystem::path& folder, engine::NameKind kind,
                                                   const std::string& file);

/// A controller module that the command line names: its file. The error is a sentence.
tl::expected<std::string, std::string> served_module(const std::string& name);

}  // namespace gsim::apps
