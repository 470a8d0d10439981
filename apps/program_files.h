#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "base/os/output_file.h"

namespace gsim::apps {

/// A file that is in use, and what it is: "the program itself".
struct TakenFile {
    std::string what;
    std::string path;  ///< Empty: none.
};

/// The files of a program: the main one and those of its subprograms, whose names come from a post. They get
/// their names together, once all are written, the main one last.
class ProgramFiles {
  public:
    /// Opens the main file and those beside it. The latter replace no file that is `taken`, nor, but with
    /// `overwrite`, any other one. The error is a sentence.
    static tl::expected<ProgramFiles, std::string> open(const std::filesystem::path& main,
                                                        const std::vector<std::string>& beside,
                                                        const std::vector<TakenFile>& taken, bool overwrite);

    /// By its name; empty: the main one.
    os::OutputFile& file(const std::string& name) { return files_.at(name); }
    tl::expected<void, std::string> commit();

  private:
    tl::expected<void, std::string> add(const std::string& name, const std::filesystem::path& path,
                                        os::Existing existing);

    std::map<std::string, os::OutputFile> files_;
};

}  // namespace gsim::apps
