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
#include "engine/diagnostic.h"
#include "engine/request.h"
#include "lexer/source.h"
#include "machine/model/program_table.h"
#include "runtime/script/lua/script.h"

namespace gsim::engine {

/// Receives the errors in a program's text.
using TextDiagnosticHandler = std::function<void(const text::Diagnostic&)>;

/// Options for reading G-code: the language, the code names from the machine data, and the handling of codes
/// that the language does not have.
struct Language {
    const grammar::Dialect* dialect = &grammar::dialect_ab9();
    lexer::Aliases aliases;
    codegen::UnknownCodePolicy unknown = codegen::UnknownCodePolicy::error;
    std::optional<machine::ProgramUnits> units;  ///< Active at the start; none: not specified, which is mm.
    std::uint64_t memory_bytes =
        Limits{}.memory_bytes;    ///< Memory of the run, for its scripts and their texts.
    os::CpuLimit* cpu = nullptr;  ///< Limit of the run that translates, if it has one.
    std::string caution;  ///< A message if the controller's own language is only similar to the dialect.
};

/// A script or program that is open, with all file system resources that are needed for reading it.
struct OpenedScript {
    lexer::Source source;
    bool is_lua = false;
    std::shared_ptr<codegen::LuaSpool> spool;
};

/// Opens part.lua or part.nc.
tl::expected<OpenedScript, Error> open_script(const os::Files& files, const std::string& path,
                                              os::NameSource name_source = os::NameSource::command_line);

/// Opens a text that is not a file, and checks whether it is Lua.
OpenedScript open_text_script(lexer::Source text);

/// Reads it and translates G-code. To be called once. Errors in the program have been reported.
tl::expected<script::Script, Error> read_script(OpenedScript& opened, const Language& language,
                                                const TextDiagnosticHandler& on_diagnostic);

/// Opens and reads it.
tl::expected<script::Script, Error> read_script(const os::Files& files, const std::string& path,
                                                const Language& language,
                                                const TextDiagnosticHandler& on_diagnostic);

/// Returns the folder of a main program ("-": a text that is not a file), which contains all programs that it
/// calls.
std::filesystem::path main_program_folder(const std::string& main_path);

/// Finds the file of a program that is called but not in the script: O0002.nc and the like, or
/// NAME_O0002.ppg, or sub.ngc by its name, in the folder of the main file.
script::FindProgram program_finder(const os::Files& files, const std::string& main_path,
                                   const Language& language, const TextDiagnosticHandler& on_diagnostic);

/// Finds modules of scripts: `shapes` is shapes.lua in the folder of the main program, `lib.shapes`
/// lib/shapes.lua. It finds no files outside of that folder, and none that exceed the run's memory; the
/// errors are messages. `files` must outlive the returned function.
script::FindProgram module_finder(const os::Files& files, const std::string& main_path,
                                  std::uint64_t memory_bytes);

}  // namespace gsim::engine
