
#include "base/text/json.h"
#include "engine/language.h"
#include "grammar/dialect.h"

namespace gsim::engine {

namespace {

using Json = nlohmann::ordered_json;

Json codes_json(const grammar::Dialect& dialect) {
    Json codes = Json::array();
    for (const grammar::Code& code : dialect.codes()) {
        if (code.group == grammar::Group::user) continue;
        const bool modal = code.group != grammar::Group::none && code.group != grammar::Group::non_modal;
        codes.push_back({{"code", code_name(code)},
                         {"lua", lua_name(code)},
                         {"meaning", code.meaning},
                         {"group", modal ? Json(name(code.group)) : Json(nullptr)},
                         {"words", code.words},
                         {"axes", code.axes != grammar::AxisUse::none},
                         {"supported", code.support != grammar::Support::planned}});
    }
    return codes;
}

Json letters_json(const grammar::Dialect& dialect) {
    Json letters = Json::object();
    for (const grammar::Letter& letter : dialect.rules().letters)
        letters[std::string(letter.address)] = letter.meaning;
    return letters;
}

Json dialect_json(const grammar::Dialect& dialect) {
    return {{"name", dialect.name()},
            {"title", dialect.title()},
            {"initial", dialect.rules().initial},
            {"letters", letters_json(dialect)},
            {"codes", codes_json(dialect)}};
}

}  // namespace

std::string languages_json() {
    Json list = Json::array();
    for (const grammar::Dialect* dialect : grammar::dialects()) list.push_back(dialect_json(*dialect));
    return list.dump();
}

}  // namespace gsim::engine
