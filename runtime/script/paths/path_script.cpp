#include "runtime/script/paths/path_script.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/text/format.h"
#include "runtime/script/lua/object_names.h"
#include "runtime/script/lua/sandbox.h"
#include "runtime/script/paths/path_values.h"
#include "toolpath/model/validate.h"

namespace gsim::script {

namespace {

using path::PathFile;
using path::PathKey;
using path::TargetDraft;
using path::TargetKey;
using path_values::check;
using path_values::kFrameKeys;
using path_values::kSetUpKeys;
using path_values::raise;
using path_values::read_set_up;
using path_values::text_at;

/// Handle that the constructors return to the script; no script can create one itself.
struct Handle {
    enum class Kind { point, path, repeated } kind = Kind::point;
    std::size_t index = 0;  ///< In Builder::points, or of the path.
    int repeats = 1;
    std::optional<std::size_t> frame = {};  ///< In Builder::frames.
};

constexpr const char* kPathMemoryLabel = "the path of the script";

/// State of what the script has made so far.
struct Builder {
    struct CreatedPoint {
        path::Target point;  ///< No sub-path.
        path::SourceLocation location;
    };
    PathFile file;
    std::vector<CreatedPoint> points;
    std::vector<path::WorkFrame> frames;  // of uses of paths
    std::uint32_t last_line = 1;          ///< Line at which a limit was reached.
};

void push(lua_State* state, const Handle& handle) {
    *static_cast<Handle*>(lua_newuserdatauv(state, sizeof(Handle), 0)) = handle;
}

/// Returns null if the value is something else.
const Handle* handle_at(lua_State* state, int index) {
    if (lua_type(state, index) != LUA_TUSERDATA || lua_rawlen(state, index) != sizeof(Handle)) return nullptr;
    return static_cast<const Handle*>(lua_touserdata(state, index));
}

/// Returns the approximate bytes of a point, with its source location.
std::size_t memory_size(const path::Target& target) {
    constexpr std::size_t kBytesOfLetter = 64;  // a node of a map
    std::size_t bytes = sizeof(path::Target) + sizeof(path::SourceLocation);
    for (const std::string& action : path::target_actions(target))
        bytes += sizeof(std::string) + action.size();
    if (const auto* location = std::get_if<path::MachinePoint>(&target))
        return bytes + location->name.size() + location->alias.size();
    const auto& point = std::get<path::Point>(target);
    bytes += point.name.size();
    if (point.orientation) {
        if (const auto* axes = std::get_if<path::RotaryAxes>(&*point.orientation))
            bytes += axes->size() * kBytesOfLetter;
    }
    return bytes;
}

std::size_t memory_size(const path::WorkFrame& frame) {
    return sizeof(frame) + frame.touches.size() * sizeof(path::Touch);
}

/// Returns the source location of the function `level` levels up; if that is none of Lua, that of its caller.
path::SourceLocation calling_location(lua_State* state, int level = 1) {
    lua_Debug caller{};
    do {
        if (lua_getstack(state, level++, &caller) == 0 || lua_getinfo(state, "l", &caller) == 0) return {};
    } while (caller.currentline < 0);
    return {static_cast<std::uint32_t>(std::max(1, caller.currentline)), 0};
}

constexpr auto kPointKeys = std::span(path::kTargetKeys).first(static_cast<std::size_t>(TargetKey::path));

/// Checks the keys of the table at 1; the alphabetically first unknown key is reported.
void check_point_keys(lua_State* state) {
    std::optional<std::string_view> unknown;
    for (lua_pushnil(state); lua_next(state, 1) != 0; lua_pop(state, 1)) {
        const std::string_view name =
            lua_type(state, -2) == LUA_TSTRING ? text_at(state, -2) : std::string_view("[..]");
        if (std::find(kPointKeys.begin(), kPointKeys.end(), name) != kPointKeys.end()) continue;
        if (!unknown || name < *unknown) unknown = name;
    }
    if (unknown) raise(state, path::unknown_key(*unknown, "a point", kPointKeys));
}

/// point{position_mm = {..}, ..}
int make_point(lua_State* state) {
    auto& builder = bound<Builder>(state);
    luaL_checktype(state, 1, LUA_TTABLE);
    check_point_keys(state);
    TargetDraft draft;
    for (std::size_t i = 0; i < kPointKeys.size(); ++i) {
        lua_pushlstring(state, kPointKeys[i].data(), kPointKeys[i].size());
        if (lua_rawget(state, 1) != LUA_TNIL) {
            const auto key = static_cast<TargetKey>(i);
            draft.mark_present(key);
            path_values::read_value(state, draft, key);
        }
        lua_pop(state, 1);
    }
    Result<path::Target> target = draft.finish();
    if (!target) raise(state, target.error().message);
    LuaState::of(state).add_external_bytes(state, memory_size(*target), kPathMemoryLabel);
    builder.points.push_back({*std::move(target), calling_location(state)});
    push(state, {Handle::Kind::point, builder.points.size() - 1, 1});
    return 1;
}

/// Reads the third argument of repeated(): the frame in which the path is used.
std::optional<std::size_t> read_frame(lua_State* state) {
    if (lua_isnoneornil(state, 3)) return std::nullopt;
    luaL_checktype(state, 3, LUA_TTABLE);
    for (lua_pushnil(state); lua_next(state, 3) != 0; lua_pop(state, 1)) {
        const std::string_view name =
            lua_type(state, -2) == LUA_TSTRING ? text_at(state, -2) : std::string_view("[..]");
        if (std::find(kFrameKeys.begin(), kFrameKeys.end(), name) == kFrameKeys.end())
            raise(state, path::unknown_key(name, "a sub-path", kFrameKeys));
    }
    auto frame = read_set_up(state, 3, kFrameKeys.size()).finish_frame();
    if (!frame) raise(state, frame.error().message);
    auto& frames = bound<Builder>(state).frames;
    LuaState::of(state).add_external_bytes(state, 2 * memory_size(*frame), kPathMemoryLabel);
    frames.push_back(*std::move(frame));
    return frames.size() - 1;
}

/// repeated(n, path, {work_offset = ".."})
int make_repeated(lua_State* state) {
    const Handle* handle = handle_at(state, 2);
    if (handle == nullptr || handle->kind != Handle::Kind::path) {
        raise(state, "repeated(n, p) needs a number and a result of path{..}");
    }
    constexpr lua_Integer kMax = 1'000'000'000;
    const lua_Integer count = luaL_checkinteger(state, 1);
    if (count < 1 || count > kMax) raise(state, "repeated(n, p): n must be an integer from 1 to 1000000000");
    const std::size_t path = handle->index;
    push(state, {Handle::Kind::repeated, path, static_cast<int>(count), read_frame(state)});
    return 1;
}

void check_path_keys(lua_State* state) {
    for (lua_pushnil(state); lua_next(state, 1) != 0; lua_pop(state, 1)) {
        if (lua_type(state, -2) == LUA_TNUMBER) continue;
        const std::string_view name =
            lua_type(state, -2) == LUA_TSTRING ? text_at(state, -2) : std::string_view();
        const bool is_known = name == path::key_name(PathKey::name) ||
                              std::find(kSetUpKeys.begin(), kSetUpKeys.end(), name) != kSetUpKeys.end();
        if (!is_known)
            raise(state,
                  fmt::format("path{{..}} needs 'name', '{}' and, in their order, points and sub-paths",
                              text::joined(kSetUpKeys, "', '")));
    }
}

/// path{name = "..", targets..}
int make_path(lua_State* state) {
    auto& builder = bound<Builder>(state);
    luaL_checktype(state, 1, LUA_TTABLE);
    check_path_keys(state);
    path::Path new_path;
    if (lua_getfield(state, 1, "name") != LUA_TSTRING) raise(state, "a path lacks 'name', a string");
    new_path.name = text_at(state, -1);
    check(state, read_set_up(state, 1, kSetUpKeys.size()).finish(new_path));
    const auto count = static_cast<lua_Integer>(lua_rawlen(state, 1));
    std::vector<path::SourceLocation> locations;
    const path::SourceLocation current = calling_location(state);
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(state, 1, i);
        const Handle* handle = handle_at(state, -1);
        if (handle == nullptr) {
            raise(state,
                  fmt::format("target {} of the path '{}' is neither a point nor a path", i, new_path.name));
        }
        if (handle->kind == Handle::Kind::point) {
            // The vector may have grown to twice the size that it needs.
            LuaState::of(state).add_external_bytes(
                state, 2 * memory_size(builder.points[handle->index].point), kPathMemoryLabel);
            new_path.targets.emplace_back(builder.points[handle->index].point);
            locations.push_back(builder.points[handle->index].location);
        } else {
            LuaState::of(state).add_external_bytes(state, 2 * sizeof(path::Target), kPathMemoryLabel);
            const path::WorkFrame frame = handle->frame ? builder.frames[*handle->frame] : path::WorkFrame();
            LuaState::of(state).add_external_bytes(state, memory_size(frame), kPathMemoryLabel);
            new_path.targets.emplace_back(path::SubPath{handle->index, handle->repeats, frame});
            locations.push_back(current);
        }
        lua_pop(state, 1);
    }
    builder.file.program.paths.push_back(std::move(new_path));
    builder.file.paths.push_back(current);
    builder.file.targets.push_back(std::move(locations));
    push(state, {Handle::Kind::path, builder.file.program.paths.size() - 1, 1});
    return 1;
}

std::string stop_error(const LuaState& lua, const Builder& builder, os::CpuLimit* cpu) {
    std::string reason = "the script exceeds the allowed number of steps";
    if (lua.ended() == LuaState::StopReason::memory) reason = lua.memory().error();
    if (lua.ended() == LuaState::StopReason::cpu)
        reason = fmt::format("the limit of {:.10g} s of processor time is reached (--max-cpu-seconds)",
                             cpu->seconds());
    return fmt::format("{}:{}: {}", builder.file.file_name, builder.last_line, reason);
}

struct PathTask {
    std::string_view text;
    Builder& builder;
    os::CpuLimit* cpu;
};

// Receives the PathTask; returns the result of its script.
int run_path_task(lua_State* state) {
    const PathTask& task = *static_cast<const PathTask*>(lua_touserdata(state, 1));
    const std::string chunk = fmt::format("@{}", task.builder.file.file_name);
    if (luaL_loadbufferx(state, task.text.data(), task.text.size(), chunk.c_str(), "t") != LUA_OK)
        return lua_error(state);
    push_safe_library(state);
    set_function<make_point>(state, "point", &task.builder);
    set_function<make_path>(state, "path", &task.builder);
    set_function<make_repeated>(state, "repeated", &task.builder);
    lua_setupvalue(state, -2, 1);
    LuaState::of(state).set_time_limit(task.cpu);
    lua_call(state, 0, 1);
    return 1;
}

// Leaves the result of the script on the stack. Everything that needs memory runs inside lua_pcall(), because
// an error before it would end the program.
Result<void> run(LuaState& lua, std::string_view text, Builder& builder, os::CpuLimit* cpu) {
    lua_State* state = lua.get();
    lua.on_last_step([&builder](lua_State* at) { builder.last_line = calling_location(at, 0).line; });
    PathTask task{text, builder, cpu};
    lua_pushcfunction(state, trampoline<run_path_task>);
    lua_pushlightuserdata(state, &task);
    if (lua_pcall(state, 1, 1, 0) == LUA_OK) return {};
    if (lua.ended() != LuaState::StopReason::no || LuaState::is_stop(state, -1)) {
        return tl::unexpected(stop_error(lua, builder, cpu));
    }
    std::string message(push_text(state, -1));
    std::replace(message.begin(), message.end(), '\n', ' ');
    return tl::unexpected(message);
}

}  // namespace

Result<PathFile> run_path_script(std::string_view text, std::string file_name, const LuaState::Limits& limits,
                                 os::CpuLimit* cpu) {
    LuaState lua(limits);
    Builder builder;
    builder.file.file_name = std::move(file_name);
    if (auto done = run(lua, text, builder, cpu); !done) return tl::unexpected(done.error());
    const Handle* root = handle_at(lua.get(), -1);
    if (root == nullptr || root->kind != Handle::Kind::path) {
        return Unexpected(fmt::format("{}:1: the script must return the root path, a result of path{{..}}",
                                      builder.file.file_name));
    }
    builder.file.program.root = root->index;
    builder.file.program.name = builder.file.program.paths[root->index].name;
    if (const auto error = path::validate(builder.file.program)) {
        return tl::unexpected(builder.file.with_location(error->where, error->message));
    }
    return std::move(builder.file);
}

}  // namespace gsim::script
