#pragma once

#include <string>

#include <tl/expected.hpp>

#include "apps/script_input.h"
#include "runtime/machine/machine_data.h"

namespace CLI {
class App;
}

namespace gsim::apps {

/// The options of both programs that say how G-code is read, as they are given.
struct LanguageNames {
    std::string dialect = "ab9";
    std::string unknown = "error";
};

/// --dialect and --unknown.
void add_language_options(CLI::App& app, LanguageNames& names);

/// What the options and the machine data mean together; the error is a sentence.
tl::expected<Language, std::string> language_of(const LanguageNames& names, const machine::MachineData& data);

}  // namespace gsim::apps
