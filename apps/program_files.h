#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/os/output_file.h"

namespace gsim::apps {

/// File that is in use, and its description: "the program itself".
struct UsedFile {
    std::string what;
    std::string path;  ///< Empty: none.
};

/// Files of a program: the main one and those of its subprograms, with names from a post. All get their names
/// together once they are written, the main one last.
class ProgramFiles {
  public:
    /// Opens the main file and the additional ones. The latter replace no file of `used_files`, nor, without
    /// `overwrite`, any other one.
    static Result<ProgramFiles> open(const std::filesystem::path& main,
                                     const std::vector<std::string>& subprogram_files,
                                     const std::vector<UsedFile>& used_files, bool overwrite);

    /// Returns the file with this name; empty: the main one.
    os::OutputFile& file(const std::string& name) { return files_.at(name); }
    Result<void> commit();

  private:
    Result<void> add(const std::string& name, const std::filesystem::path& path,
                     os::ExistingFilePolicy existing);

    std::map<std::string, os::OutputFile> files_;
};

}  // namespace gsim::apps
