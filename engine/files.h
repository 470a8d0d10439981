#pragma once

#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "engine/api.h"

namespace gsim::os {
class Files;
}
namespace gsim::lexer {
class Source;
}

namespace gsim::engine {

/// The source of files by their names: programs, subprograms, modules of scripts, machines, controllers,
/// machine data, cells, meshes. Copies are the same files.
class GSIM_API Files {
  public:
    /// Returns the bytes of a file; nothing if no file has this name. Names are those of a request, and names
    /// in files of other files, relative to the file's folder, normalized: "cell/table.toml".
    using FileProvider = std::function<std::optional<std::string>(const std::string& name)>;

    /// Uses the files of the system.
    Files();
    /// Uses the results of `provider` only, and no file of the system. The caller of this library calls it,
    /// and it must not throw.
    static Files given(FileProvider provider);

    /// For internal use.
    const os::Files& impl() const { return *files_; }

  private:
    explicit Files(std::shared_ptr<const os::Files> files) : files_(std::move(files)) {}

    std::shared_ptr<const os::Files> files_;
};

/// The text of a program that is not a file. Copies share one text, which is read once.
class GSIM_API Text {
  public:
    /// `name` is for messages.
    Text(std::string text, std::string name);
    /// Copies the remainder of a stream (a pipe, standard input), to a temporary file if it is long. The
    /// error is a message.
    static tl::expected<Text, std::string> from_stream(std::FILE* stream, std::string name);
    /// For internal use.
    lexer::Source& impl() { return *source_; }

  private:
    explicit Text(std::shared_ptr<lexer::Source> source) : source_(std::move(source)) {}

    std::shared_ptr<lexer::Source> source_;
};

}  // namespace gsim::engine
