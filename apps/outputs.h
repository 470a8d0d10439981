#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/os/output_file.h"
#include "runtime/record/path_recorder.h"
#include "runtime/simulation/moves_writer.h"
#include "runtime/simulation/path_bound.h"
#include "runtime/simulation/plot.h"
#include "runtime/simulation/plot_data.h"
#include "runtime/simulation/simulator.h"
#include "runtime/simulation/text_stream.h"
#include "runtime/simulation/time_by_limit.h"
#include "runtime/simulation/trajectory_writer.h"

namespace gsim::apps {

/// What a run writes; an empty name: not wanted, "-": standard output.
struct OutputNames {
    std::string report;
    std::string moves;
    std::string trajectory;
    std::string plot;
    std::string plot_plane = "xy";  ///< Which the picture shows the path in.
    std::string record;             ///< A path file.
    bool explain = false;           ///< The report tells where the time goes.
    double step_s = 0.01;           ///< Of the trajectory's samples.

    /// Those that are files, by their options.
    struct File {
        const char* option;
        std::string OutputNames::*name;
    };
    static std::span<const File> files();

    /// Whether a file is wanted.
    bool any() const;
    /// Whether something goes to standard output.
    bool on_standard_output() const;
    /// What cannot be done, as a sentence: a picture on standard output.
    std::optional<std::string> conflict() const;
};

/// The files that a run writes, attached to its simulator. They appear under their names with commit() only.
class Outputs {
  public:
    /// The error is a sentence; what the names would stop the run's files with is known here, not behind the
    /// run. `simulator` must not have moved yet, and must outlive the outputs' use.
    static tl::expected<Outputs, std::string> open(const OutputNames& names,
                                                   simulation::Simulator& simulator);

    /// After the run: adds to the report what was asked for, and what to know of a recorded path.
    void explain(simulation::Report& report) const;
    /// After the run: makes the path that was asked for; `program` names it. The error is a sentence: what
    /// was run makes no path.
    tl::expected<void, std::string> make_path(const std::string& program);
    /// After the run: writes report and picture, and gives all files their names. The error is a sentence.
    tl::expected<void, std::string> commit(const simulation::Report& report);

  private:
    struct TextFile {
        explicit TextFile(os::OutputFile opened) : file(std::move(opened)), text(file.stream()) {}
        os::OutputFile file;
        simulation::TextStream text;
    };
    tl::expected<TextFile*, std::string> add_file(const std::string& name);
    tl::expected<void, std::string> write_path() const;
    void add_explanation(simulation::Simulator& simulator);
    tl::expected<void, std::string> add_plot(simulation::Simulator& simulator);
    tl::expected<void, std::string> draw(const simulation::Report& report);

    /// What an explanation is made of.
    struct Causes {
        explicit Causes(const machine::Machine& of) : machine(of) {}
        const machine::Machine& machine;
        simulation::TimeByLimit times;
        std::optional<simulation::PathBound> bound;  ///< Not of samples: each step would count as a corner.
    };

    OutputNames names_;
    std::vector<std::unique_ptr<TextFile>> files_;
    std::unique_ptr<simulation::MovesWriter> moves_;
    std::unique_ptr<simulation::TrajectoryWriter> trajectory_;
    std::unique_ptr<simulation::PlotData> plot_;
    std::optional<simulation::Picture> picture_;
    std::unique_ptr<Causes> causes_;
    std::unique_ptr<record::PathRecorder> recorder_;
    std::optional<path::Program> path_;
};

}  // namespace gsim::apps
