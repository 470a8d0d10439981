#include "apps/language.h"

#include <CLI/CLI.hpp>

#include "apps/aliases.h"

namespace gsim::apps {

void add_language_options(CLI::App& app, LanguageNames& names) {
    app.add_option("--dialect", names.dialect,
                   "language of the part program: ab9 (Allen-Bradley 9/Series) or rs274ngc (LinuxCNC)")
        ->check(CLI::IsMember({"ab9", "rs274ngc"}))
        ->capture_default_str();
    app.add_option("--unknown", names.unknown,
                   "what a code is that the dialect does not have: an error, or left out with a warning")
        ->check(CLI::IsMember({"error", "warn"}))
        ->capture_default_str();
}

tl::expected<Language, std::string> language_of(const LanguageNames& names,
                                                const machine::MachineData& data) {
    return aliases_of(data).map([&](const lexer::Aliases& aliases) {
        return Language{grammar::dialect_named(names.dialect), aliases,
                        names.unknown == "warn" ? codegen::Unknown::warn : codegen::Unknown::error};
    });
}

}  // namespace gsim::apps
