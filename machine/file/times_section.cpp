#include "machine/file/times_section.h"

#include <array>
#include <charconv>

namespace gsim::machine {

namespace {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;
using base::TomlWriter;

struct TimeKey {
    std::string_view name;
    double WordTimes::*time_s;
};
constexpr std::array kTimeKeys{TimeKey{"tool_change_s", &WordTimes::tool_change_s},
                               TimeKey{"tool_table_s", &WordTimes::tool_table_s},
                               TimeKey{"coolant_on_s", &WordTimes::coolant_on_s},
                               TimeKey{"coolant_off_s", &WordTimes::coolant_off_s},
                               TimeKey{"spindle_start_s", &WordTimes::spindle_start_s},
                               TimeKey{"spindle_stop_s", &WordTimes::spindle_stop_s},
                               TimeKey{"process_on_s", &WordTimes::process_on_s},
                               TimeKey{"process_off_s", &WordTimes::process_off_s}};
constexpr std::string_view kBeforeFirstMove = "before_first_move";
constexpr int kLastCode = 999;

// Returns the number of an M code; none if the key is not such a code.
std::optional<int> parse_code_key(std::string_view key) {
    if (key.size() < 2 || key.front() != 'M') return std::nullopt;
    int code = -1;
    const char* end = key.data() + key.size();
    const auto read = std::from_chars(key.data() + 1, end, code);
    if (read.ec != std::errc() || read.ptr != end || code < 0 || code > kLastCode) return std::nullopt;
    return code;
}

std::vector<std::string_view> table_keys(const toml::table& table) {
    std::vector<std::string_view> keys;
    keys.reserve(kTimeKeys.size() + 1 + table.size());
    for (const TimeKey& key : kTimeKeys) keys.push_back(key.name);
    keys.push_back(kBeforeFirstMove);
    for (const auto& [key, value] : table) {
        if (parse_code_key(key.str())) keys.push_back(key.str());
    }
    return keys;
}

template <typename Times>
auto find_time(std::string_view name, Times& times) -> decltype(&times.tool_change_s) {
    for (const TimeKey& key : kTimeKeys) {
        if (key.name == name) return &(times.*key.time_s);
    }
    const auto code = parse_code_key(name);
    const auto found = code ? times.codes_s.find(*code) : times.codes_s.end();
    return found == times.codes_s.end() ? nullptr : &found->second;
}

}  // namespace

double* word_time(std::string_view key, WordTimes& times) {
    return find_time(key, times);
}

const double* word_time(std::string_view key, const WordTimes& times) {
    return find_time(key, times);
}

std::vector<std::string> named_time_keys() {
    std::vector<std::string> keys;
    keys.reserve(kTimeKeys.size());
    for (const TimeKey& key : kTimeKeys) keys.emplace_back(key.name);
    return keys;
}

std::vector<std::string> nonzero_time_keys(const WordTimes& times) {
    std::vector<std::string> keys;
    for (const TimeKey& key : kTimeKeys) {
        if (times.*key.time_s > 0) keys.emplace_back(key.name);
    }
    for (const auto& [code, time_s] : times.codes_s) {
        if (time_s > 0) keys.push_back(fmt::format("M{}", code));
    }
    return keys;
}

WordTimes read_times(FirstError& error, const toml::table* table) {
    WordTimes times;
    if (table == nullptr) return times;
    const std::vector<std::string_view> keys = table_keys(*table);
    TomlSection section(error, *table, "[times]", keys);
    for (const TimeKey& key : kTimeKeys)
        times.*key.time_s = section.number(key.name, 0, NumberRule::not_negative);
    times.before_first_move = section.flag(kBeforeFirstMove, true);
    for (const std::string_view key : keys) {
        if (const auto code = parse_code_key(key))
            times.codes_s[*code] = section.number(key, 0, NumberRule::not_negative);
    }
    return times;
}

void print_times(TomlWriter& out, const WordTimes& times) {
    if (times == WordTimes{}) return;
    out.section("[times]");
    for (const TimeKey& key : kTimeKeys) out.number(key.name, times.*key.time_s);
    out.line(kBeforeFirstMove, times.before_first_move ? "true" : "false");
    for (const auto& [code, time_s] : times.codes_s) out.number(fmt::format("M{}", code), time_s);
}

}  // namespace gsim::machine
