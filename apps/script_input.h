#pragma once

#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "codegen/translate.h"
#include "runtime/script/engine.h"

namespace gsim::apps {

/// Why an input cannot be run: a file that cannot be read (usage), or a program with errors, which have been
/// printed.
struct InputError {
    bool in_program = false;
    std::string message;
};

/// How G-code is read: the language, the names that the machine data give to codes, and what to make of codes
/// that the language does not have.
struct Language {
    const grammar::Dialect* dialect = &grammar::dialect_ab9();
    lexer::Aliases aliases;
    codegen::Unknown unknown = codegen::Unknown::error;
};

/// Reads part.lua or part.nc (or standard input, "-", which is looked at to tell which it is) as a script;
/// G-code is translated first, with its diagnostics on standard error.
tl::expected<script::Script, InputError> read_script(const std::string& path, const Language& language);

/// Finds the file of a program that is called but not in the script: O0002.nc and the like, or
/// NAME_O0002.ppg, or sub.ngc by its name, in the folder of the main file.
script::FindProgram program_finder(const std::string& main_path, const Language& language);

}  // namespace gsim::apps
