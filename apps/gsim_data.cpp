// gsim-data: shows, changes and checks machine data (NCFILE), like the form of a controller.

#include <string>

#include "apps/confine_run.h"
#include "apps/data_commands.h"
#include "apps/programs.h"

namespace {

using namespace gsim;
using apps::DataArguments;
using apps::DataCommand;

constexpr const char* kGsimData = "gsim-data";

apps::CommandLine& add_data_command(apps::CommandLine& line, DataArguments& a, const char* name,
                                    DataCommand command, const char* description) {
    apps::CommandLine& subcommand =
        line.add_command(name, description, [&a, command] { a.command = command; });
    subcommand.begin_group("Options");
    return subcommand;
}

void add_section(apps::CommandLine& command, DataArguments& a) {
    command.add("SECTION", &a.section, "OFFSET, TOOL, ...");
}

void add_entry(apps::CommandLine& command, DataArguments& a) {
    command.add("SECTION", &a.section, "OFFSET, TOOL, ...").make_required();
    command.add("ID", &a.id, "number of the entry, code of the frame, name of the alias").make_required();
}

void add_units(apps::CommandLine& command, DataArguments& a, const char* inch, const char* metric) {
    command.add("--inch", &a.inch, inch);
    command.add("--metric", &a.metric, metric).exclude_option("--inch");
}

void add_set(apps::CommandLine& line, DataArguments& a) {
    apps::CommandLine& set = add_data_command(line, a, "set", DataCommand::set,
                                              "change an entry, or add it to the end of its section");
    add_entry(set, a);
    set.add("FIELD=VALUE", &a.changes, "such as X=200.5; an empty value removes it").make_required();
    add_units(set, a, "the lengths are inches; an entry in mm is converted",
              "the lengths are mm; an entry in inches is converted");
    set.add("--create", &a.create, "create the file if it does not exist");
}

void add_convert(apps::CommandLine& line, DataArguments& a) {
    using apps::FileKind;
    apps::CommandLine& convert = add_data_command(line, a, "convert", DataCommand::convert,
                                                  "convert to one unit, to JSON (--json), or from JSON");
    add_units(convert, a, "all lengths in inches", "all lengths in mm");
    convert.add("--from-json", &a.from_json, "create the file from this JSON")
        .takes_file(FileKind::input, {".json"});
    convert
        .add("-o,--output", &a.output,
             "write to this file instead of FILE (or, for JSON, instead of standard output)")
        .takes_file(FileKind::output);
}

void add_import(apps::CommandLine& line, DataArguments& a) {
    using apps::FileKind;
    apps::CommandLine& command = add_data_command(line, a, "import", DataCommand::import,
                                                  "import a machine file from a LinuxCNC .ini or from grbl's "
                                                  "response to $$; machine data from a .tbl or .var");
    command.add("SETTINGS", &a.source, "the .ini, .tbl or .var file, or grbl's response as text")
        .takes_file(FileKind::input, {".ini", ".tbl", ".var", ".txt"});
    command.add("-o,--output", &a.output, "write to this file instead of standard output")
        .takes_file(FileKind::output, {".toml", ".txt"});
    command.add("--data", &a.data, "write the offsets and tools that a machine's settings name to this file")
        .takes_file(FileKind::output, {".txt"});
    add_units(command, a, "lengths of a .tbl or .var are inches", "lengths of a .tbl or .var are mm");
}

void add_examples(apps::CommandLine& line) {
    line.add_note("Sections: OFFSET, FIXED, REFERENCE, HOME, TOOL, VARIABLE, ALIAS, SECURITY, WORKING.");
    line.add_example("gsim-data jet.txt list OFFSET", "all work offsets");
    line.add_example("gsim-data jet.txt get TOOL 1 LENGTH", "one value");
    line.add_example("gsim-data jet.txt set OFFSET 54 X=200.0001 Y=200.0002", "change an offset");
    line.add_example("gsim-data jet.txt set TOOL 2 LENGTH=2 DIAMETER=0.04 KIND=JET --inch --create",
                     "add a tool");
    line.add_example("gsim-data jet.txt reset OFFSET 54", "set an offset to zero");
    line.add_example("gsim-data jet.txt check --machine mine.toml", "errors in the data on this machine");
    line.add_example("gsim-data jet.txt convert --json", "for other programs");
    line.add_example("gsim-data import mill.ini -o mill.toml --data mill.txt",
                     "a machine file from a LinuxCNC .ini");
}

void add_data_options(apps::CommandLine& line, DataArguments& a) {
    line.add("FILE", &a.file, "machine data (NCFILE)").takes_file(apps::FileKind::changed, {".txt"});
    line.begin_group("Options of all commands");
    line.add("--machine", &a.machine,
             "machine file (TOML): names of the axes after X, Y and Z, and axis ranges to check")
        .takes_file(apps::FileKind::input, {".toml"});
    line.add("--json", &a.findings.json,
             "list, get, convert: print JSON; errors, and results of check, are JSON too");
    apps::add_sarif_option(line, a.findings);
    apps::add_wait_option(line, a.wait_s);
    apps::add_confine_option(line, a.no_confine);
    add_section(
        add_data_command(line, a, "list", DataCommand::list, "print all entries, or those of a section"), a);
    apps::CommandLine& get =
        add_data_command(line, a, "get", DataCommand::get, "print an entry, or one value of it");
    add_entry(get, a);
    get.add("FIELD", &a.field, "such as X or LENGTH");
    add_set(line, a);
    add_entry(add_data_command(line, a, "reset", DataCommand::reset,
                               "set the values of an entry to 0; an alias or a zone is removed"),
              a);
    add_section(add_data_command(line, a, "reset-all", DataCommand::reset_all,
                                 "reset all entries, or those of a section"),
                a);
    add_data_command(line, a, "check", DataCommand::check, "print errors and warnings, with line and column");
    add_convert(line, a);
    add_import(line, a);
    add_examples(line);
}

int run_data(const DataArguments& arguments) {
    apps::Findings findings(kGsimData, arguments.findings);
    const auto status = apps::run_data_command(arguments, findings);
    const bool command_reported =
        status && arguments.command != DataCommand::check;  // prints its own JSON, or none
    const int code =
        status ? *status
               : findings.fail(text::DiagnosticKind::input_file, status.error().message, arguments.file);
    return command_reported ? findings.finish_sarif_only(code)
                            : findings.finish(code, apps::Findings::Stream::standard_output);
}

}  // namespace

std::unique_ptr<apps::Program> apps::make_gsim_data() {
    return std::make_unique<ProgramWithArguments<DataArguments>>(
        kGsimData,
        "Shows, changes and checks the data of a controller: "
        "offsets, points, tools, variables, aliases, zones",
        add_data_options, run_data);
}
