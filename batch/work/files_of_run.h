#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "batch/work/input_files.h"
#include "batch/work/run_row.h"
#include "engine/host.h"

namespace gsim::batch {

/// Files of one run: those of the system, with replacement texts for some of them. It records the requested
/// files.
class FilesOfRun {
  public:
    explicit FilesOfRun(InputFiles& files) : files_(files) {}

    void replace(const std::string& name, std::string text);
    bool is_replaced(const std::string& name) const;
    /// Returns the replacement texts by the names of their files.
    const std::map<std::string, std::string>& replaced() const { return replaced_; }
    /// Returns the text of a file; empty if no such file exists.
    std::optional<std::string> read(const std::string& name);
    /// Reads the file itself, even if it has a replacement text.
    std::optional<std::string> read_as_it_is(const std::string& name);
    /// Records a file that other code reads (meshes by OpenCASCADE, controller modules).
    void note(const std::string& name);
    std::vector<ReadFile> asked() const;

  private:
    InputFiles& files_;
    std::map<std::string, std::string> replaced_;
    std::map<std::string, std::string> asked_;
};

/// Returns the engine's host with the files of a run; both arguments must outlive it.
engine::Host host_with(const engine::Host& system, FilesOfRun& files);
/// Returns the same without replacement texts.
engine::Host host_as_it_is(const engine::Host& system, FilesOfRun& files);

}  // namespace gsim::batch
