// path2gcode: writes a path as a part program for a machine and its controller.

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/confine_run.h"
#include "apps/findings.h"
#include "apps/limit_options.h"
#include "apps/program_files.h"
#include "apps/programs.h"
#include "base/os/output_file.h"
#include "base/text/format.h"
#include "cli/exit_status.h"
#include "engine/path_translation.h"
#include "engine/system/system_host.h"

namespace {

using namespace gsim;
namespace fs = std::filesystem;
using Kind = text::DiagnosticKind;

constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();
constexpr double kMaxTool = 99'999'999;

struct WriteArguments {
    std::string input = "-";
    std::string output;  ///< Empty: standard output.
    std::string post = "ab9";
    std::string machine;
    std::string machine_data;
    std::string rotary;
    std::string offsets;
    std::string work_offset;
    std::array<double, 3> set_offset_mm{kNotGiven, kNotGiven, kNotGiven};
    std::optional<double> tool;
    std::optional<double> retract_mm;
    double tolerance_mm = 0.01;
    std::string decimals;
    bool inch = false;
    bool verbose_words = false;
    bool separate_files = false;
    bool overwrite = false;
    bool continue_on_unknown = false;
    bool quiet = false;
    bool no_confine = false;
    double max_cpu_s = apps::kMaxCpu_s;
    std::uint64_t memory_mb = apps::kDefaultMemory_mb;
    apps::FindingOptions findings;
};

constexpr const char* kPath2gcode = "path2gcode";
constexpr const char* kAsGiven = "as-given";
constexpr const char* kLeastTurn = "least-turn";
constexpr std::array<std::pair<const char*, engine::Offsets>, 3> kOffsets = {
    {{"keep", engine::Offsets::keep}, {"none", engine::Offsets::none}, {"G53", engine::Offsets::machine}}};

void add_write_options(apps::CommandLine& line, WriteArguments& a) {
    using apps::FileKind;
    line.add("part.path.json|part.lua", &a.input, "path, or - for a path file on standard input")
        .takes_file(FileKind::input, {".json", ".lua"})
        .show_default();
    line.begin_group("Control and machine");
    line.add("--dialect", &a.post,
             fmt::format("how the controller wants programs: {}, or a file that ends in .toml",
                         text::joined(engine::post_names(), ", ")))
        .with_value_name("NAME|FILE")
        .takes_file(FileKind::input, {".toml"})
        .or_builtin_name()
        .show_default();
    line.add(
            "--machine", &a.machine,
            "machine file (TOML), or a LinuxCNC .ini; without it the 5-axis waterjet gantry that is built in")
        .takes_file(FileKind::input, {".toml"});
    line.add("--machine-data", &a.machine_data,
             "machine data (NCFILE), which say where the fixed points of the path lie")
        .takes_file(FileKind::input, {".txt"});
    line.add("--rotary", &a.rotary,
             "least-turn: rotary axes go the way that turns least; as-given: rotary_deg is taken as it is, "
             "the default for recorded paths")
        .one_of({kLeastTurn, kAsGiven});
    line.add("--offsets", &a.offsets,
             "keep: the work offsets that the recorded run used, the default there; none: all offsets are "
             "taken back; G53: machine coordinates, in which there are no arcs")
        .one_of({kOffsets[0].first, kOffsets[1].first, kOffsets[2].first});
    line.add("--work-offset", &a.work_offset,
             "work offset of paths that name none and that no run has recorded; without it the one that the "
             "control's programs begin in")
        .with_value_name("G54")
        .suggest_values({"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"});
    line.add("--set-offset", &a.set_offset_mm,
             "the program puts the work offset that it begins in there, in machine coordinates (G10)")
        .with_value_name("X Y Z")
        .within(-1e6, 1e6);
    line.add(
            "--tool", &a.tool,
            "tool of paths that name none and that no run has recorded, with the length offset of its number")
        .with_value_name("NUMBER")
        .within(0, kMaxTool);
    line.add("--retract", &a.retract_mm,
             "machine coordinate of Z that the tool goes up to before it or the work offset changes; without "
             "it the "
             "end of the axis")
        .with_value_name("MM")
        .within(-1e6, 1e6);
    line.add("--go-on", &a.continue_on_unknown,
             "what the control has no word for becomes a comment, counted and listed, instead of an error");
    line.add("--tolerance", &a.tolerance_mm, "by which lines in place of an arc may be off it")
        .with_value_name("MM")
        .within(1e-4, 10)
        .show_default();
    line.begin_group("Output");
    line.add("-o,--output", &a.output, "write the program to this file; it appears only if all went well")
        .takes_file(FileKind::output, {".nc", ".ngc"});
    line.add("--separate-files", &a.separate_files, "each sub-path in a file of its own beside the output");
    line.add("--overwrite", &a.overwrite, "files of sub-paths may replace files that are there already");
    line.add("--decimals", &a.decimals, "digits behind the point of lengths in mm, in place of the post's")
        .one_of({"1", "2", "3", "4", "5", "6"});
    line.add("--inch", &a.inch, "the program is in inches");
    line.add("--verbose-words", &a.verbose_words, "write words though they have not changed");
    line.add("--quiet", &a.quiet, "no notes on standard error");
    line.begin_group("Limits");
    apps::add_cpu_option(line, a.max_cpu_s);
    apps::add_memory_option(line, a.memory_mb);
    apps::add_confine_option(line, a.no_confine);
    line.begin_group("Diagnostics");
    apps::add_finding_options(line, a.findings);
    line.add_example("path2gcode plate.path.json -o plate.nc", "a path for the built-in machine");
    line.add_example("gsim-run --record - part.nc | path2gcode --dialect grbl -",
                     "what was run, for another control");
}

int write_program(const engine::PathTranslation& program, const WriteArguments& a, apps::Findings& findings) {
    const std::string output = apps::product_destination(a.output);
    const std::vector<apps::UsedFile> used_files = {{"the program itself", output},
                                                    {"the path", a.input},
                                                    {"the machine file", a.machine},
                                                    {"the machine data", a.machine_data},
                                                    {"the post", a.post},
                                                    {"what --sarif names", a.findings.sarif}};
    auto files = apps::ProgramFiles::open(output, program.file_names(), used_files, a.overwrite);
    if (!files) return findings.fail(Kind::output, files.error());
    const auto written = program.write([&](const std::string& name) {
        return [&file = files->file(name)](std::string_view text) { return file.write(text); };
    });
    if (!written) return findings.fail(written.error());
    const auto committed = files->commit();
    return committed ? apps::kSuccess : findings.fail(Kind::output, committed.error());
}

/// A path with an error, or one that the machine or the controller cannot execute, is not a usage error.
int report_path_failure(apps::Findings& findings, const engine::Error& error) {
    if (!error.in_program) return findings.fail(error);
    findings.add(text::to_diagnostic(Kind::path, error.message));
    return apps::kProgramError;
}

/// Confines the process, because from here on it needs only the path and the outputs, including additional
/// ones.
tl::expected<void, std::string> confine_writing(const WriteArguments& a, const std::string& path) {
    if (a.no_confine) return {};
    const std::string& read = a.input == os::kStandardStream ? a.input : path;
    return apps::confine_to(std::array{read}, std::array{a.output, a.findings.sarif});
}

tl::expected<std::size_t, std::string> read_standard_input(char* buffer, std::size_t size) {
    const std::size_t count = std::fread(buffer, 1, size, stdin);
    if (std::ferror(stdin) == 0) return count;
    return tl::unexpected(fmt::format("cannot read 'stdin': {}", std::generic_category().message(errno)));
}

engine::PathRequest make_request(const WriteArguments& a, bool to_standard_output) {
    engine::PathRequest request;
    request.host = engine::make_system_host();
    request.path = a.input;
    if (a.input == os::kStandardStream) {
        request.path = "stdin";
        request.bytes = read_standard_input;
    }
    request.post = a.post;
    request.machine = a.machine;
    request.machine_data = a.machine_data;
    if (!to_standard_output) request.program_name = fs::path(a.output).stem().string();
    if (!a.rotary.empty()) request.rotary_as_given = a.rotary == kAsGiven;
    for (const auto& [name, offsets] : kOffsets) {
        if (a.offsets == name) request.offsets = offsets;
    }
    request.work_offset = a.work_offset;
    if (!std::isnan(a.set_offset_mm[0])) request.set_offset_mm = a.set_offset_mm;
    if (a.tool) request.tool = static_cast<int>(*a.tool);
    request.retract_mm = a.retract_mm;
    request.tolerance_mm = a.tolerance_mm;
    if (!a.decimals.empty()) request.decimals_mm = a.decimals.front() - '0';
    request.inch = a.inch;
    request.verbose_words = a.verbose_words;
    request.separate_files = a.separate_files;
    request.continue_on_unknown = a.continue_on_unknown;
    request.cpu_s = a.max_cpu_s;
    request.memory_bytes = a.memory_mb << 20U;
    return request;
}

int write_path_program(const WriteArguments& a, apps::Findings& findings) {
    const bool to_standard_output = apps::product_destination(a.output) == os::kStandardStream;
    if (const auto conflict = apps::sarif_conflict(findings.options(), apps::product_destination(a.output)))
        return findings.fail(Kind::usage, *conflict);
    if (a.overwrite && !a.separate_files)
        return findings.fail(Kind::usage,
                             "--overwrite is for the files of --separate-files; --output replaces");
    if (a.tool && *a.tool != std::floor(*a.tool))
        return findings.fail(Kind::usage, "--tool takes a whole number");
    if (a.separate_files && to_standard_output)
        return findings.fail(Kind::usage, "--separate-files needs --output");
    auto program = engine::PathTranslation::open(make_request(a, to_standard_output));
    if (!program) return findings.fail(program.error());
    if (auto confined = confine_writing(a, program->path_file()); !confined)
        return findings.fail(Kind::usage, confined.error());
    if (const auto read = program->read(); !read) return report_path_failure(findings, read.error());
    const apps::CpuBackstop planning_backstop(program->cpu_left_s());
    if (const auto planned = program->plan(); !planned) return report_path_failure(findings, planned.error());
    for (const std::string& note : program->notes()) {
        if (!a.quiet) findings.add({.severity = text::Severity::note, .kind = Kind::path, .text = note});
    }
    return write_program(*program, a, findings);
}

int run_write(const WriteArguments& a) {
    using Stream = apps::Findings::Stream;
    apps::Findings findings(kPath2gcode, a.findings);
    const int status = write_path_program(a, findings);
    const bool product_on_standard_output =
        status == apps::kSuccess && apps::product_destination(a.output) == os::kStandardStream;
    return findings.finish(status,
                           product_on_standard_output ? Stream::standard_error : Stream::standard_output);
}

}  // namespace

std::unique_ptr<apps::Program> apps::make_path2gcode() {
    return std::make_unique<ProgramWithArguments<WriteArguments>>(
        kPath2gcode, "Writes a path of points as a part program (G-code)", add_write_options, run_write);
}
