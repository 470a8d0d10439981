#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "base/os/cpu_limit.h"
#include "base/os/files.h"
#include "codegen/lua/lua_spool.h"
#include "codegen/translate.h"
#include "engine/request.h"
#include "lexer/source.h"
#include "machine/model/program_table.h"
#include "runtime/script/lua/script.h"

namespace gsim::engine {

/// Who is told what is wrong with a program's text.
using TellDiagnostic = std::function<void(const text::Diagnostic&)>;

/// Why an input cannot be run: a file that cannot be read (usage), or a program with errors, which have been
/// told.
struct InputError {
    bool in_program = false;
    std::string message;
    std::string file = {};  ///< Of the input; empty where the message names it.
    text::DiagnosticKind kind = text::DiagnosticKind::file;
    std::optional<text::Diagnostic> first_error = {};  ///< Of a program.
};

/// How G-code is read: the language, the names that the machine data give to codes, and what to make of codes
/// that the language does not have.
struct Language {
    const grammar::Dialect* dialect = &grammar::dialect_ab9();
    lexer::Aliases aliases;
    codegen::Unknown unknown = codegen::Unknown::error;
    std::optional<machine::ProgramUnits> units;  ///< In force at the start; none: not said, which is mm.
    std::uint64_t memory_bytes = Limits{}.memory_bytes;  ///< Of the run, for its scripts and their texts.
    os::CpuLimit* cpu = nullptr;                         ///< Of the run that translates, if it has one.
    std::string caution;  ///< Where the control's own language is only near to the dialect: a sentence.
};

/// A script or program that is open, with all that reading it takes of the file system.
struct OpenedScript {
    lexer::Source source;
    bool is_lua = false;
    std::shared_ptr<codegen::LuaSpool> spool;
};

/// Opens part.lua or part.nc.
tl::expected<OpenedScript, InputError> open_script(const os::Files& files, const std::string& path,
                                                   os::NamedBy named_by = os::NamedBy::command_line);

/// A text that is no file, which is looked at to tell whether it is Lua.
OpenedScript opened_text(lexer::Source text);

/// Reads it; G-code is translated. Once.
tl::expected<script::Script, InputError> read_script(OpenedScript& opened, const Language& language,
                                                     const TellDiagnostic& tell);

/// Both.
tl::expected<script::Script, InputError> read_script(const os::Files& files, const std::string& path,
                                                     const Language& language, const TellDiagnostic& tell);

/// The folder of a main program ("-": a text that is no file), in which all lie that it calls.
std::filesystem::path folder_of_program(const std::string& main_path);

/// Finds the file of a program that is called but not in the script: O0002.nc and the like, or
/// NAME_O0002.ppg, or sub.ngc by its name, in the folder of the main file.
script::FindProgram program_finder(const os::Files& files, const std::string& main_path,
                                   const Language& language, const TellDiagnostic& tell);

/// Finds modules of scripts: `shapes` is shapes.lua in the folder of the main program, `lib.shapes`
/// lib/shapes.lua. Nothing is found outside of that folder, and nothing that the run's memory is too small
/// for; the errors are sentences. `files` outlive what is found.
script::FindProgram module_finder(const os::Files& files, const std::string& main_path,
                                  std::uint64_t memory_bytes);

}  // namespace gsim::engine
