#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/os/output_file.h"
#include "engine/run.h"
#include "engine/system/picture.h"

namespace gsim::apps {

/// Names of the outputs of a run; an empty name: not wanted, "-": standard output.
struct OutputNames {
    std::string report;
    std::string view;  ///< A page with the run in it (ViewPage).
#define GSIM_DOCUMENT(name, number, option, help, ...) std::string name;
#include "engine/outputs.def"
    engine::OutputOptions options;

    /// Output that is a file, with its option.
    struct File {
        const char* option;
        std::string OutputNames::*name;
        std::optional<engine::OutputKind> output_kind;  ///< Empty: the report, the page.
    };
    static std::span<const File> files();

    /// Returns true if a file is wanted.
    bool any() const;
    /// Returns true if an output uses standard output.
    bool on_standard_output() const;
    /// Returns an error if the request cannot be met: a picture on standard output.
    std::optional<Error> conflict() const;
    /// Returns the names for one of several robots: each robot has separate files, "moves.left.jsonl", except
    /// the report and the page.
    OutputNames for_robot(const std::string& robot) const;
};

/// Files that the run of one machine writes. They appear under their names only with commit().
class Outputs {
  public:
    /// Opens the outputs; the error is a message. Names that would prevent writing are reported here, not
    /// after the run. `run` is prepared, and delivers its documents to the result.
    static Result<std::unique_ptr<Outputs>> open(const OutputNames& names, engine::Run& run,
                                                 std::size_t robot = 0);
    Outputs(const Outputs&) = delete;
    Outputs& operator=(const Outputs&) = delete;

    /// Writes report and picture after the run, and gives all files their names.
    Result<void> commit(const engine::Report& report);

  private:
    explicit Outputs(const OutputNames& names) : names_(names) {}
    Result<void> add(engine::OutputKind output_kind, const std::string& name, engine::Run& run,
                     std::size_t robot);
    Result<engine::TextSink> open_sink(engine::OutputKind output_kind, const std::string& name);
    Result<os::OutputFile*> add_file(const std::string& name);
    Result<void> write_report(const engine::Report& report);

    OutputNames names_;
    std::vector<std::unique_ptr<os::OutputFile>> files_;
    std::optional<engine::Picture> picture_;
    std::string plot_script_;
    std::string error_;  ///< Error of a file that was opened during the run.
};

}  // namespace gsim::apps
