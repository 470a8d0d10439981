// gcode2lua: translates a CNC part program into a Lua script.

#include <cstdio>
#include <string>

#include <CLI/CLI.hpp>

#include "apps/exit_status.h"
#include "apps/language.h"
#include "apps/run_main.h"
#include "codegen/language_page.h"
#include "codegen/translate.h"
#include "runtime/simulation/output_file.h"

namespace {

using namespace gsim;

struct Arguments {
    std::string input = "-";
    std::string output;
    apps::LanguageNames language;
    std::string machine_data;
    bool annotate = false;
    bool check = false;
    bool print_language = false;
    std::size_t max_errors = 100;
};

constexpr const char* kProgram = "gcode2lua";

int usage_error(const std::string& message) {
    return apps::usage_error(kProgram, message);
}

void add_options(CLI::App& app, Arguments& arguments) {
    app.add_option("part.nc", arguments.input, "part program, or - for standard input")
        ->capture_default_str();
    app.add_option("-o,--output", arguments.output,
                   "write the Lua to this file; it appears only if all went well");
    apps::add_language_options(app, arguments.language);
    app.add_option("--machine-data", arguments.machine_data, "machine data (NCFILE) with aliases");
    app.add_flag("--annotate", arguments.annotate, "each whole source block as a trailing comment");
    app.add_flag("--print-language", arguments.print_language,
                 "print the reference of both dialects (docs/language.md) and end");
    app.add_flag("--check", arguments.check, "only look for errors, write nothing");
    app.add_option("--max-errors", arguments.max_errors, "stop after this many errors")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}))
        ->capture_default_str();
    app.set_version_flag("--version", "gcode2lua " GSIM_VERSION);
}

tl::expected<lexer::Source, std::string> open_source(const Arguments& arguments) {
    if (arguments.input == "-") return lexer::Source::spool(stdin, "stdin");
    return lexer::Source::open(arguments.input);
}

tl::expected<void, std::string> write_file(const codegen::LuaSpool& spool, const std::string& path) {
    tl::expected<simulation::OutputFile, std::string> file = simulation::OutputFile::open(path);
    if (!file) return tl::unexpected(file.error());
    if (!spool.copy_to(file->stream())) return tl::unexpected(path + ": cannot be written");
    return file->commit();
}

int run(const Arguments& arguments) {
    if (arguments.print_language) {
        std::printf("%s", codegen::language_page().c_str());
        return std::fflush(stdout) == 0 ? apps::kDone : usage_error("standard output cannot be written");
    }
    codegen::TranslateOptions options;
    options.source_name = arguments.input == "-" ? "stdin" : arguments.input;
    options.annotate = arguments.annotate;
    options.max_errors = arguments.max_errors;
    tl::expected<machine::MachineData, std::string> data;
    if (!arguments.machine_data.empty()) data = machine::load_machine_data(arguments.machine_data);
    if (!data) return usage_error(data.error());
    tl::expected<apps::Language, std::string> language = apps::language_of(arguments.language, *data);
    if (!language) return usage_error(language.error());
    options.dialect = language->dialect;
    options.aliases = std::move(language->aliases);
    options.unknown = language->unknown;
    tl::expected<lexer::Source, std::string> source = open_source(arguments);
    if (!source) return usage_error(source.error());
    codegen::LuaSpool spool;
    const codegen::Translation translation =
        codegen::translate(*source, spool, options,
                           [](std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); });
    if (!translation.ok) return apps::kProgramFault;
    if (arguments.check) return apps::kDone;
    if (!arguments.output.empty()) {
        const auto written = write_file(spool, arguments.output);
        return written ? apps::kDone : usage_error(written.error());
    }
    return spool.copy_to(stdout) ? apps::kDone : usage_error("standard output cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
    return apps::run_main<Arguments>(
        argc, argv, kProgram,
        "Translates a CNC part program (G-code) into a Lua script that gsim-run simulates.", add_options,
        run);
}
