// gcode2lua: translates a CNC part program into a Lua script.

#include <array>
#include <cstdio>
#include <string>

#include <fmt/format.h>

#include "apps/confine_run.h"
#include "apps/data_file.h"
#include "apps/exit_status.h"
#include "apps/findings.h"
#include "apps/language.h"
#include "apps/limit_options.h"
#include "apps/machine_input.h"
#include "apps/print.h"
#include "apps/programs.h"
#include "apps/translation.h"
#include "base/os/output_file.h"
#include "codegen/language_page.h"
#include "codegen/translate.h"

namespace {

using namespace gsim;

struct TranslateArguments {
    std::string input = "-";
    std::string output;  ///< Empty: standard output.
    apps::LanguageNames language;
    std::string machine;
    std::string machine_data;
    bool annotate = false;
    bool check = false;
    bool print_language = false;
    std::uint64_t max_errors = 100;
    double max_cpu_s = apps::kMaxCpu_s;
    bool no_confine = false;
    apps::FindingOptions findings;
};

constexpr const char* kGcode2lua = "gcode2lua";

void add_translate_options(apps::CommandLine& line, TranslateArguments& arguments) {
    using apps::FileKind;
    line.add("part.nc", &arguments.input, "part program, or - for standard input")
        .of_file(FileKind::input, {".nc", ".ngc"})
        .shows_default();
    line.begin_group("Language");
    apps::add_language_options(line, arguments.language);
    line.add("--machine", &arguments.machine, "machine file (TOML): dialect and units of its programs")
        .of_file(FileKind::input, {".toml"});
    line.add("--machine-data", &arguments.machine_data, "machine data (NCFILE) with aliases")
        .of_file(FileKind::input, {".txt"});
    line.begin_group("Output");
    line.add("-o,--output", &arguments.output, "write the Lua to this file; it appears only if all went well")
        .of_file(FileKind::output, {".lua"});
    line.add("--annotate", &arguments.annotate, "each whole source block as a trailing comment");
    line.begin_group("Instead of a translation");
    line.add("--check", &arguments.check, "only look for errors, write nothing");
    line.add("--print-language", &arguments.print_language,
             "print the reference of both dialects (docs/language.md) and end");
    line.begin_group("Diagnostics");
    apps::add_finding_options(line, arguments.findings);
    line.begin_group("Limits");
    line.add("--max-errors", &arguments.max_errors, "stop after this many errors")
        .within(1, 1'000'000)
        .shows_default();
    apps::add_cpu_option(line, arguments.max_cpu_s);
    apps::add_confine_option(line, arguments.no_confine);
    line.add_example("gcode2lua part.nc -o part.lua", "line n of the program is line n+1 of the script");
    line.add_example("gcode2lua --check part.nc", "all errors with line and column");
    line.add_example("gcode2lua --dialect rs274ngc part.ngc | gsim-run -", "translate and run");
}

tl::expected<lexer::Source, std::string> open_source(const TranslateArguments& arguments) {
    if (arguments.input == "-")
        return lexer::Source::spool(stdin, std::string(lexer::Source::kStandardInput));
    return apps::find_file(apps::InstalledKind::sample, arguments.input)
        .and_then(
            [](const std::string& file) { return lexer::Source::open(file, os::NamedBy::command_line); });
}

tl::expected<void, std::string> write_spool(const codegen::LuaSpool& spool, const std::string& path) {
    tl::expected<os::OutputFile, std::string> file = os::OutputFile::open(path);
    if (!file) return tl::unexpected(file.error());
    return spool.copy_to([&](std::string_view part) { file->write(part); }).and_then([&] {
        return file->commit();
    });
}

/// From here on nothing but the outputs is needed; the program is open.
tl::expected<void, std::string> confine_translation(const TranslateArguments& arguments,
                                                    codegen::LuaSpool& spool) {
    if (arguments.no_confine) return {};
    spool.reserve_file();
    return apps::confine_to({}, std::array{arguments.output, arguments.findings.sarif});
}

/// Translates as the arguments say, and tells what is wrong; the exit status.
int translate_program(const TranslateArguments& arguments, apps::Findings& findings) {
    using Kind = text::DiagnosticKind;
    os::CpuLimit cpu(arguments.max_cpu_s);
    if (!arguments.check) {
        if (const auto conflict =
                apps::sarif_conflict(findings.options(), apps::product_name(arguments.output)))
            return findings.fail(Kind::usage, *conflict);
    }
    codegen::TranslateOptions options;
    options.annotate = arguments.annotate;
    options.max_errors = arguments.max_errors;
    tl::expected<machine::MachineData, std::string> data;
    if (!arguments.machine_data.empty())
        data = machine::load_machine_data(arguments.machine_data, {}, os::NamedBy::command_line);
    if (!data) return findings.fail(Kind::input_file, data.error(), arguments.machine_data);
    tl::expected<machine::ProgramTable, std::string> program;
    if (!arguments.machine.empty()) program = apps::read_program_input(arguments.machine);
    if (!program) return findings.fail(Kind::input_file, program.error(), arguments.machine);
    auto language = apps::language_of(arguments.language, *program, *data);
    if (!language) return findings.fail(Kind::input_file, language.error());
    tl::expected<lexer::Source, std::string> source = open_source(arguments);
    if (!source) return findings.fail(Kind::file, source.error(), arguments.input);
    language->cpu = &cpu;
    codegen::LuaSpool spool;
    if (auto confined = confine_translation(arguments, spool); !confined)
        return findings.fail(Kind::usage, confined.error());
    const codegen::Translation translation = apps::translate_source(
        *source, spool, *language, options, [&](const auto& told) { findings.take(told); });
    if (const auto fault = source->fault()) return findings.fail(Kind::file, *fault);
    if (!translation.ok) return apps::kProgramFault;
    if (arguments.check) return apps::kDone;
    const auto written = write_spool(spool, apps::product_name(arguments.output));
    return written ? apps::kDone : findings.fail(Kind::output, written.error());
}

int run_translate(const TranslateArguments& arguments) {
    using Stream = apps::Findings::Stream;
    if (arguments.print_language) {
        apps::print(codegen::language_page());
        return apps::kDone;
    }
    apps::Findings findings(kGcode2lua, arguments.findings);
    const int status = translate_program(arguments, findings);
    const bool lua_on_standard_output = status == apps::kDone && !arguments.check &&
                                        apps::product_name(arguments.output) == os::kStandardStream;
    return findings.finish(status, lua_on_standard_output ? Stream::standard_error : Stream::standard_output);
}

}  // namespace

std::unique_ptr<apps::Program> apps::make_gcode2lua() {
    return std::make_unique<ProgramOf<TranslateArguments>>(
        kGcode2lua, "Translates a CNC part program (G-code) into a Lua script that gsim-run simulates",
        add_translate_options, run_translate);
}
