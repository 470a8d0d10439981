#include "base/text/json.h"

#include <istream>

namespace gsim::text {

template <typename Json>
Json parse_json(std::string_view text) {
    return Json::parse(text);
}

template <typename Json>
Json parse_json(std::istream& text) {
    return Json::parse(text);
}

template <typename Json>
Json try_parse_json(std::string_view text) {
    return Json::parse(text, nullptr, false);
}

template nlohmann::json parse_json(std::string_view);
template nlohmann::ordered_json parse_json(std::string_view);
template nlohmann::json parse_json(std::istream&);
template nlohmann::ordered_json parse_json(std::istream&);
template nlohmann::json try_parse_json(std::string_view);
template nlohmann::ordered_json try_parse_json(std::string_view);

}  // namespace gsim::text
