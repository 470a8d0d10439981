#include "machine/file/program_section.h"

#include <array>

#include "base/units.h"

namespace gsim::machine {

using base::FirstError;
using base::TomlSection;
using base::TomlWriter;

using std::string_view_literals::operator""sv;

namespace {

constexpr std::array kProgramKeys{"dialect"sv, "units"sv};
constexpr std::array kUnitNames{"mm"sv, "inch"sv};  // in the order of ProgramUnits

}  // namespace

double unit_mm(ProgramUnits units) {
    return units == ProgramUnits::inch ? kMmPerInch : 1;
}

ProgramTable read_program_section(FirstError& error, const toml::table* table) {
    ProgramTable program;
    if (table == nullptr) return program;
    TomlSection section(error, *table, "[program]", kProgramKeys);
    if (section.has("dialect")) program.dialect = section.text("dialect");
    if (section.has("dialect") && program.dialect.empty())
        section.fail("dialect", "'dialect' is empty; remove it if no dialect is specified");
    if (section.has("units"))
        program.units = static_cast<ProgramUnits>(section.choice("units", 0, kUnitNames));
    return program;
}

void print_program_section(TomlWriter& out, const ProgramTable& program) {
    if (program == ProgramTable{}) return;
    out.section("[program]");
    if (!program.dialect.empty()) out.line("dialect", base::toml_string(program.dialect));
    if (program.units)
        out.line("units", base::toml_string(kUnitNames[static_cast<std::size_t>(*program.units)]));
}

Result<ProgramTable> read_program_table(std::string_view toml_text, std::string_view file_name) {
    FirstError error(file_name);
    const toml::table root = base::parse_toml(error, toml_text);
    const toml::node* node = root.get("program");
    if (node != nullptr && !node->is_table())
        error.report(node->source().begin, "'program' must be a table, under [program]");
    const ProgramTable program = read_program_section(error, node == nullptr ? nullptr : node->as_table());
    if (error.text()) return tl::unexpected(*error.text());
    return program;
}

}  // namespace gsim::machine
