// gsim-data: shows, changes and checks machine data (NCFILE), as the form of a controller does.

#include <string>

#include <CLI/CLI.hpp>

#include "apps/data_commands.h"
#include "apps/run_main.h"

namespace {

using namespace gsim;
using apps::DataArguments;
using apps::DataCommand;

constexpr const char* kProgram = "gsim-data";

constexpr const char* kExamples =
    "Sections: OFFSET, FIXED, REFERENCE, HOME, TOOL, VARIABLE, ALIAS, SECURITY, WORKING.\n"
    "Examples:\n"
    "  gsim-data jet.txt list OFFSET\n"
    "  gsim-data jet.txt get TOOL 1 LENGTH\n"
    "  gsim-data jet.txt set OFFSET 54 X=200.0001 Y=200.0002\n"
    "  gsim-data jet.txt set TOOL 2 LENGTH=2 DIAMETER=0.04 KIND=JET --inch --create\n"
    "  gsim-data jet.txt reset OFFSET 54\n"
    "  gsim-data jet.txt check --machine mine.toml\n"
    "  gsim-data jet.txt convert --json\n"
    "Exit statuses: 0 done, 1 errors in the data (check), 2 options or files.";

CLI::App& add_command(CLI::App& app, DataArguments& a, const char* name, DataCommand command,
                      const char* description) {
    CLI::App& added = *app.add_subcommand(name, description);
    added.callback([&a, command] { a.command = command; });
    added.fallthrough();
    return added;
}

void add_entry(CLI::App& command, DataArguments& a) {
    command.add_option("SECTION", a.section, "OFFSET, TOOL, ...")->required();
    command.add_option("ID", a.id, "number of the entry, code of the frame, name of the alias")->required();
}

void add_units(CLI::App& command, DataArguments& a, const char* inch, const char* metric) {
    CLI::Option* in = command.add_flag("--inch", a.inch, inch);
    command.add_flag("--metric", a.metric, metric)->excludes(in);
}

void add_set(CLI::App& app, DataArguments& a) {
    CLI::App& set =
        add_command(app, a, "set", DataCommand::set, "change an entry, or add it to the end of its section");
    add_entry(set, a);
    set.add_option("FIELD=VALUE", a.changes, "such as X=200.5; an empty value takes it away")->required();
    add_units(set, a, "the lengths are inches; an entry in mm is converted",
              "the lengths are mm; an entry in inches is converted");
    set.add_flag("--create", a.create, "begin a new file where there is none");
}

void add_convert(CLI::App& app, DataArguments& a) {
    CLI::App& convert =
        add_command(app, a, "convert", DataCommand::convert, "to one unit, to JSON (--json), or from JSON");
    add_units(convert, a, "all lengths in inches", "all lengths in mm");
    convert.add_option("--from-json", a.from_json, "make the file from this JSON");
    convert.add_option("-o,--output", a.output,
                       "write here, not over the file (or, for JSON, to standard output)");
}

void add_options(CLI::App& app, DataArguments& a) {
    app.add_option("FILE", a.file, "machine data (NCFILE)")->required();
    app.add_option("--machine", a.machine,
                   "machine file (TOML): names the axes behind X, Y and Z, and has ranges to check");
    app.add_flag("--json", a.json, "list, get, convert: print JSON");
    app.set_version_flag("--version", "gsim-data " GSIM_VERSION);
    app.require_subcommand(1);
    app.footer(kExamples);
    add_command(app, a, "list", DataCommand::list, "print all entries, or those of a section")
        .add_option("SECTION", a.section, "OFFSET, TOOL, ...");
    CLI::App& get = add_command(app, a, "get", DataCommand::get, "print an entry, or one value of it");
    add_entry(get, a);
    get.add_option("FIELD", a.field, "such as X or LENGTH");
    add_set(app, a);
    add_entry(add_command(app, a, "reset", DataCommand::reset,
                          "set the values of an entry to 0; an alias or a zone goes away"),
              a);
    add_command(app, a, "reset-all", DataCommand::reset_all, "reset all entries, or those of a section")
        .add_option("SECTION", a.section, "OFFSET, TOOL, ...");
    add_command(app, a, "check", DataCommand::check,
                "print errors and what is suspect, with line and column");
    add_convert(app, a);
}

int run(const DataArguments& arguments) {
    const auto status = apps::run_data_command(arguments);
    return status ? *status : apps::usage_error(kProgram, status.error());
}

}  // namespace

int main(int argc, char** argv) {
    return apps::run_main<DataArguments>(
        argc, argv, kProgram,
        "Shows, changes and checks the data of a controller: offsets, points, "
        "tools, variables, aliases, zones.",
        add_options, run);
}
