#include "apps/data_import.h"

#include <filesystem>

#include <fmt/format.h>

#include "apps/exit_status.h"
#include "apps/machine_data_file.h"
#include "apps/print.h"
#include "base/os/input_file.h"
#include "base/text/letter_case.h"
#include "base/units.h"
#include "runtime/import/import_machine.h"
#include "runtime/import/linuxcnc_tables.h"

namespace gsim::apps {

namespace {

using Written = tl::expected<void, std::string>;

Written write_text(const DataArguments& arguments, const std::string& text) {
    if (!arguments.output.empty()) return replace_text(arguments.output, text, arguments.wait_s);
    print(text);
    return {};
}

void tell(Findings& findings, text::Severity severity, const std::string& file, const std::string& text) {
    findings.take({.severity = severity, .kind = text::DiagnosticKind::machine, .file = file, .text = text});
}

void tell(Findings& findings, const std::string& file, const import::Imported& imported) {
    for (const std::string& warning : imported.warnings)
        tell(findings, text::Severity::warning, file, warning);
    for (const std::string& name : imported.left_out)
        tell(findings, text::Severity::note, file, "not taken over: " + name);
}

Written write_machine(const DataArguments& arguments, const std::string& source, const std::string& text,
                      Findings& findings) {
    const auto imported = import::import_machine(text, source);
    if (!imported) return tl::unexpected(imported.error());
    const auto toml = import::machine_toml(*imported, source);
    if (!toml) return tl::unexpected(toml.error());
    tell(findings, source, *imported);
    if (imported->has_data && arguments.data.empty()) {
        tell(findings, text::Severity::note, source,
             "offsets and tools are not written; --data FILE writes them");
    }
    if (Written written = write_text(arguments, *toml); !written || arguments.data.empty()) return written;
    return import::machine_data_text(*imported).and_then(
        [&](const std::string& data) { return replace_text(arguments.data, data, arguments.wait_s); });
}

// X, Y and Z, which need nothing but letters here.
std::vector<machine::Axis> plain_axes() {
    std::vector<machine::Axis> axes;
    for (const char letter : {'X', 'Y', 'Z'}) axes.push_back({.letter = letter});
    return axes;
}

Written write_table(const DataArguments& arguments, const std::string& source, const std::string& text,
                    const std::optional<machine::Machine>& machine, Findings& findings) {
    const bool tools = text::lower(std::filesystem::path(source).extension().string()) == ".tbl";
    import::Imported imported;
    imported.machine.axes = machine ? machine->axes : plain_axes();
    std::string letters;
    for (const machine::Axis& axis : imported.machine.axes) letters += axis.letter;
    import::TableNotes notes;
    const auto take = tools ? import::take_tools : import::take_parameters;
    const double unit_mm = arguments.inch ? kMmPerInch : 1;
    if (Written taken = take(text, source, unit_mm, letters, imported.data, notes); !taken) return taken;
    imported.left_out = std::move(notes.left_out);
    tell(findings, source, imported);
    return import::machine_data_text(imported).and_then(
        [&](const std::string& data) { return write_text(arguments, data); });
}

}  // namespace

const std::string& import_source(const DataArguments& arguments) {
    return arguments.source.empty() ? arguments.file : arguments.source;
}

bool imports_table(const DataArguments& arguments) {
    const std::string ending =
        text::lower(std::filesystem::path(import_source(arguments)).extension().string());
    return ending == ".tbl" || ending == ".var";
}

tl::expected<int, std::string> import_settings(const DataArguments& arguments,
                                               const std::optional<machine::Machine>& machine,
                                               Findings& findings) {
    const std::string& source = import_source(arguments);
    if (source.empty()) return tl::unexpected(std::string("import needs a file: gsim-data import mill.ini"));
    const bool is_table = imports_table(arguments);
    const auto text = os::read_text_file(source, os::NamedBy::command_line);
    if (!text) return tl::unexpected(text.error());
    if (!is_table && !import::is_control_file(*text, source)) {
        return tl::unexpected(fmt::format(
            "'{}' is no LinuxCNC .ini, .tbl or .var, and has no lines as grbl answers to $$ ($110=500.000)",
            source));
    }
    const Written written = is_table ? write_table(arguments, source, *text, machine, findings)
                                     : write_machine(arguments, source, *text, findings);
    return written.map([] { return kDone; });
}

}  // namespace gsim::apps
