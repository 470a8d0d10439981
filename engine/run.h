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

/// Takes a text in pieces. False: it cannot be written; no more of it is given then.
using TextSink = std::function<bool(std::string_view)>;

/// Documents of a run (docs/report.md), which documents.def lists and tells the meaning of.
enum class Document : std::uint8_t {
#define GSIM_DOCUMENT(name, number, option, help, ...) name = number,
#include "engine/documents.def"
};

/// The words for them ("dxf"), in the order of their numbers.
GSIM_API std::vector<std::string> document_names();
/// The document of such a word; nothing where there is none.
GSIM_API std::optional<Document> document_named(std::string_view name);

/// The least time between samples.
inline constexpr double kLeastStep_s = 1e-6;

/// How documents are to be.
struct DocumentOptions {
    double step_s = 0.01;      ///< Of a trajectory's samples.
    bool forces = false;       ///< A trajectory has those of the motors, and their power.
    bool following = false;    ///< A trajectory has following and contour errors, and the real tip.
    std::string plane = "xy";  ///< Which a plot shows: "xy", "zx", "yz".
    bool bitmap = false;       ///< A plot becomes PNG, else SVG.
    std::string name = {};     ///< Of the file, for messages.
};

/// One program on a simulated machine, or on several: open(), prepare(), what is wanted of it, then go(),
/// each once. All that goes wrong comes back as a Failure or in the report; nothing is printed, nothing of
/// the process is changed.
class GSIM_API Run {
  public:
    /// What is done, of what there is to do; `total` 0: not known.
    using Progress = std::function<void(std::uint64_t done, std::uint64_t total)>;

    /// Reads machine and cell, and opens the program: what may lie anywhere. `tell` gets all that there is to
    /// tell of inputs, until the run is gone; the report has it, too.
    static tl::expected<Run, Failure> open(Request request, Tell tell = {});
    /// The same on a machine that has been read, with its bodies, for this request or another one: what the
    /// request says of machine and cell does not count, nor its machine data where the cell named some. The
    /// machine may go before the run.
    static tl::expected<Run, Failure> open(Request request, const Machine& machine, Tell tell = {});
    Run(Run&&) noexcept;
    Run& operator=(Run&&) noexcept;
    ~Run();

    /// Translates the program and reads all else: files that the request names, and what lies beside the
    /// program.
    tl::expected<void, Failure> prepare();

    /// Names of the robots; one without a name where there is no file of robots.
    const std::vector<std::string>& robots() const;
    /// From prepare() on.
    const std::vector<Axis>& axes(std::size_t robot = 0) const;
    /// Where the axes stand at the start.
    AxisValues home(std::size_t robot = 0) const;

    /// Between prepare() and go(): what is wanted while it runs. The error: this machine has no such
    /// document, or options are out of their ranges.
    tl::expected<void, Failure> write(Document document, TextSink sink, const DocumentOptions& options = {},
                                      std::size_t robot = 0);
    void take_moves(TakeMoves take, std::size_t robot = 0);
    void take_segments(TakeSegments take, std::size_t robot = 0);
    /// Each `step_s` (1e-6 at least), and the last instant.
    tl::expected<void, Failure> take_samples(TakeSamples take, double step_s, std::size_t robot = 0);
    /// The same as take_segments(), for use elsewhere: all that the closed forms need, and the way of the
    /// tip. scene() tells behind the run how frames went by themselves.
    void take_columns(TakeColumns take, std::size_t robot = 0);
    /// What the motors bring up. The error: the machine file does not tell of masses.
    tl::expected<void, Failure> take_efforts(TakeEfforts take, std::size_t robot = 0);
    /// `observer`, which outlives the run, is told what it asks of its controller, for use on other machines
    /// (runtime/motion_sources/motion_replay.h).
    void observe_motion(simulation::MotionObserver& observer, std::size_t robot = 0);
    /// Where axes and tip really are. The error: the machine file does not tell of servo loops.
    tl::expected<void, Failure> take_following(TakeFollowing take, std::size_t robot = 0);
    void show_progress(Progress progress);

    /// Runs to the end, an alarm, a limit, or Request::cancel. What happened.
    tl::expected<Report, Failure> go();

    /// From prepare() on: the machine and what stands round it.
    tl::expected<Scene, Failure> scene(std::size_t robot = 0) const;
    /// Names of the sources that SegmentColumns::file counts.
    const std::vector<std::string>& files(std::size_t robot = 0) const;

    /// Behind go(). What documents lack: a path that cannot be recorded, more samples than may be.
    const std::vector<Failure>& faults() const;
    /// The variables that a control keeps from one run to the next, as the file of them.
    tl::expected<std::string, Failure> variables() const;
    /// The machine data as the program left them: the text that was read, with changes in their lines.
    tl::expected<std::string, Failure> machine_data() const;

    /// Of a program that prepare() has refused, for those who read reports alone.
    Report report_of(const Failure& failure) const;

    /// The request with the files that its names mean, those of the cell among them.
    const Request& request() const;
    /// What other files have named, with what it is ("the machine of the cell"): who writes files leaves them
    /// alone.
    struct NamedFile {
        std::string name;
        std::string what;
        std::string robot = {};  ///< Whose it is, where there are several.
    };
    std::vector<NamedFile> named_files() const;

  private:
    class State;
    explicit Run(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

/// The folder in which programs that this one calls, and its modules, are looked for.
GSIM_API std::string program_folder(const std::string& program);

}  // namespace gsim::engine
