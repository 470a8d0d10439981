#include <fmt/format.h>

#include "machine/data/machine_data_document.h"
#include "machine/file/machine_file.h"
#include "machine/import/grbl_dump.h"
#include "machine/import/import_machine.h"
#include "machine/import/linuxcnc_ini.h"
#include "machine/import/linuxcnc_tables.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/small_run.h"

namespace gsim::fuzz {
namespace {

using import::ImportResult;

constexpr std::string_view kLetters = "XYZBC";
constexpr double kMmPerInch = 25.4;

/// Imported settings can be written, or a message names what no file can hold; written files are right.
std::optional<std::string> fault_of_files(const ImportResult& imported, const std::string& file) {
    for (const auto* reported : {&imported.warnings, &imported.left_out}) {
        for (const std::string& message : *reported) {
            if (auto violation = fault_of_sentence(message)) return violation;
        }
    }
    const auto data = import::machine_data_text(imported);
    if (!data) return fault_of_sentence(data.error().message);
    const auto read = machine::read_machine_data(*data, file, imported.machine.axes);
    if (!read) return fmt::format("the machine data are refused: {}\n{}", read.error().message, *data);
    return std::nullopt;
}

std::optional<std::string> fault_of_machine(const ImportResult& imported, const std::string& file) {
    const auto toml = import::machine_toml(imported, file);
    if (!toml) return "a machine that is taken over cannot be written: " + toml.error().message;
    const auto machine = machine::read_machine(*toml, file);
    if (!machine) return fmt::format("the machine file is refused: {}\n{}", machine.error().message, *toml);
    if (machine->axes.size() != imported.machine.axes.size()) return "the machine file lacks axes";
    return std::nullopt;
}

/// An error about a missing item has no line.
std::optional<std::string> fault_of_import(const std::string& error, const std::string& file) {
    for (const std::string_view missing :
         {"is missing", ": neither [", "names no axes", "no range", "do not make a valid machine"}) {
        if (error.find(missing) != std::string::npos) return fault_of_sentence(error);
    }
    return fault_of_error(error, file);
}

Outcome outcome_of_import(const Result<ImportResult>& imported, const std::string& file) {
    if (!imported) {
        if (auto violation = fault_of_import(imported.error().message, file))
            return broken(*std::move(violation));
        return rejected();
    }
    if (auto violation = fault_of_files(*imported, file)) return broken(*std::move(violation));
    if (auto violation = fault_of_machine(*imported, file)) return broken(*std::move(violation));
    Outcome outcome = outcome_of(run_moves({.machine = imported->machine}));
    outcome.accepted = true;
    return outcome;
}

template <typename Take>
Outcome check_table(Take take, std::string_view text, const std::string& file, double unit_mm) {
    ImportResult imported;
    for (const char letter : kLetters) {
        imported.machine.axes.push_back(
            {.letter = letter, .kind = letter < 'U' ? machine::AxisKind::rotary : machine::AxisKind::linear});
    }
    import::ImportNotes notes;
    if (const auto taken = take(text, file, unit_mm, kLetters, imported.data, notes); !taken)
        return refused_with(taken.error().message, file);
    imported.left_out = std::move(notes.left_out);
    if (auto violation = fault_of_files(imported, file)) return broken(*std::move(violation));
    return accepted();
}

}  // namespace

Outcome check_tool_table(std::string_view text) {
    return check_table(import::import_tools, text, name_beside(".tbl"), kMmPerInch);
}

Outcome check_parameters(std::string_view text) {
    return check_table(import::import_parameters, text, name_beside(".var"), 1);
}

Outcome check_linuxcnc_ini(std::string_view text) {
    const std::string file = name_beside(".ini");
    return outcome_of_import(import::import_machine(text, file), file);
}

Outcome check_grbl_settings(std::string_view text) {
    const std::string file = name_beside(".txt");
    const auto imported = import::import_machine(text, file);
    if (imported && !import::is_grbl_dump(text))
        return broken("settings are read that are not known as such");
    return outcome_of_import(imported, file);
}

}  // namespace gsim::fuzz
