#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"

namespace gsim::os {

/// Sandbox policy: the parts of the file system that a process may still access. Names that do not exist are
/// ignored.
struct SandboxPolicy {
    std::vector<std::filesystem::path> read;     ///< Files, and folders with all in them.
    std::vector<std::filesystem::path> run;      ///< Folders with programs and what these read.
    std::vector<std::filesystem::path> written;  ///< Files that may be written but not made or removed.
    /// Folders in which files may be created, written, renamed and removed.
    std::vector<std::filesystem::path> changed;
};

/// Gives up all other access for this process and its children, until they end. No other file can be opened,
/// made, renamed or removed, no program run, no network port bound or connected to. No process outside of it
/// gets a signal. Everything that is open stays open. This cannot be undone.
/// Source: landlock(7) of Linux.
/// Returns false if the system has no such facility. The error is a message: the system has it, and refuses.
Result<bool> confine(const SandboxPolicy& policy);

}  // namespace gsim::os
