#include <cmath>

#include <fmt/format.h>

#include "codegen/post/post_file.h"
#include "codegen/translate.h"
#include "engine/src/paths/path_frames.h"
#include "engine/src/paths/path_points.h"
#include "engine/src/paths/path_program.h"
#include "machine/file/machine_file.h"
#include "runtime/script/paths/path_script.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"
#include "toolpath/json/json_reader.h"
#include "toolpath/json/json_writer.h"

namespace gsim::fuzz {
namespace {

/// Max output of a post, as a text with all files one after the other.
constexpr std::size_t kMostBytes = std::size_t{256} << 10U;
/// Max repeats; with more, any path takes long to write.
constexpr int kMostRepeats = 20;
constexpr double kFarthest_mm = 1e4;
constexpr double kMostTurn_deg = 7200;
constexpr script::LuaState::Limits kScriptLimits{.memory_bytes = std::size_t{48} << 20U, .steps = 50'000};

/// A point, an arc, a sub-path that is repeated, actions and a dwell.
constexpr std::string_view kPath = R"({"name": "part", "root": "part", "paths": [
{"name": "part", "targets": [
{"motion": "rapid", "position_mm": [10, 10, 20], "tool_axis": [0, 0, 1], "actions": ["spindle_cw", "waterjet_on"]},
{"path": "slot", "repeats": 3},
{"motion": "linear", "position_mm": [0, 0, 0], "dwell_s": 0.5, "actions": ["waterjet_off"]}]},
{"name": "slot", "targets": [
{"motion": "linear", "position_mm": [20, 10, 5], "feed_mm_min": 500},
{"motion": "circular", "position_mm": [30, 20, 5], "via_mm": [27, 13, 5]}]}
]})";

machine::Machine path_machine() {
    return machine::read_machine(machine::built_in_machine_toml(), "built-in machine").value();
}

bool is_small(const path::Program& program) {
    for (const path::Path& path : program.paths) {
        for (const path::Target& target : path.targets) {
            if (const auto* sub = std::get_if<path::SubPath>(&target)) {
                if (sub->repeats > kMostRepeats) return false;
                continue;
            }
            const auto* point = std::get_if<path::Point>(&target);
            if (point == nullptr) continue;
            for (const double at_mm : point->position_mm) {
                if (std::abs(at_mm) > kFarthest_mm) return false;
            }
            const auto* arc = std::get_if<path::CenterArc>(&point->arc);
            if (arc != nullptr && arc->turn_deg > kMostTurn_deg) return false;
        }
    }
    return true;
}

/// Returns the output of a post for a path, in one program or several; the error is a message.
Result<std::string> written(path::PathFile file, const machine::Machine& machine, const codegen::Post& post) {
    machine::MachineData data;
    data.fixed = {{1, {{'X', 10}, {'Y', 20}, {'Z', 30}}},
                  {2, {{'X', 1}, {'Y', 2}, {'Z', 3}, {'B', 40}, {'C', 5}}}};
    data.fixed_names = {{2, "CLAMP1"}};
    data.references = data.fixed;
    data.reference_names = {{1, "DOCK"}};
    if (const auto framed = engine::complete_frames(file, {}, post); !framed)
        return tl::unexpected(framed.error());
    if (const auto placed = engine::complete_points(file, {machine, &data, "data"}, post); !placed)
        return tl::unexpected(placed.error());
    engine::PathProgramOptions options;
    options.name = "fuzz";
    options.continue_on_unknown = true;
    const auto program = engine::PathProgram::plan(file, machine, post, options);
    if (!program) return tl::unexpected(program.error());
    std::string text;
    program->write([&text](const std::string& /*file*/) {
        return [&text](std::string_view part) {
            if (text.size() < kMostBytes) text += part;
        };
    });
    return text;
}

/// The post's own dialect reads its output.
std::optional<std::string> fault_of_program(const path::PathFile& file, const machine::Machine& machine,
                                            std::string_view post_name) {
    const auto post = codegen::find_post(std::string(post_name));
    if (!post) return post.error().message;
    const auto text = written(file, machine, *post);
    if (!text) return fault_of_sentence(text.error().message);
    if (text->size() >= kMostBytes) return std::nullopt;
    codegen::TranslateOptions options;
    options.dialect = grammar::find_dialect(post->dialect);
    const auto read = codegen::translate_text(*text, options);
    if (read.ok) return std::nullopt;
    return fmt::format("what the post {} writes has errors: {}\n{}", post_name, read.diagnostics, *text);
}

Outcome check_path(const path::PathFile& file) {
    const std::string json = path::to_json(file.program);
    const auto repeated = path::read_json(json, "again.json");
    if (!repeated)
        return broken(fmt::format("what is written is refused: {}\n{}", repeated.error().message, json));
    if (repeated->program != file.program)
        return broken(fmt::format("what is written is another path:\n{}", json));
    if (!is_small(file.program)) return accepted();
    const machine::Machine machine = path_machine();
    for (const std::string_view post : {"rs274ngc", "fanuc"}) {
        if (auto violation = fault_of_program(file, machine, post)) return broken(*std::move(violation));
    }
    return accepted();
}

}  // namespace

Outcome check_path_json(std::string_view json) {
    const std::string file = name_beside(".json");
    const auto path = path::read_json(json, file);
    return path ? check_path(*path) : refused_with(path.error().message, file);
}

Outcome check_path_script(std::string_view lua) {
    const std::string file = name_beside(".lua");
    const auto path = script::run_path_script(lua, file, kScriptLimits);
    // A text that a script raises by error() is the script's own message.
    if (!path) return {.accepted = false, .broken = fault_of_sentence(path.error().message)};
    return check_path(*path);
}

Outcome check_post(std::string_view toml) {
    const std::string file = name_beside(".toml");
    const auto post = codegen::read_post(toml, file);
    if (!post) return refused_with(post.error().message, file);
    const path::PathFile path = path::read_json(kPath, "path.json").value();
    const machine::Machine machine = path_machine();
    const auto first = written(path, machine, *post);
    const auto second = written(path, machine, *post);
    if (first != second) return broken("a post writes a path in two ways");
    if (first) return accepted();
    return {.accepted = true, .broken = fault_of_sentence(first.error().message)};
}

}  // namespace gsim::fuzz
