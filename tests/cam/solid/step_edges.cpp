#include "tests/cam/solid/step_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>

namespace gsim::solid {

namespace {

// Entities by their numbers, each without blanks: "VERTEX_POINT('',#23)".
std::map<std::string, std::string> entities_of(std::string text) {
    std::erase_if(text, [](char c) { return c == '\n' || c == '\r' || c == ' '; });
    std::map<std::string, std::string> entities;
    for (std::size_t at = text.find("DATA;") + 5; at < text.size();) {
        const std::size_t end = text.find(';', at);
        if (end == std::string::npos) break;
        const std::size_t equals = text.find('=', at);
        if (text[at] == '#' && equals < end)
            entities[text.substr(at, equals - at)] = text.substr(equals + 1, end - equals - 1);
        at = end + 1;
    }
    return entities;
}

}  // namespace

std::string edge_between(const std::filesystem::path& step, const Position& a, const Position& b) {
    const std::map<std::string, std::string> entities = entities_of(read_file(step));
    const auto is_at = [&](const std::string& vertex, const Position& position) {
        const std::string& text = entities.at(vertex);
        const std::string& point = entities.at(text.substr(text.find('#'), text.rfind(')') - text.find('#')));
        double off = 0;
        const char* from = point.c_str() + point.find(",(") + 2;
        for (const double coordinate : position) {
            char* end = nullptr;
            off = std::max(off, std::abs(std::strtod(from, &end) - coordinate));
            from = end + 1;
        }
        return off < 1e-4;
    };
    const std::regex edge("EDGE_CURVE\\('[^']*',(#\\d+),(#\\d+),.*");
    for (const auto& [number, text] : entities) {
        std::smatch ends;
        if (!std::regex_match(text, ends, edge)) continue;
        if (is_at(ends[1], a) && is_at(ends[2], b)) return number;
        if (is_at(ends[1], b) && is_at(ends[2], a)) return number;
    }
    return {};
}

}  // namespace gsim::solid
