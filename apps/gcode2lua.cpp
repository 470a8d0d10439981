// gcode2lua: translates a CNC part program into a Lua script.

#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "apps/confine_run.h"
#include "apps/findings.h"
#include "apps/language_options.h"
#include "apps/limit_options.h"
#include "apps/programs.h"
#include "base/os/output_file.h"
#include "cli/exit_status.h"
#include "cli/print.h"
#include "engine/system/system_host.h"
#include "engine/translation.h"

namespace {

using namespace gsim;
using Kind = text::DiagnosticKind;

struct TranslateArguments {
    std::string input = "-";
    std::string output;  ///< Empty: standard output.
    engine::TranslationRequest request;
    bool check = false;
    bool print_language = false;
    bool no_confine = false;
    apps::FindingOptions findings;
};

constexpr const char* kGcode2lua = "gcode2lua";

void add_translate_options(apps::CommandLine& line, TranslateArguments& arguments) {
    using apps::FileKind;
    line.add("part.nc", &arguments.input, "part program, or - for standard input")
        .takes_file(FileKind::input, {".nc", ".ngc"})
        .show_default();
    line.begin_group("Language");
    apps::add_language_options(line, arguments.request.language);
    line.add("--machine", &arguments.request.machine,
             "machine file (TOML): dialect and units of its programs")
        .takes_file(FileKind::input, {".toml"});
    line.add("--machine-data", &arguments.request.machine_data, "machine data (NCFILE) with aliases")
        .takes_file(FileKind::input, {".txt"});
    line.begin_group("Output");
    line.add("-o,--output", &arguments.output, "write the Lua to this file; it is created only on success")
        .takes_file(FileKind::output, {".lua"});
    line.add("--annotate", &arguments.request.annotate, "add each source block as a trailing comment");
    line.begin_group("Instead of a translation");
    line.add("--check", &arguments.check, "only check for errors, write nothing");
    line.add("--print-language", &arguments.print_language,
             "print the reference of both dialects (docs/language.md) and exit");
    line.begin_group("Diagnostics");
    apps::add_finding_options(line, arguments.findings);
    line.begin_group("Limits");
    line.add("--max-errors", &arguments.request.max_errors, "stop after this many errors")
        .within(1, 1'000'000)
        .show_default();
    apps::add_cpu_option(line, arguments.request.cpu_s);
    apps::add_confine_option(line, arguments.no_confine);
    line.add_example("gcode2lua part.nc -o part.lua", "line n of the program is line n+1 of the script");
    line.add_example("gcode2lua --check part.nc", "all errors with line and column");
    line.add_example("gcode2lua --dialect rs274ngc part.ngc | gsim-run -", "translate and run");
}

Result<void> write_lua(const engine::Translation& translation, const std::string& path) {
    Result<os::OutputFile> file = os::OutputFile::open(path);
    if (!file) return tl::unexpected(file.error());
    return translation.write([&](std::string_view part) { return file->write(part); })
        .map_error([](const engine::Error& error) { return error.message; })
        .and_then([&] { return file->commit(); });
}

/// Confines the process once the program is open, because from here on it needs only the outputs.
Result<void> confine_translation(const TranslateArguments& arguments, engine::Translation& translation) {
    if (arguments.no_confine) return {};
    translation.reserve_space();
    return apps::confine_to({}, std::array{arguments.output, arguments.findings.sarif});
}

tl::expected<engine::Translation, engine::Error> open_translation(const TranslateArguments& arguments) {
    engine::TranslationRequest request = arguments.request;
    request.host = engine::make_system_host();
    request.program = arguments.input;
    if (arguments.input != os::kStandardStream) return engine::Translation::open(std::move(request));
    return engine::Text::from_stream(stdin, "stdin")
        .map_error([&](std::string message) {
            return engine::Error{.code = "file", .message = std::move(message), .file = arguments.input};
        })
        .and_then([&](engine::Text text) {
            request.text = std::move(text);
            return engine::Translation::open(std::move(request));
        });
}

/// Translates as the arguments say, and reports errors; returns the exit status.
int translate_program(const TranslateArguments& arguments, apps::Findings& findings) {
    if (!arguments.check) {
        if (const auto conflict =
                apps::sarif_conflict(findings.options(), apps::output_destination(arguments.output)))
            return findings.fail(Kind::usage, conflict->message);
    }
    auto translation = open_translation(arguments);
    if (!translation) return findings.fail(translation.error());
    if (auto confined = confine_translation(arguments, *translation); !confined)
        return findings.fail(Kind::usage, confined.error().message);
    const auto result =
        translation->make([&](const engine::Diagnostic& diagnostic) { findings.add(diagnostic); });
    if (!result) return result.error().in_program ? apps::kProgramError : findings.fail(result.error());
    if (arguments.check) return apps::kSuccess;
    const auto written = write_lua(*translation, apps::output_destination(arguments.output));
    return written ? apps::kSuccess : findings.fail(Kind::output, written.error().message);
}

int run_translate(const TranslateArguments& arguments) {
    using Stream = apps::Findings::Stream;
    if (arguments.print_language) {
        apps::print(engine::language_page());
        return apps::kSuccess;
    }
    apps::Findings findings(kGcode2lua, arguments.findings);
    const int status = translate_program(arguments, findings);
    const bool lua_on_standard_output = status == apps::kSuccess && !arguments.check &&
                                        apps::output_destination(arguments.output) == os::kStandardStream;
    return findings.finish(status, lua_on_standard_output ? Stream::standard_error : Stream::standard_output);
}

}  // namespace

std::unique_ptr<apps::Program> apps::make_gcode2lua() {
    return std::make_unique<ProgramWithArguments<TranslateArguments>>(
        kGcode2lua, "Translates a CNC part program (G-code) into a Lua script that gsim-run simulates",
        add_translate_options, run_translate);
}
