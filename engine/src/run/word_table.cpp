#include "engine/src/run/word_table.h"

#include <algorithm>
#include <array>

namespace gsim::engine {

namespace {

using grammar::Code;
using grammar::Compensation;

constexpr char kMacroArguments = '*';
constexpr char kSpindle = '$';

std::string compensation_text(Compensation compensation) {
    switch (compensation) {
        case Compensation::allowed: return "";
        case Compensation::rejected: return "refused";
        case Compensation::refused_next_to_path: return "refused beside the path";
        case Compensation::lead_out_and_in: return "led out";
        case Compensation::ends_move: return "ends the move";
    }
    return "";
}

/// Plain motions are C++, and arguments of macros are checked when they are assigned to variables.
bool checks_words_itself(const Code& code) {
    constexpr std::array kPlain{0, 10, 20, 30};
    const bool is_plain =
        code.letter == 'G' && std::find(kPlain.begin(), kPlain.end(), code.code_x10) != kPlain.end();
    return is_plain || code.words.find(kMacroArguments) != std::string_view::npos;
}

std::string word_keys(const Code& code) {
    std::string keys;
    if (checks_words_itself(code)) return keys;
    const auto add = [&](const std::string& key) { keys += (keys.empty() ? "" : " ") + key; };
    if (code.axes != grammar::AxisUse::none) add("axes");
    for (const char letter : code.words) {
        if (letter == kSpindle) add("spindle");
        if (letter >= 'A' && letter <= 'Z') add({static_cast<char>(letter | 0x20)});
    }
    return keys;
}

}  // namespace

std::vector<script::CodeRow> word_table(const grammar::Dialect& dialect) {
    std::vector<script::CodeRow> rows;
    for (const Code& code : dialect.codes()) {
        if (code.group == grammar::Group::user) continue;
        const bool is_unsupported = code.support == grammar::Support::planned;
        const bool is_modal = code.group != grammar::Group::none;
        rows.push_back({.name = lua_name(code),
                        .group = is_modal ? std::string(name(code.group)) : "",
                        .keys = word_keys(code),
                        .compensation = compensation_text(code.compensation),
                        .unsupported = std::string(is_unsupported ? code.meaning : "")});
    }
    return rows;
}

}  // namespace gsim::engine
