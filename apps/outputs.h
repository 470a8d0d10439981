#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/os/output_file.h"
#include "engine/run.h"
#include "engine/system/picture.h"

namespace gsim::apps {

/// What a run writes; an empty name: not wanted, "-": standard output.
struct OutputNames {
    std::string report;
    std::string view;  ///< A page with the run in it (ViewPage).
#define GSIM_DOCUMENT(name, number, option, help, ...) std::string name;
#include "engine/documents.def"
    engine::DocumentOptions options;

    /// Those that are files, by their options.
    struct File {
        const char* option;
        std::string OutputNames::*name;
        std::optional<engine::Document> document;  ///< None: the report, the page.
    };
    static std::span<const File> files();

    /// Whether a file is wanted.
    bool any() const;
    /// Whether something goes to standard output.
    bool on_standard_output() const;
    /// What cannot be done, as a sentence: a picture on standard output.
    std::optional<std::string> conflict() const;
    /// Of a robot among several: each has files of its own, "moves.left.jsonl", but for
    /// the report and the page.
    OutputNames of_robot(const std::string& robot) const;
};

/// The files that a run of one machine writes. They appear under their names with commit() only.
class Outputs {
  public:
    /// The error is a sentence; what the names would stop the run's files with is known here, not behind the
    /// run. `run` is prepared, and gives its documents to what is returned.
    static tl::expected<std::unique_ptr<Outputs>, std::string> open(const OutputNames& names,
                                                                    engine::Run& run, std::size_t robot = 0);
    Outputs(const Outputs&) = delete;
    Outputs& operator=(const Outputs&) = delete;

    /// After the run: writes report and picture, and gives all files their names. The error is a sentence.
    tl::expected<void, std::string> commit(const engine::Report& report);

  private:
    explicit Outputs(const OutputNames& names) : names_(names) {}
    tl::expected<void, std::string> add(engine::Document document, const std::string& name, engine::Run& run,
                                        std::size_t robot);
    tl::expected<engine::TextSink, std::string> sink_of(engine::Document document, const std::string& name);
    tl::expected<os::OutputFile*, std::string> add_file(const std::string& name);
    tl::expected<void, std::string> write_report(const engine::Report& report);

    OutputNames names_;
    std::vector<std::unique_ptr<os::OutputFile>> files_;
    std::optional<engine::Picture> picture_;
    std::string plot_script_;
    std::string fault_;  ///< Of a file that was opened while the run went on.
};

}  // namespace gsim::apps
