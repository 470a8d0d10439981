#pragma once

#include <iosfwd>
#include <string_view>

#include <nlohmann/json.hpp>

namespace gsim::text {

/// Returns the value of a JSON text. Json: nlohmann::json or nlohmann::ordered_json. Throws Json::parse_error
/// if it is not JSON.
template <typename Json>
Json parse_json(std::string_view text);
template <typename Json>
Json parse_json(std::istream& text);

/// Returns the value of a JSON text, a discarded value (Json::is_discarded()) if it is not JSON.
template <typename Json>
Json try_parse_json(std::string_view text);

// The parser is instantiated once, in json.cpp, because it takes a second of each unit that instantiates it.
extern template nlohmann::json parse_json(std::string_view);
extern template nlohmann::ordered_json parse_json(std::string_view);
extern template nlohmann::json parse_json(std::istream&);
extern template nlohmann::ordered_json parse_json(std::istream&);
extern template nlohmann::json try_parse_json(std::string_view);
extern template nlohmann::ordered_json try_parse_json(std::string_view);

}  // namespace gsim::text
