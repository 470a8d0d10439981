#include "engine/src/run/language.h"

#include <optional>
#include <string>

#include "engine/src/run/aliases.h"
#include "grammar/controller_name.h"

namespace gsim::engine {

namespace {

constexpr const char* kDefaultDialect = "ab9";

Result<grammar::ControllerName> resolve_controller(const LanguageOptions& language_options,
                                                   const machine::ProgramTable& program) {
    if (!language_options.dialect.empty()) return grammar::find_controller(language_options.dialect);
    if (program.dialect.empty()) return grammar::find_controller(kDefaultDialect);
    return grammar::find_controller(program.dialect).map_error([](const std::string& error) {
        return "'dialect' under [program] of the machine file: " + error;
    });
}

}  // namespace

Result<Language> make_language(const LanguageOptions& language_options, const machine::ProgramTable& program,
                               const machine::MachineData& data) {
    auto controller = resolve_controller(language_options, program);
    if (!controller) return tl::unexpected(controller.error());
    return make_aliases(data).map([&](const lexer::Aliases& aliases) {
        return Language{.dialect = controller->dialect,
                        .aliases = aliases,
                        .unknown = language_options.unknown == LanguageOptions::kWarn
                                       ? codegen::UnknownCodePolicy::warn
                                       : codegen::UnknownCodePolicy::error,
                        .units = program.units,
                        .caution = controller->caution};
    });
}

std::vector<std::string> controller_names() {
    return grammar::controller_names();
}

std::optional<std::string> find_controller_error(const std::string& name) {
    const auto controller = grammar::find_controller(name);
    if (controller) return std::nullopt;
    return controller.error();
}

double start_unit_mm(const Language& language) {
    return machine::unit_mm(language.units.value_or(machine::ProgramUnits::mm));
}

}  // namespace gsim::engine
