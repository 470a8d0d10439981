#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "engine/api.h"
#include "engine/columns.h"
#include "engine/diagnostic.h"
#include "engine/machine.h"
#include "engine/motion.h"
#include "engine/report.h"
#include "engine/request.h"
#include "engine/scene.h"

namespace gsim::simulation {
class MotionObserver;
}

namespace gsim::engine {

/// Consumes a text in parts. False: it cannot be written; no more of it is passed then.
using TextSink = std::function<bool(std::string_view)>;

/// Outputs of a run (docs/report.md), which outputs.def lists and explains.
enum class OutputKind : std::uint8_t {
#define GSIM_DOCUMENT(name, number, option, help, ...) name = number,
#include "engine/outputs.def"
};

/// Returns the words for them ("dxf"), in the order of their numbers.
GSIM_API std::vector<std::string> output_names();
/// Returns the output for such a word; nothing if none has it.
GSIM_API std::optional<OutputKind> find_output(std::string_view name);

/// The min time between samples.
inline constexpr double kMinStep_s = 1e-6;

/// Options of outputs.
struct OutputOptions {
    double step_s = 0.01;      ///< Step of a trajectory's samples.
    bool forces = false;       ///< A trajectory has those of the motors, and their power.
    bool following = false;    ///< A trajectory has following and contour errors, and the actual TCP.
    std::string plane = "xy";  ///< Plane that a plot shows: "xy", "zx", "yz".
    bool bitmap = false;       ///< A plot becomes PNG, else SVG.
    std::string name = {};     ///< Name of the file, for messages.
};

/// One program on a simulated machine, or on several: open(), prepare(), the requested results, then go(),
/// each once. All errors return as an Error or in the report; it does not print and does not change the
/// process.
class GSIM_API Run {
  public:
    /// Amount done, and total amount; `total` 0: not known.
    using Progress = std::function<void(std::uint64_t done, std::uint64_t total)>;

    /// Reads machine and cell, and opens the program: files that may be in any folder. `on_diagnostic`
    /// receives all diagnostics of inputs until the run is destroyed; the report has them, too.
    static tl::expected<Run, Error> open(Request request, DiagnosticHandler on_diagnostic = {});
    /// Does the same on a machine that has been read, with its bodies, for this request or another one. The
    /// request's machine and cell are ignored, and so are its machine data if the cell named some. The
    /// machine may be destroyed before the run.
    static tl::expected<Run, Error> open(Request request, const Machine& machine,
                                         DiagnosticHandler on_diagnostic = {});
    Run(Run&&) noexcept;
    Run& operator=(Run&&) noexcept;
    ~Run();

    /// Translates the program and reads all other files: those that the request names, and those next to the
    /// program.
    tl::expected<void, Error> prepare();

    /// Returns the names of the robots; one without a name if the run has no file of robots.
    const std::vector<std::string>& robots() const;
    /// Valid from prepare() on.
    const std::vector<Axis>& axes(std::size_t robot = 0) const;
    /// Returns the axis positions at the start.
    AxisValues home(std::size_t robot = 0) const;

    /// Requests an output, between prepare() and go(). The error: this machine has no such output, or options
    /// are out of their ranges.
    tl::expected<void, Error> write(OutputKind output_kind, TextSink sink, const OutputOptions& options = {},
                                    std::size_t robot = 0);
    void on_moves(MovesHandler callback, std::size_t robot = 0);
    void on_segments(SegmentsHandler callback, std::size_t robot = 0);
    /// Requests samples each `step_s` (1e-6 at least), and at the last instant.
    tl::expected<void, Error> on_samples(SamplesHandler callback, double step_s, std::size_t robot = 0);
    /// Does the same as on_segments(), for use elsewhere: all inputs of the closed forms, and the path of
    /// the TCP. After the run, scene() returns the independent motion of frames.
    void on_columns(ColumnsHandler callback, std::size_t robot = 0);
    /// Requests the forces and torques of the motors. The error: the machine file does not specify masses.
    tl::expected<void, Error> on_efforts(EffortsHandler callback, std::size_t robot = 0);
    /// Reports to `observer`, which outlives the run, its requests to the controller, for use on other
    /// machines (runtime/motion_sources/motion_replay.h).
    void observe_motion(simulation::MotionObserver& observer, std::size_t robot = 0);
    /// Requests the actual positions of axes and TCP. The error: the machine file does not specify servo
    /// loops.
    tl::expected<void, Error> on_following(FollowingHandler callback, std::size_t robot = 0);
    void on_progress(Progress progress);

    /// Runs to the end, an alarm, a limit, or Request::cancel. Returns the report.
    tl::expected<Report, Error> go();

    /// Returns the machine and its surroundings. Requires prepare().
    tl::expected<Scene, Error> scene(std::size_t robot = 0) const;
    /// Returns names of the sources; SegmentColumns::file is an index into them.
    const std::vector<std::string>& files(std::size_t robot = 0) const;

    /// Returns the deficiencies of outputs, after go(): a path that cannot be recorded, more samples than
    /// allowed.
    const std::vector<Error>& errors() const;
    /// Returns the variables that a controller keeps from one run to the next, in the form of their file.
    tl::expected<std::string, Error> variables() const;
    /// Returns the machine data as the program leaves it: the text that was read, with changes in their
    /// lines.
    tl::expected<std::string, Error> machine_data() const;

    /// Returns the report of a program that prepare() has rejected, for readers of reports only.
    Report make_report(const Error& error) const;

    /// Returns the request with the files of its names, including those of the cell.
    const Request& request() const;
    /// A file that other files have named, with its role ("the machine of the cell"): programs that write
    /// files must not overwrite it.
    struct NamedFile {
        std::string name;
        std::string what;
        std::string robot = {};  ///< Name of the robot, if the run has several.
    };
    std::vector<NamedFile> named_files() const;

  private:
    class State;
    explicit Run(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

/// Returns the folder in which programs that this one calls, and its modules, are searched.
GSIM_API std::string program_folder(const std::string& program);

}  // namespace gsim::engine
