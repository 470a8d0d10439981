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

/// Setup of the machine, for what the path leaves open.
struct SetupArguments {
    std::string rotary;
    std::string offsets;
    std::string work_offset;
    std::array<double, 3> set_offset_mm{kNotGiven, kNotGiven, kNotGiven};
    std::optional<double> tool;
    std::optional<double> retract_mm;
};

/// Files and form of the part program.
struct ProductArguments {
    std::string file;  ///< Empty: standard output.
    bool separate_files = false;
    bool overwrite = false;
    std::string decimals;
    bool inch = false;
    bool verbose_words = false;
};

struct LimitArguments {
    bool no_confine = false;
    double max_cpu_s = apps::kMaxCpu_s;
    std::uint64_t memory_mb = apps::kDefaultMemory_mb;
};

struct WriteArguments {
    std::string input = "-";
    std::string post = "ab9";
    std::string machine;
    std::string machine_data;
    SetupArguments setup;
    double tolerance_mm = 0.01;
    bool continue_on_unknown = false;
    ProductArguments product;
    bool quiet = false;
    LimitArguments limits;
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
    line.begin_group("Controller and machine");
    line.add("--dialect", &a.post,
             fmt::format("post (rules for the controller's programs): {}, or a file that ends in .toml",
                         text::joined(engine::post_names(), ", ")))
        .with_value_name("NAME|FILE")
        .takes_file(FileKind::input, {".toml"})
        .or_builtin_name()
        .show_default();
    line.add("--machine", &a.machine,
             "machine file (TOML), or a LinuxCNC .ini; default: the built-in 5-axis waterjet gantry")
        .takes_file(FileKind::input, {".toml"});
    line.add("--machine-data", &a.machine_data,
             "machine data (NCFILE) with the positions of the fixed points of the path")
        .takes_file(FileKind::input, {".txt"});
    line.add("--rotary", &a.setup.rotary,
             "least-turn: rotary axes turn through the smallest angle; as-given: rotary_deg is used "
             "unchanged, the default for recorded paths")
        .one_of({kLeastTurn, kAsGiven});
    line.add("--offsets", &a.setup.offsets,
             "keep: the work offsets of the recorded run, the default for recorded paths; none: all offsets "
             "are cancelled; G53: machine coordinates, without arcs")
        .one_of({kOffsets[0].first, kOffsets[1].first, kOffsets[2].first});
    line.add("--work-offset", &a.setup.work_offset,
             "work offset of paths that name none and are not recorded; default: the one that is active at "
             "the start of the controller's programs")
        .with_value_name("G54")
        .suggest_values({"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"});
    line.add("--set-offset", &a.setup.set_offset_mm,
             "the program sets its initial work offset to this position, in machine coordinates (G10)")
        .with_value_name("X Y Z")
        .within(-1e6, 1e6);
    line.add("--tool", &a.setup.tool,
             "tool of paths that name none and are not recorded, with the length offset of its number")
        .with_value_name("NUMBER")
        .within(0, kMaxTool);
    line.add("--retract", &a.setup.retract_mm,
             "Z machine coordinate to which the tool retracts before the tool or the work offset changes; "
             "default: the end of the axis")
        .with_value_name("MM")
        .within(-1e6, 1e6);
    line.add("--continue-on-unknown", &a.continue_on_unknown,
             "actions that the controller does not support become comments, counted and listed, instead of "
             "errors")
        .formerly("--go-on");
    line.add("--tolerance", &a.tolerance_mm, "max deviation of lines that replace an arc")
        .with_value_name("MM")
        .within(1e-4, 10)
        .show_default();
    line.begin_group("Output");
    line.add("-o,--output", &a.product.file, "write the program to this file; it is created only on success")
        .takes_file(FileKind::output, {".nc", ".ngc"});
    line.add("--separate-files", &a.product.separate_files,
             "write each sub-path to a separate file next to the output");
    line.add("--overwrite", &a.product.overwrite, "files of sub-paths may replace existing files");
    line.add("--decimals", &a.product.decimals, "decimals of lengths in mm, instead of the post's")
        .one_of({"1", "2", "3", "4", "5", "6"});
    line.add("--inch", &a.product.inch, "the program is in inches");
    line.add("--verbose-words", &a.product.verbose_words, "write words even if they have not changed");
    line.add("--quiet", &a.quiet, "no notes on standard error");
    line.begin_group("Limits");
    apps::add_cpu_option(line, a.limits.max_cpu_s);
    apps::add_memory_option(line, a.limits.memory_mb);
    apps::add_confine_option(line, a.limits.no_confine);
    line.begin_group("Diagnostics");
    apps::add_finding_options(line, a.findings);
    line.add_example("path2gcode plate.path.json -o plate.nc", "a path for the built-in machine");
    line.add_example("gsim-run --record - part.nc | path2gcode --dialect grbl -",
                     "the path of a run, for another controller");
}

