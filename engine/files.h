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

/// Where files are read from by their names: programs, subprograms, modules of scripts, machines,
/// controllers, machine data, cells, meshes. Copies are the same files.
class GSIM_API Files {
  public:
    /// The bytes of a file; nothing where there is none of this name. Names are those of a request, and those
    /// that files give of each other, from the folder of the file, normal: "cell/table.toml".
    using Give = std::function<std::optional<std::string>(const std::string& name)>;

    /// The files of the system.
    Files();
    /// What `give` gives, and no file of the system. It is called by whoever calls this library, and must not
    /// throw.
    static Files given(Give give);

    /// For the library itself.
    const os::Files& inner() const { return *files_; }

  private:
    explicit Files(std::shared_ptr<const os::Files> files) : files_(std::move(files)) {}

    std::shared_ptr<const os::Files> files_;
};

/// The text of a program that is no file. Copies are one, which is read once.
class GSIM_API Text {
  public:
    /// `name` is for messages.
    Text(std::string text, std::string name);
    /// Copies what a stream has left (a pipe, standard input), to a temporary file where it is long. The
    /// error is a sentence.
    static tl::expected<Text, std::string> of_stream(std::FILE* stream, std::string name);
    /// For the library itself.
    lexer::Source& inner() { return *source_; }

  private:
    explicit Text(std::shared_ptr<lexer::Source> source) : source_(std::move(source)) {}

    std::shared_ptr<lexer::Source> source_;
};

}  // namespace gsim::engine
