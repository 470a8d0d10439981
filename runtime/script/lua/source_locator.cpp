#include "runtime/script/lua/source_locator.h"

#include <charconv>
#include <cstring>
#include <string_view>

namespace gsim::script {

using simulation::SourceLocation;

std::uint32_t SourceLocator::add(Text text) {
    texts_.push_back(text);
    return static_cast<std::uint32_t>(texts_.size() - 1);
}

std::string SourceLocator::chunk_name(std::uint32_t text) {
    return "=#" + std::to_string(text);
}

SourceLocation SourceLocator::location(std::uint32_t text, std::int64_t chunk_line) const {
    if (text >= texts_.size()) return {};
    const std::int64_t line = chunk_line + texts_[text].line_offset;
    return {texts_[text].file, line > 0 ? static_cast<std::uint32_t>(line) : 0};
}

SourceLocation SourceLocator::current(lua_State* state, int level) const {
    lua_Debug frame;
    for (; lua_getstack(state, level, &frame) != 0; ++level) {
        lua_getinfo(state, "Sl", &frame);
        if (const LinePosition* at = position(state, frame)) return location(at->text, at->line);
        if (frame.source[0] != '=' || frame.source[1] != '#') continue;
        std::uint32_t text = 0;
        std::from_chars(frame.source + 2, frame.source + std::strlen(frame.source), text);
        return location(text, frame.currentline);
    }
    return {};
}

/// Returns the position of a C function that runs lines itself; null for others.
const LinePosition* SourceLocator::position(lua_State* state, const lua_Debug& frame) {
    if (frame.what[0] != 'C' || lua_getlocal(state, &frame, 1) == nullptr) return nullptr;
    const bool is_line_position =
        lua_type(state, -1) == LUA_TUSERDATA && lua_rawlen(state, -1) >= sizeof(LinePosition);
    const auto* const found =
        static_cast<const LinePosition*>(is_line_position ? lua_touserdata(state, -1) : nullptr);
    lua_pop(state, 1);
    return found != nullptr && found->mark == &kMark ? found : nullptr;
}

SourceLocation SourceLocator::strip(std::string& message) const {
    std::uint32_t text = 0;
    std::int64_t line = 0;
    const char* end = message.data() + message.size();
    if (message.empty() || message[0] != '#') return {};
    const auto [after_text, text_error] = std::from_chars(message.data() + 1, end, text);
    if (text_error != std::errc() || after_text == end || *after_text != ':') return {};
    const auto [after_line, line_error] = std::from_chars(after_text + 1, end, line);
    if (line_error != std::errc() || end - after_line < 2 || after_line[0] != ':' || after_line[1] != ' ')
        return {};
    message.erase(0, static_cast<std::size_t>(after_line - message.data()) + 2);
    return location(text, line);
}

}  // namespace gsim::script
