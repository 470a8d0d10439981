#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "engine/diagnostic.h"
#include "engine/run.h"
#include "runtime/monitors/path_bound.h"
#include "runtime/outputs/dxf_writer.h"
#include "runtime/outputs/plot_data.h"
#include "runtime/outputs/plot_script.h"
#include "runtime/outputs/run_output.h"
#include "runtime/outputs/text_stream.h"
#include "runtime/outputs/trajectory_writer.h"
#include "runtime/record/path_recorder.h"
#include "runtime/report/time_by_limit.h"
#include "runtime/simulator/simulator.h"

namespace gsim::engine {

/// Message if no output can contain forces.
inline constexpr std::string_view kNoMassesError =
    "forces are requested, but the machine file has no [dynamics] with masses";

/// Message for following errors.
inline constexpr std::string_view kNoServosError =
    "following errors are requested, but no [[axis]] of the machine file defines its servo loop "
    "(position_gain_1_s)";

/// The outputs and results of a run of one machine, attached to its simulator.
class OutputSet {
  public:
    /// `simulator` must not have moved yet, and must outlive this object.
    explicit OutputSet(simulation::Simulator& simulator) : simulator_(simulator) {}
    OutputSet(const OutputSet&) = delete;
    OutputSet& operator=(const OutputSet&) = delete;

    /// Adds an output. The error is a message: this machine has no such output.
    Result<void> add(OutputKind output_kind, TextSink sink, const OutputOptions& options);
    /// Makes the report explain the time consumption.
    void explain();
    void add_output(std::unique_ptr<simulation::RunOutput> output);

    /// Completes the report after the run: adds the requested results, and messages about a recorded path.
    void complete(simulation::Report& report) const;
    /// Then writes the rest to the sinks. Returns the deficiencies of outputs.
    std::vector<Error> finish(const simulation::Report& report);

  private:
    Result<void> add_trajectory(simulation::TextStream& out, const OutputOptions& options);
    Result<void> add_plot(TextSink sink, const OutputOptions& options);
    void add_path(TextSink sink);
    simulation::TextStream& stream(TextSink sink);
    std::optional<Error> check_output_size() const;
    Result<void> write_path(const std::string& program);
    void write_plot(const simulation::Report& report);

    /// The inputs of an explanation.
    struct ExplanationData {
        explicit ExplanationData(const machine::Machine& of) : machine(of) {}
        const machine::Machine& machine;
        simulation::TimeByLimit times;
        std::optional<simulation::PathBound> bound;  ///< Not of samples: each step would count as a corner.
    };
    struct Plot {
        Plot(const machine::Machine& machine, Plane plane, bool bitmap, TextSink to)
            : data(machine, plane),
              format(bitmap ? simulation::PictureFormat::png : simulation::PictureFormat::svg),
              sink(std::move(to)) {}
        simulation::PlotData data;
        simulation::PictureFormat format;
        TextSink sink;
    };
    struct Path {
        Path(const machine::Machine& machine, TextSink to) : recorder(machine), sink(std::move(to)) {}
        record::PathRecorder recorder;
        TextSink sink;
    };

    simulation::Simulator& simulator_;
    std::string trajectory_name_;
    std::string drawing_name_;
    std::vector<std::unique_ptr<simulation::TextStream>> streams_;
    std::vector<std::unique_ptr<simulation::RunOutput>> outputs_;
    const simulation::TrajectoryWriter* trajectory_ = nullptr;  ///< One of outputs_,
    const simulation::DxfWriter* drawing_ = nullptr;            ///< and another one.
    std::unique_ptr<Plot> plot_;
    std::unique_ptr<ExplanationData> explanation_data_;
    std::unique_ptr<Path> path_;
};

}  // namespace gsim::engine
