#include "apps/language.h"

#include "apps/aliases.h"
#include "grammar/control_name.h"

namespace gsim::apps {

namespace {

constexpr const char* kUsualDialect = "ab9";

tl::expected<grammar::ControlName, std::string> control_of(const LanguageNames& names,
                                                           const machine::ProgramTable& program) {
    if (!names.dialect.empty()) return grammar::control_named(names.dialect);
    if (program.dialect.empty()) return grammar::control_named(kUsualDialect);
    return grammar::control_named(program.dialect).map_error([](const std::string& error) {
        return "'dialect' under [program] of the machine file: " + error;
    });
}

}  // namespace

void add_language_options(CommandLine& line, LanguageNames& names) {
    line.add(
            "--dialect", &names.dialect,
            "language of the part program: ab9 (Allen-Bradley 9/Series), rs274ngc (LinuxCNC), or the name of "
            "a control; without it that of the machine file, else ab9")
        .suggests(grammar::control_names());
    line.add("--unknown", &names.unknown,
             "what a code is that the dialect does not have: an error, or left out with a warning")
        .one_of({"error", "warn"})
        .shows_default();
}

tl::expected<Language, std::string> language_of(const LanguageNames& names,
                                                const machine::ProgramTable& program,
                                                const machine::MachineData& data) {
    auto control = control_of(names, program);
    if (!control) return tl::unexpected(control.error());
    return aliases_of(data).map([&](const lexer::Aliases& aliases) {
        return Language{.dialect = control->dialect,
                        .aliases = aliases,
                        .unknown = names.unknown == "warn" ? codegen::Unknown::warn : codegen::Unknown::error,
                        .units = program.units,
                        .caution = control->caution};
    });
}

double start_unit_mm(const Language& language) {
    return machine::unit_mm(language.units.value_or(machine::ProgramUnits::mm));
}

}  // namespace gsim::apps
