#include "apps/path_input.h"

#include <cstdio>
#include <filesystem>

#include "runtime/machine/text_file.h"
#include "runtime/path/json_reader.h"
#include "runtime/script/path_script.h"

namespace gsim::apps {

tl::expected<path::PathFile, std::string> read_path(const std::string& name,
                                                    const script::LuaState::Limits& limits,
                                                    os::CpuLimit* cpu) {
    if (name == "-") {
        return path::read_json(
            [](char* buffer, std::size_t size) { return std::fread(buffer, 1, size, stdin); }, "stdin");
    }
    if (std::filesystem::path(name).extension() != ".lua")
        return path::load_json(name, os::NamedBy::command_line);
    const auto text = machine::read_text_file(name, os::NamedBy::command_line);
    if (!text) return tl::unexpected(text.error());
    return script::run_path_script(*text, name, limits, cpu);
}

}  // namespace gsim::apps
