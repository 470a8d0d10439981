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
class RunFiles {
  public:
    explicit RunFiles(InputFiles& files) : files_(files) {}

    void replace(const std::string& name, std::string text);
    bool is_replaced(const std::string& name) const;
    /// Returns the replacement texts by the names of their files.
    const std::map<std::string, std::string>& replaced() const { return replaced_texts_; }
    /// Returns the text of a file; empty if no such file exists.
    std::optional<std::string> read(const std::string& name);
    /// Reads the file itself, even if it has a replacement text.
    std::optional<std::string> read_original(const std::string& name);
    /// Records a file that other code reads (meshes by OpenCASCADE, controller modules).
    void record(const std::string& name);
    std::vector<ReadFile> files_read() const;

  private:
    InputFiles& files_;
    std::map<std::string, std::string> replaced_texts_;
    std::map<std::string, std::string> requested_hashes_;
};

/// Returns the engine's host with the files of a run; both arguments must outlive it.
engine::Host host_with_replacements(const engine::Host& system, RunFiles& files);
/// Returns the same without replacement texts.
engine::Host host_with_originals(const engine::Host& system, RunFiles& files);

}  // namespace gsim::batch
