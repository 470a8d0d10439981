#include "engine/src/run/language.h"

#include <optional>
#include <string>

#include "engine/src/run/aliases.h"
#include "grammar/control_name.h"

namespace gsim::engine {

namespace {

constexpr const char* kUsualDialect = "ab9";

tl::expected<grammar::ControlName, std::string> control_of(const LanguageChoice& choice,
                                                           const machine::ProgramTable& program) {
    if (!choice.dialect.empty()) return grammar::control_named(choice.dialect);
    if (program.dialect.empty()) return grammar::control_named(kUsualDialect);
    return grammar::control_named(program.dialect).map_error([](const std::string& error) {
        return "'dialect' under [program] of the machine file: " + error;
    });
}

}  // namespace

tl::expected<Language, std::string> language_of(const LanguageChoice& choice,
                                                const machine::ProgramTable& program,
                                                const machine::MachineData& data) {
    auto control = control_of(choice, program);
    if (!control) return tl::unexpected(control.error());
    return aliases_of(data).map([&](const lexer::Aliases& aliases) {
        return Language{.dialect = control->dialect,
                        .aliases = aliases,
                        .unknown = choice.unknown == LanguageChoice::kWarn ? codegen::Unknown::warn
                                                                           : codegen::Unknown::error,
                        .units = program.units,
                        .caution = control->caution};
    });
}

std::vector<std::string> control_names() {
    return grammar::control_names();
}

std::optional<std::string> why_no_control(const std::string& name) {
    const auto control = grammar::control_named(name);
    if (control) return std::nullopt;
    return control.error();
}

double start_unit_mm(const Language& language) {
    return machine::unit_mm(language.units.value_or(machine::ProgramUnits::mm));
}

}  // namespace gsim::engine
