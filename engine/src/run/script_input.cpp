#include "engine/src/run/script_input.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/src/conversions.h"
#include "engine/src/run/translate_program.h"

namespace gsim::engine {

namespace fs = std::filesystem;

using script::Script;

namespace {

constexpr std::size_t kInspectedBytes = 4096;
constexpr double kMegabyte = 1U << 20U;

bool has_extension(const std::string& path, std::string_view extension) {
    return fs::path(path).extension() == extension;
}

/// Distinguishes Lua from G-code by the first significant line: no block of G-code begins like these.
bool seems_to_be_lua(const lexer::Source& source) {
    std::uint64_t offset = 0;
    while (offset < source.size() && offset < kInspectedBytes) {
        const std::string line = source.line_at(offset, kInspectedBytes);
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

/// The text is held in memory, and a second time while it is compiled.
Result<Script> read_lua_script(lexer::Source& source, std::uint64_t memory_bytes) {
    if (source.size() > memory_bytes / 2) {
        return Unexpected(
            fmt::format("the text of the script {} has {:.1f} MB, which is more than half of the {} MB that "
                        "the run may use (--memory): it is stored twice while it is compiled",
                        source.name(), static_cast<double>(source.size()) / kMegabyte, memory_bytes >> 20U));
    }
    std::string text = read_all(source);
    if (auto error_message = source.error_message()) return tl::unexpected(*std::move(error_message));
    const codegen::ScriptOrigin origin = codegen::script_origin(text);
    const auto requires_name = [head = text.substr(0, kInspectedBytes)](std::string_view name) {
        return head.find(fmt::format("\"{}\"", name)) != std::string::npos;
    };
    // The first line names the source, but anybody may have written it, so the name of an opened file is
    // added.
    const bool is_file = source.name() != lexer::Source::kStandardInput;
    const std::string from =
        is_file ? fmt::format("{}: {}", source.name(), origin.source_name) : origin.source_name;
    Script script = origin.unedited ? Script::from_text(std::move(text), from, -1)
                                    : Script::from_text(std::move(text), source.name(), 0);
    for (const grammar::Dialect* dialect : grammar::dialects()) {
        const std::string_view module = dialect->rules().lua_module;
        const bool inch = !dialect->rules().always_mm && requires_name(fmt::format("{}.inch", module));
        if (inch || requires_name(module)) script.dialect = dialect->name();
        script.inch |= inch;
    }
    return script;
}

std::vector<script::ScriptChunk> split_into_chunks(const codegen::ProgramPart& part) {
    std::vector<script::ScriptChunk> chunks{{part.body_begin, part.body_end, part.first_line}};
    for (const codegen::Cut& cut : part.cuts) {
        if (cut.offset >= part.body_end) break;
        chunks.back().end = cut.offset;
        chunks.push_back({cut.offset, part.body_end, cut.line});
    }
    return chunks;
}

tl::expected<Script, Error> translate_script(lexer::Source& source, std::shared_ptr<codegen::LuaSpool> spool,
                                             const Language& language,
                                             const TextDiagnosticHandler& on_diagnostic) {
    const codegen::Translation translation = translate_source(source, *spool, language, {}, on_diagnostic);
    if (auto error_message = source.error_message())
        return tl::unexpected(make_error(text::DiagnosticKind::file, *std::move(error_message)));
    if (!translation.ok) {
        const text::Diagnostic& first = *translation.first_error;
        Error error = make_error(first.kind, fmt::format("{}: {}", text::location_text(first), first.text));
        error.in_program = true;
        error.first_error = to_diagnostic(first);
        return tl::unexpected(std::move(error));
    }
    Script script;
    script.dialect = language.dialect->name();
    script.file_name = source.name();
    script.line_offset = -1;
    script.size = spool->size();
    script.retained_bytes = spool->retained_bytes();
    for (const codegen::ProgramPart& part : translation.programs)
        script.functions.push_back({part.head, split_into_chunks(part)});
    script.read = [spool = std::move(spool)](std::uint64_t begin, std::uint64_t end) {
        return spool->read(begin, end);
    };
    return script;
}

/// Returns "wheel" of wheel.nc, and of wheel_O0001.ppg.
std::string program_stem(const fs::path& main_path) {
    const std::string stem = main_path.stem().string();
    const std::size_t mark = stem.rfind("_O");
    const bool numbered = mark != std::string::npos && mark + 2 < stem.size() &&
                          stem.find_first_not_of("0123456789", mark + 2) == std::string::npos;
    return numbered ? stem.substr(0, mark) : stem;
}

constexpr std::array kExtensions = {".nc", ".lua", ".ngc", ".tap", ".ppg", ".NC", ".NGC", ".TAP"};
constexpr std::size_t kMaxNumberDigits = 9;

bool is_number(std::string_view name) {
    return !name.empty() && name.size() <= kMaxNumberDigits &&
           name.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Returns why a file there must not be read: links lead out of the folder. Nothing if it may be read.
std::optional<gsim::Error> find_link_error(const os::Files& files, const fs::path& folder,
                                           const fs::path& name) {
    if (files.is_within(folder, name)) return std::nullopt;
    return fmt::format("{} is a link to a file outside the folder of the script", name.string());
}

/// Returns files that may contain the program with this number or, in RS274/NGC, the subroutine with this
/// name.
std::vector<std::string> candidate_names(const fs::path& main_path, const std::string& requested) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& base) {
        for (const char* extension : kExtensions) names.push_back(base + extension);
        names.push_back(base);
    };
    if (requested.find_first_of("/\\") != std::string::npos)
        return names;  // next to the program, not elsewhere
    if (std::any_of(kExtensions.begin(), kExtensions.end(),
                    [&](const char* extension) { return has_extension(requested, extension); })) {
        names.push_back(requested);
    }
    if (is_number(requested)) {
        const long number = std::stol(requested);
        add(fmt::format("O{:04}", number));
        add(fmt::format("O{}", number));
        add(fmt::format("O{:05}", number));
        add(fmt::format("o{:04}", number));
        add(fmt::format("o{}", number));
        names.push_back(fmt::format("{}_O{:04}.ppg", program_stem(main_path), number));
        names.push_back(fmt::format("{}_O{:04}.nc", program_stem(main_path), number));
    }
    add(requested);
    return names;
}

OpenedScript make_opened_script(lexer::Source source, bool lua) {
    auto spool = std::make_shared<codegen::LuaSpool>();
    if (!lua) spool->reserve_file();
    return {std::move(source), lua, std::move(spool)};
}

}  // namespace

fs::path main_program_folder(const std::string& main_path) {
    const fs::path parent = main_path == "-" ? fs::path() : fs::path(main_path).parent_path();
    return parent.empty() ? fs::path(".") : parent;
}

tl::expected<OpenedScript, Error> open_script(const os::Files& files, const std::string& path,
                                              os::NameSource name_source) {
    Result<lexer::Source> source = lexer::Source::open(files, path, name_source);
    if (!source) return tl::unexpected(make_error(text::DiagnosticKind::file, source.error(), path));
    return make_opened_script(*std::move(source), has_extension(path, ".lua"));
}

OpenedScript open_text_script(lexer::Source text) {
    const bool lua = has_extension(text.name(), ".lua") || seems_to_be_lua(text);
    return make_opened_script(std::move(text), lua);
}

tl::expected<Script, Error> read_script(OpenedScript& opened, const Language& language,
                                        const TextDiagnosticHandler& on_diagnostic) {
    if (!opened.is_lua)
        return translate_script(opened.source, std::move(opened.spool), language, on_diagnostic);
    return read_lua_script(opened.source, language.memory_bytes).map_error([](const gsim::Error& error) {
        return make_error(text::DiagnosticKind::file, error);
    });
}

tl::expected<Script, Error> read_script(const os::Files& files, const std::string& path,
                                        const Language& language,
                                        const TextDiagnosticHandler& on_diagnostic) {
    return open_script(files, path).and_then([&](OpenedScript opened) {
        return read_script(opened, language, on_diagnostic);
    });
}

script::FindProgram program_finder(const os::Files& files, const std::string& main_path,
                                   const Language& language, const TextDiagnosticHandler& on_diagnostic) {
    const fs::path main = main_path == "-" ? fs::path(lexer::Source::kStandardInput) : fs::path(main_path);
    return [&files, main, language,
            on_diagnostic](const std::string& requested) -> Result<std::optional<Script>> {
        for (const std::string& name : candidate_names(main, requested)) {
            const fs::path path = main.parent_path() / name;
            if (!files.has(path) || files.is_same_file(path, main)) continue;
            if (auto link_error = find_link_error(files, main_program_folder(main.string()), name))
                return tl::unexpected(*std::move(link_error));
            Result<lexer::Source> source = lexer::Source::open(files, path.string());
            if (!source) return tl::unexpected(source.error());
            OpenedScript opened{*std::move(source), has_extension(name, ".lua"),
                                std::make_shared<codegen::LuaSpool>()};
            tl::expected<Script, Error> script = read_script(opened, language, on_diagnostic);
            if (!script)
                return Unexpected(
                    fmt::format("the called program cannot be translated: {}", script.error().message));
            return std::optional<Script>(std::move(*script));
        }
        return std::optional<Script>();
    };
}

namespace {

/// Returns "lib/shapes.lua" for "lib.shapes"; nothing if it is no name of a module.
std::optional<fs::path> module_file(const std::string& name) {
    const auto is_name_char = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    };
    fs::path path;
    std::string part;
    for (const char c : name + '.') {
        if (c != '.') {
            if (!is_name_char(c)) return std::nullopt;
            part += c;
            continue;
        }
        if (part.empty()) return std::nullopt;
        path /= std::exchange(part, {});
    }
    return path += ".lua";
}

}  // namespace

script::FindProgram module_finder(const os::Files& files, const std::string& main_path,
                                  std::uint64_t memory_bytes) {
    return [&files, folder = main_program_folder(main_path),
            memory_bytes](const std::string& name) -> Result<std::optional<Script>> {
        const std::optional<fs::path> file = module_file(name);
        if (!file) {
            return Unexpected(
                "the name of a module may have letters, digits, _ and -, and dots for subfolders of the "
                "script's folder: \"lib.shapes\" is lib/shapes.lua there");
        }
        const fs::path path = folder / *file;
        if (!files.has(path))
            return Unexpected(
                fmt::format("the file {} does not exist in the folder of the script", file->string()));
        if (auto link_error = find_link_error(files, folder, *file))
            return tl::unexpected(*std::move(link_error));
        Result<lexer::Source> source = lexer::Source::open(files, path.lexically_normal().string());
        if (!source) return tl::unexpected(source.error());
        return read_lua_script(*source, memory_bytes).map([](Script script) {
            return std::optional<Script>(std::move(script));
        });
    };
}

}  // namespace gsim::engine
