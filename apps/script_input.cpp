#include "apps/script_input.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "codegen/lua_spool.h"
#include "lexer/source.h"

namespace gsim::apps {

namespace fs = std::filesystem;

using script::Script;

namespace {

/// Scripts with more lines than this are run in pieces.
constexpr std::uint32_t kLinesInOnePiece = 50'000;
constexpr std::size_t kLookedAtBytes = 4096;

void print_error(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
}

bool has_extension(const std::string& path, std::string_view extension) {
    return fs::path(path).extension() == extension;
}

/// Tells Lua from G-code by the first line that says something: no block of G-code begins like these.
bool looks_like_lua(const lexer::Source& source) {
    std::uint64_t offset = 0;
    while (offset < source.size() && offset < kLookedAtBytes) {
        const std::string line = source.line_at(offset, kLookedAtBytes);
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin == std::string::npos) {
            offset += line.size() + 1;
            continue;
        }
        if (line.find("require") != std::string::npos) return true;
        for (const std::string_view start :
             {"--", "local ", "function ", "for ", "rrs.", "program(", "print(", "Move"}) {
            if (std::string_view(line).substr(begin).starts_with(start)) return true;
        }
        return false;
    }
    return false;
}

std::string read_all(lexer::Source& source) {
    std::string text(source.size(), '\0');
    std::size_t done = 0;
    while (const std::size_t count = source.read(text.data() + done, text.size() - done)) done += count;
    text.resize(done);
    return text;
}

Script lua_script(lexer::Source& source) {
    std::string text = read_all(source);
    const codegen::ScriptOrigin origin = codegen::script_origin(text);
    const bool rs274ngc =
        std::string_view(text).substr(0, kLookedAtBytes).find("\"gsim.rs274ngc\"") != std::string_view::npos;
    Script script = origin.unedited ? Script::from_text(std::move(text), origin.source_name, -1)
                                    : Script::from_text(std::move(text), source.name(), 0);
    if (rs274ngc) script.dialect = "rs274ngc";
    return script;
}

std::vector<script::ScriptChunk> chunks_of(const codegen::ProgramPart& part) {
    std::vector<script::ScriptChunk> chunks{{part.body_begin, part.body_end, part.first_line}};
    for (const codegen::Cut& cut : part.cuts) {
        if (cut.offset >= part.body_end) break;
        chunks.back().end = cut.offset;
        chunks.push_back({cut.offset, part.body_end, cut.line});
    }
    return chunks;
}

tl::expected<Script, InputError> translated_script(lexer::Source& source, const Language& language) {
    auto spool = std::make_shared<codegen::LuaSpool>();
    codegen::TranslateOptions options;
    options.source_name = source.name();
    options.aliases = language.aliases;
    options.dialect = language.dialect;
    options.unknown = language.unknown;
    const codegen::Translation translation = codegen::translate(source, *spool, options, print_error);
    if (!translation.ok) return tl::unexpected(InputError{true, translation.first_error});
    Script script;
    script.dialect = language.dialect->name();
    script.file_name = source.name();
    script.line_difference = -1;
    script.size = spool->size();
    if (translation.lua_lines > kLinesInOnePiece) {
        for (const codegen::ProgramPart& part : translation.programs)
            script.functions.push_back({part.head, chunks_of(part)});
    }
    script.read = [spool](std::uint64_t begin, std::uint64_t end) { return spool->read(begin, end); };
    return script;
}

tl::expected<Script, InputError> script_of(lexer::Source& source, bool lua, const Language& language) {
    if (lua) return lua_script(source);
    return translated_script(source, language);
}

/// "wheel" of wheel.nc, and of wheel_O0001.ppg.
std::string head_name(const fs::path& main_path) {
    const std::string stem = main_path.stem().string();
    const std::size_t mark = stem.rfind("_O");
    const bool numbered = mark != std::string::npos && mark + 2 < stem.size() &&
                          stem.find_first_not_of("0123456789", mark + 2) == std::string::npos;
    return numbered ? stem.substr(0, mark) : stem;
}

constexpr std::array kExtensions = {".nc", ".lua", ".ngc", ".tap", ".ppg"};
constexpr std::size_t kMaxNumberDigits = 9;

bool is_number(std::string_view name) {
    return !name.empty() && name.size() <= kMaxNumberDigits &&
           name.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Files that may hold the program with this number or, in RS274/NGC, the subroutine with this name.
std::vector<std::string> candidate_names(const fs::path& main_path, const std::string& wanted) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& base) {
        for (const char* extension : kExtensions) names.push_back(base + extension);
    };
    if (wanted.find_first_of("/\\") != std::string::npos) return names;  // beside the program, not elsewhere
    if (std::any_of(kExtensions.begin(), kExtensions.end(),
                    [&](const char* extension) { return has_extension(wanted, extension); })) {
        names.push_back(wanted);
    }
    if (is_number(wanted)) {
        const long number = std::stol(wanted);
        add(fmt::format("O{:04}", number));
        add(fmt::format("O{}", number));
        add(fmt::format("O{:05}", number));
        add(fmt::format("o{:04}", number));
        add(fmt::format("o{}", number));
        names.push_back(fmt::format("{}_O{:04}.ppg", head_name(main_path), number));
        names.push_back(fmt::format("{}_O{:04}.nc", head_name(main_path), number));
    }
    add(wanted);
    return names;
}

}  // namespace

tl::expected<Script, InputError> read_script(const std::string& path, const Language& language) {
    tl::expected<lexer::Source, std::string> source =
        path == "-" ? lexer::Source::spool(stdin, "stdin") : lexer::Source::open(path);
    if (!source) return tl::unexpected(InputError{false, source.error()});
    const bool lua = has_extension(path, ".lua") || (path == "-" && looks_like_lua(*source));
    return script_of(*source, lua, language);
}

script::FindProgram program_finder(const std::string& main_path, const Language& language) {
    const fs::path main = main_path == "-" ? fs::path("stdin") : fs::path(main_path);
    return [main, language](const std::string& wanted) -> tl::expected<std::optional<Script>, std::string> {
        for (const std::string& name : candidate_names(main, wanted)) {
            const fs::path path = main.parent_path() / name;
            std::error_code ignored;
            if (!fs::is_regular_file(path, ignored) || fs::equivalent(path, main, ignored)) continue;
            tl::expected<lexer::Source, std::string> source = lexer::Source::open(path.string());
            if (!source) return tl::unexpected(source.error());
            tl::expected<Script, InputError> script =
                script_of(*source, has_extension(name, ".lua"), language);
            if (!script)
                return tl::unexpected(
                    fmt::format("the called program cannot be translated: {}", script.error().message));
            return std::optional<Script>(std::move(*script));
        }
        return std::optional<Script>();
    };
}

}  // namespace gsim::apps