int write_program(const engine::PathTranslation& program, const WriteArguments& a, apps::Findings& findings) {
    const std::string output = apps::output_destination(a.product.file);
    const std::vector<apps::UsedFile> used_files = {{"the program itself", output},
                                                    {"the path", a.input},
                                                    {"the machine file", a.machine},
                                                    {"the machine data", a.machine_data},
                                                    {"the post", a.post},
                                                    {"the file of --sarif", a.findings.sarif}};
    auto files = apps::ProgramFiles::open(output, program.file_names(), used_files, a.product.overwrite);
    if (!files) return findings.fail(Kind::output, files.error().message);
    const auto written = program.write([&](const std::string& name) {
        return [&file = files->file(name)](std::string_view text) { return file.write(text); };
    });
    if (!written) return findings.fail(written.error());
    const auto committed = files->commit();
    return committed ? apps::kSuccess : findings.fail(Kind::output, committed.error().message);
}

/// A path with an error, or one that the machine or the controller cannot execute, is not a usage error.
int report_path_failure(apps::Findings& findings, const engine::Error& error) {
    if (!error.in_program) return findings.fail(error);
    findings.add(text::to_diagnostic(Kind::path, error.message));
    return apps::kProgramError;
}

/// Confines the process, because from here on it needs only the path and the outputs, including additional
/// ones.
Result<void> confine_writing(const WriteArguments& a, const std::string& path) {
    if (a.limits.no_confine) return {};
    const std::string& read = a.input == os::kStandardStream ? a.input : path;
    return apps::confine_to(std::array{read}, std::array{a.product.file, a.findings.sarif});
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
    if (!to_standard_output) request.program_name = fs::path(a.product.file).stem().string();
    if (!a.setup.rotary.empty()) request.rotary_as_given = a.setup.rotary == kAsGiven;
    for (const auto& [name, offsets] : kOffsets) {
        if (a.setup.offsets == name) request.offsets = offsets;
    }
    request.work_offset = a.setup.work_offset;
    if (!std::isnan(a.setup.set_offset_mm[0])) request.set_offset_mm = a.setup.set_offset_mm;
    if (a.setup.tool) request.tool = static_cast<int>(*a.setup.tool);
    request.retract_mm = a.setup.retract_mm;
    request.format.tolerance_mm = a.tolerance_mm;
    if (!a.product.decimals.empty()) request.format.decimals_mm = a.product.decimals.front() - '0';
    request.format.inch = a.product.inch;
    request.format.verbose_words = a.product.verbose_words;
    request.format.separate_files = a.product.separate_files;
    request.format.continue_on_unknown = a.continue_on_unknown;
    request.cpu_s = a.limits.max_cpu_s;
    request.memory_bytes = a.limits.memory_mb << 20U;
    return request;
}

int write_path_program(const WriteArguments& a, apps::Findings& findings) {
    const bool to_standard_output = apps::output_destination(a.product.file) == os::kStandardStream;
    if (const auto conflict =
            apps::sarif_conflict(findings.options(), apps::output_destination(a.product.file)))
        return findings.fail(Kind::usage, conflict->message);
    if (a.product.overwrite && !a.product.separate_files)
        return findings.fail(
            Kind::usage, "--overwrite applies to the files of --separate-files; --output always replaces");
    if (a.setup.tool && *a.setup.tool != std::floor(*a.setup.tool))
        return findings.fail(Kind::usage, "--tool must be an integer");
    if (a.product.separate_files && to_standard_output)
        return findings.fail(Kind::usage, "--separate-files requires --output");
    auto program = engine::PathTranslation::open(make_request(a, to_standard_output));
    if (!program) return findings.fail(program.error());
    if (auto confined = confine_writing(a, program->path_file()); !confined)
        return findings.fail(Kind::usage, confined.error().message);
    if (const auto read = program->read(); !read) return report_path_failure(findings, read.error());
    const apps::CpuLimitGuard planning_cpu_guard(program->cpu_left_s());
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
    const bool is_output_on_standard_output =
        status == apps::kSuccess && apps::output_destination(a.product.file) == os::kStandardStream;
    return findings.finish(status,
                           is_output_on_standard_output ? Stream::standard_error : Stream::standard_output);
}

}  // namespace

std::unique_ptr<apps::Program> apps::make_path2gcode() {
    return std::make_unique<ProgramWithArguments<WriteArguments>>(
        kPath2gcode, "Writes a path of points as a part program (G-code)", add_write_options, run_write);
}
