#include "runtime/script/place_finder.h"

#include <charconv>
#include <cstring>
#include <string_view>

namespace gsim::script {

using simulation::Place;

std::string PlaceFinder::add(Text text) {
    texts_.push_back(text);
    return "=#" + std::to_string(texts_.size() - 1);
}

Place PlaceFinder::place(std::uint32_t text, std::int64_t chunk_line) const {
    if (text >= texts_.size()) return {};
    const std::int64_t line = chunk_line + texts_[text].line_difference;
    return {texts_[text].file, line > 0 ? static_cast<std::uint32_t>(line) : 0};
}

Place PlaceFinder::current(lua_State* state, int level) const {
    lua_Debug frame;
    for (; lua_getstack(state, level, &frame) != 0; ++level) {
        lua_getinfo(state, "Sl", &frame);
        if (frame.source[0] != '=' || frame.source[1] != '#') continue;
        std::uint32_t text = 0;
        std::from_chars(frame.source + 2, frame.source + std::strlen(frame.source), text);
        return place(text, frame.currentline);
    }
    return {};
}

Place PlaceFinder::strip(std::string& message) const {
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
    return place(text, line);
}

}  // namespace gsim::script
