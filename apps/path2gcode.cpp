// path2gcode: writes a path as a part program for a machine and its controller.

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/ranges.h>

#include "apps/confine_run.h"
#include "apps/data_file.h"
#include "apps/exit_status.h"
#include "apps/findings.h"
#include "apps/limit_options.h"
#include "apps/machine_input.h"
#include "apps/path_input.h"
#include "apps/path_program.h"
#include "apps/program_files.h"
#include "apps/programs.h"
#include "base/os/output_file.h"
#include "codegen/post/post_file.h"

namespace {

using namespace gsim;
namespace fs = std::filesystem;
using Kind = text::DiagnosticKind;

struct WriteArguments {
    std::string input = "-";
    std::string output;  ///< Empty: standard output.
    std::string post = "ab9";
    std::string machine;
    std::string rotary;
    std::string offsets;
    double tolerance_mm = 0.01;
    std::string decimals;
    bool inch = false;
    bool verbose_words = false;
    bool separate_files = false;
    bool overwrite = false;
    bool go_on = false;
    bool quiet = false;
    bool no_confine = false;
    double max_cpu_s = apps::kMaxCpu_s;
    std::uint64_t memory_mb = apps::kMemory_mb;
    apps::FindingOptions findings;
};

constexpr const char* kPath2gcode = "path2gcode";
constexpr const char* kAsGiven = "as-given";
constexpr const char* kLeastTurn = "least-turn";
constexpr std::array<std::pair<const char*, apps::Offsets>, 3> kOffsets = {
    {{"keep", apps::Offsets::keep}, {"none", apps::Offsets::none}, {"G53", apps::Offsets::machine}}};

void add_write_options(apps::CommandLine& line, WriteArguments& a) {
    using apps::FileKind;
    line.add("part.path.json|part.lua", &a.input, "path, or - for a path file on standard input")
        .of_file(FileKind::input, {".json", ".lua"})
        .shows_default();
    line.begin_group("Control and machine");
    line.add("--dialect", &a.post,
             fmt::format("how the controller wants programs: {}, or a file that ends in .toml",
                         fmt::join(codegen::built_in_posts(), ", ")))
        .called("NAME|FILE")
        .of_file(FileKind::input, {".toml"})
        .or_name()
        .shows_default();
    line.add(
            "--machine", &a.machine,
            "machine file (TOML), or a LinuxCNC .ini; without it the 5-axis waterjet gantry that is built in")
        .of_file(FileKind::input, {".toml"});
    line.add("--rotary", &a.rotary,
             "least-turn: rotary axes go the way that turns least; as-given: rotary_deg is taken as it is, "
             "the default for recorded paths")
        .one_of({kLeastTurn, kAsGiven});
    line.add("--offsets", &a.offsets,
             "keep: the work offsets that the recorded run used, the default there; none: all offsets are "
             "taken back; G53: machine coordinates, in which there are no arcs")
        .one_of({kOffsets[0].first, kOffsets[1].first, kOffsets[2].first});
    line.add("--go-on", &a.go_on,
             "what the control has no word for becomes a comment, counted and listed, instead of an error");
    line.add("--tolerance", &a.tolerance_mm, "by which lines in place of an arc may be off it")
        .called("MM")
        .within(1e-4, 10)
        .shows_default();
    line.begin_group("Output");
    line.add("-o,--output", &a.output, "write the program to this file; it appears only if all went well")
        .of_file(FileKind::output, {".nc", ".ngc"});
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

int write_program(const apps::PathProgram& program, const WriteArguments& a, apps::Findings& findings) {
    const std::string output = apps::product_name(a.output);
    const std::vector<apps::TakenFile> taken = {{"the program itself", output},
                                                {"the path", a.input},
                                                {"the machine file", a.machine},
                                                {"the post", a.post},
                                                {"what --sarif names", a.findings.sarif}};
    auto files = apps::ProgramFiles::open(output, program.file_names(), taken, a.overwrite);
    if (!files) return findings.fail(Kind::output, files.error());
    program.write([&](const std::string& name) {
        return [&file = files->file(name)](std::string_view text) { file.write(text); };
    });
    const auto committed = files->commit();
    return committed ? apps::kDone : findings.fail(Kind::output, committed.error());
}

/// A path with a mistake, or one that the machine or the control cannot do.
int path_fault(apps::Findings& findings, const std::string& message) {
    findings.take(text::diagnostic_of(Kind::path, message));
    return apps::kProgramFault;
}

/// From here on nothing is needed but the path and the outputs, those beside the main one too.
tl::expected<void, std::string> confine_writing(const WriteArguments& a, const std::string& path) {
    if (a.no_confine) return {};
    return apps::confine_to(std::array{path}, std::array{a.output, a.findings.sarif});
}

int write_path_program(const WriteArguments& a, apps::Findings& findings) {
    const bool to_standard_output = apps::product_name(a.output) == os::kStandardStream;
    if (const auto conflict = apps::sarif_conflict(findings.options(), apps::product_name(a.output)))
        return findings.fail(Kind::usage, *conflict);
    if (a.overwrite && !a.separate_files)
        return findings.fail(Kind::usage,
                             "--overwrite is for the files of --separate-files; --output replaces");
    if (a.separate_files && to_standard_output)
        return findings.fail(Kind::usage, "--separate-files needs --output");
    const auto post = apps::find_post_file(a.post).and_then(codegen::find_post);
    if (!post) return findings.fail(Kind::input_file, post.error());
    const auto input = apps::read_machine_input(a.machine, os::NamedBy::command_line);
    if (!input) return findings.fail(Kind::input_file, input.error());
    const machine::Machine* machine = &input->machine;
    const auto input_file = apps::find_file(apps::InstalledKind::sample, a.input);
    if (!input_file) return findings.fail(Kind::file, input_file.error());
    if (auto confined = confine_writing(a, *input_file); !confined)
        return findings.fail(Kind::usage, confined.error());
    os::CpuLimit cpu(a.max_cpu_s);
    const auto file = apps::read_path(*input_file, {.memory_bytes = a.memory_mb << 20U}, &cpu);
    if (!file && !file.error().in_path) return findings.fail(Kind::file, file.error().message);
    if (!file) return path_fault(findings, file.error().message);
    const apps::CpuBackstop of_planning(cpu.left_s());

    apps::PathProgramOptions options;
    options.words.inch = a.inch;
    options.words.verbose_words = a.verbose_words;
    if (!a.decimals.empty()) options.words.decimals_mm = a.decimals.front() - '0';
    options.rotary.as_given = a.rotary.empty() ? file->program.is_recorded() : a.rotary == kAsGiven;
    for (const auto& [name, offsets] : kOffsets) {
        if (a.offsets == name) options.offsets = offsets;
    }
    options.go_on = a.go_on;
    options.tolerance_mm = a.tolerance_mm;
    options.separate_files = a.separate_files;
    options.name = to_standard_output ? file->program.name : fs::path(a.output).stem().string();
    const auto program = apps::PathProgram::plan(*file, *machine, *post, options);
    if (!program) return path_fault(findings, program.error());
    for (const std::string& note : program->notes()) {
        if (!a.quiet) findings.take({.severity = text::Severity::note, .kind = Kind::path, .text = note});
    }
    return write_program(*program, a, findings);
}

int run_write(const WriteArguments& a) {
    using Stream = apps::Findings::Stream;
    apps::Findings findings(kPath2gcode, a.findings);
    const int status = write_path_program(a, findings);
    const bool product_on_standard_output =
        status == apps::kDone && apps::product_name(a.output) == os::kStandardStream;
    return findings.finish(status,
                           product_on_standard_output ? Stream::standard_error : Stream::standard_output);
}

}  // namespace

std::unique_ptr<apps::Program> apps::make_path2gcode() {
    return std::make_unique<ProgramOf<WriteArguments>>(
        kPath2gcode, "Writes a path of points as a part program (G-code)", add_write_options, run_write);
}
