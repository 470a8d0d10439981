#include <fmt/format.h>

#include "engine/src/machine/data_json.h"
#include "engine/src/run/aliases.h"
#include "engine/src/run/variables_text.h"
#include "machine/data/machine_data_document.h"
#include "machine/file/machine_file.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"

namespace gsim::fuzz {
namespace {

using machine::MachineDataDocument;

std::vector<machine::Axis> data_axes() {
    return machine::read_machine(machine::built_in_machine_toml(), "built-in machine").value().axes;
}

/// Data that are rewritten mean the same.
std::optional<std::string> fault_of_data(const machine::MachineData& data,
                                         const std::vector<machine::Axis>& axes) {
    const std::string text = machine::write_machine_data(data, axes);
    const auto repeated = machine::read_machine_data(text, "again", axes);
    if (!repeated) return fmt::format("what is written is refused: {}\n{}", repeated.error().message, text);
    if (*repeated != data) return fmt::format("what is written means other data:\n{}", text);
    if (const auto aliases = engine::make_aliases(data); !aliases)
        return fault_of_sentence(aliases.error().message);
    return std::nullopt;
}

/// In inches and back; values that are too large for it may be refused.
std::optional<std::string> fault_of_conversion(MachineDataDocument document) {
    const std::string before = document.text();
    for (const auto unit : {machine::LengthUnit::inch, machine::LengthUnit::metric}) {
        const std::string text = document.text();
        if (const auto done = document.convert(unit); !done) {
            if (document.text() != text) return "a conversion that is refused has changed the file";
            return fault_of_sentence(done.error().message);
        }
    }
    return std::nullopt;
}

}  // namespace

Outcome check_machine_data(std::string_view text) {
    const std::string file = name_beside(".txt");
    const std::vector<machine::Axis> axes = data_axes();
    auto document = MachineDataDocument::read(text, file, axes);
    const auto data = machine::read_machine_data(text, file, axes);
    if (document.has_value() != data.has_value())
        return broken("document and data do not agree on what is right");
    if (!document) {
        if (document.error().empty()) return broken("a refusal without an error");
        for (const gsim::Error& error : document.error()) {
            if (auto violation = fault_of_error(error.message, file)) return broken(*std::move(violation));
        }
        if (document.error().front() != data.error())
            return broken("document and data name other first errors");
        return rejected();
    }
    if (document->text() != text) return broken("the file does not come back byte for byte");
    if (document->data() != *data) return broken("document and data mean other things");
    if (auto violation = fault_of_data(*data, axes)) return broken(*std::move(violation));
    if (const auto updated = document->update(*data); !updated)
        return broken("its own data cannot be written: " + updated.error().message);
    if (document->text() != text) return broken("its own data change the file");
    if (auto violation = fault_of_conversion(*std::move(document))) return broken(*std::move(violation));
    return accepted();
}

Outcome check_machine_data_json(std::string_view json) {
    const std::string file = name_beside(".json");
    const std::vector<machine::Axis> axes = data_axes();
    const auto document = engine::data_from_json(json, file, axes);
    if (!document) {
        if (auto violation = fault_of_sentence(document.error().message))
            return broken(*std::move(violation));
        if (!document.error().message.starts_with(file))
            return broken("an error without its file: " + document.error().message);
        return rejected();
    }
    const std::string written = engine::data_to_json(*document).dump();
    const auto repeated = engine::data_from_json(written, file, axes);
    if (!repeated)
        return broken(fmt::format("what is written is refused: {}\n{}", repeated.error().message, written));
    if (repeated->data() != document->data()) return broken("what is written means other data:\n" + written);
    if (auto violation = fault_of_data(document->data(), axes)) return broken(*std::move(violation));
    return accepted();
}

Outcome check_variables(std::string_view text) {
    const std::string file = name_beside(".var");
    const auto values = engine::parse_variables(text, file);
    if (!values) return refused_with(values.error().message, file);
    const std::string written = engine::variables_text(*values);
    const auto repeated = engine::parse_variables(written, file);
    if (!repeated)
        return broken(fmt::format("what is written is refused: {}\n{}", repeated.error().message, written));
    if (*repeated != *values) return broken("what is written means other values:\n" + written);
    return accepted();
}

}  // namespace gsim::fuzz
