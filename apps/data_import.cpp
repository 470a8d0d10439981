#include "apps/data_import.h"

#include "apps/machine_data_file.h"
#include "apps/to_error.h"
#include "base/os/input_file.h"
#include "cli/exit_status.h"
#include "cli/print.h"
#include "engine/controller_settings.h"

namespace gsim::apps {

namespace {

using engine::ControllerSettings;

Result<void> write_text(const DataArguments& arguments, const std::string& text) {
    if (!arguments.output.empty()) return replace_text(arguments.output, text, arguments.wait_s);
    print(text);
    return {};
}

Result<void> write_machine(const DataArguments& arguments, const ControllerSettings& settings) {
    Result<void> written = write_text(arguments, settings.machine_file());
    if (!written || arguments.data.empty()) return written;
    return settings.machine_data().map_error(to_error).and_then(
        [&](const std::string& data) { return replace_text(arguments.data, data, arguments.wait_s); });
}

Result<void> write_table(const DataArguments& arguments, const ControllerSettings& settings) {
    return settings.machine_data().map_error(to_error).and_then(
        [&](const std::string& data) { return write_text(arguments, data); });
}

}  // namespace

const std::string& import_source(const DataArguments& arguments) {
    return arguments.source.empty() ? arguments.file : arguments.source;
}

bool imports_table(const DataArguments& arguments) {
    return ControllerSettings::is_table(import_source(arguments));
}

Result<int> import_settings(const DataArguments& arguments, const engine::Machine* machine,
                            Findings& findings) {
    const std::string& source = import_source(arguments);
    if (source.empty()) return Unexpected("import requires a file: gsim-data import mill.ini");
    const auto text = os::read_text_file(source, os::NameSource::command_line);
    if (!text) return tl::unexpected(text.error());
    const engine::LengthUnit unit = arguments.inch ? engine::LengthUnit::inch : engine::LengthUnit::mm;
    const auto settings =
        ControllerSettings::read(*text, source, engine::Files(), {.unit = unit, .machine = machine});
    if (!settings) return tl::unexpected(settings.error().message);
    for (const engine::Diagnostic& diagnostic : settings->left_out()) findings.add(diagnostic);
    if (!imports_table(arguments) && settings->has_machine_data() && arguments.data.empty()) {
        findings.add({.severity = text::Severity::note,
                      .kind = text::DiagnosticKind::machine,
                      .file = source,
                      .text = "offsets and tools are not written; --data FILE writes them"});
    }
    const Result<void> written =
        imports_table(arguments) ? write_table(arguments, *settings) : write_machine(arguments, *settings);
    return written.map([] { return kSuccess; });
}

}  // namespace gsim::apps
