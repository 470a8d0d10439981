#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::os {

/// What a process may still reach of the file system. Names of what does not exist count for nothing.
struct Allowed {
    std::vector<std::filesystem::path> read;     ///< Files, and folders with all in them.
    std::vector<std::filesystem::path> run;      ///< Folders with programs and what these read.
    std::vector<std::filesystem::path> written;  ///< Files that may be written but not made or removed.
    /// Folders in which files may be made, written, renamed and removed.
    std::vector<std::filesystem::path> changed;
};

/// Gives up everything else for the rest of the process and for those that it begins: no other file can be
/// opened, made, renamed or removed, no program run, no network port bound or connected to, and no process
/// outside of it gets a signal. What is open stays open. There is no way back.
/// Source: landlock(7) of Linux.
/// False where the system has no such thing. The error is a sentence: it has, and refuses.
tl::expected<bool, std::string> confine(const Allowed& allowed);

}  // namespace gsim::os
