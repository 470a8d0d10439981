#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "batch/work/input_files.h"
#include "batch/work/run_row.h"
#include "engine/host.h"

namespace gsim::batch {

/// The files of one run: those of the system, and in place of some other texts. It keeps in mind what was
/// asked for.
class FilesOfRun {
  public:
    explicit FilesOfRun(InputFiles& files) : files_(files) {}

    void replace(const std::string& name, std::string text);
    bool is_replaced(const std::string& name) const;
    /// What stands in place of files, by their names.
    const std::map<std::string, std::string>& replaced() const { return replaced_; }
    /// Nothing where there is no such file.
    std::optional<std::string> read(const std::string& name);
    /// As the file is, whatever stands in its place.
    std::optional<std::string> read_as_it_is(const std::string& name);
    /// A file that others read (meshes by OpenCASCADE, controller modules).
    void note(const std::string& name);
    std::vector<ReadFile> asked() const;

  private:
    InputFiles& files_;
    std::map<std::string, std::string> replaced_;
    std::map<std::string, std::string> asked_;
};

/// What the engine gets from outside, with the files of a run; those must outlive it.
engine::Host host_with(const engine::Host& system, FilesOfRun& files);
/// The same without what stands in place of files.
engine::Host host_as_it_is(const engine::Host& system, FilesOfRun& files);

}  // namespace gsim::batch
