#include "machine/file/process_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/text/read_number.h"
#include "base/toml/toml_writer.h"

namespace gsim::machine {

namespace {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;
using base::TomlWriter;

using std::string_view_literals::operator""sv;

constexpr std::array kProcessKeys{"kind"sv, "on"sv, "off"sv};
constexpr std::array kProcessKinds{"jet"sv, "plasma"sv, "laser"sv,
                                   "spindle"sv};  // in the order of ProcessKind
// The longest dwell of each kind; a jet may take long to pierce.
constexpr std::array kDefaultMaxDwells_s{60.0, 5.0, 10.0, std::numeric_limits<double>::infinity()};

struct CheckKey {
    std::string_view name;
    bool ProcessChecks::*flag;
};
constexpr std::array kCheckKeys{CheckKey{"rapid_with_process_on", &ProcessChecks::rapid_with_process_on},
                                CheckKey{"dwell_with_process_on", &ProcessChecks::dwell_with_process_on},
                                CheckKey{"end_with_process_on", &ProcessChecks::end_with_process_on},
                                CheckKey{"feed_with_process_off", &ProcessChecks::feed_with_process_off}};
constexpr std::string_view kDwellKey = "dwell_s";

constexpr std::string_view kWhitespace = " \t";

bool is_word_letter(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// Removes a letter and its number from the front of a text and returns them.
std::optional<std::pair<char, double>> consume_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(kWhitespace), text.size()));
    if (text.empty() || !is_word_letter(text.front())) return std::nullopt;
    const char letter = static_cast<char>(text.front() & ~0x20);
    double value = 0;
    const auto [end, error] = text::read_number(text.data() + 1, text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return std::pair(letter, value);
}

std::optional<SwitchWord> switch_word(std::string_view text) {
    const auto code = consume_word(text);
    if (!code || code->first != 'M' || code->second != std::floor(code->second) || code->second < 0 ||
        code->second > 999) {
        return std::nullopt;
    }
    SwitchWord word{.code = static_cast<int>(code->second), .words = {}};
    while (text.find_first_not_of(kWhitespace) != std::string_view::npos) {
        const auto next = consume_word(text);
        if (!next || !word.words.insert(*next).second) return std::nullopt;
    }
    return word;
}

void fail_word(TomlSection& section, std::string_view key, const std::string& text) {
    section.fail(key, fmt::format("'{}' contains \"{}\", which is not an M code, such as \"M8\", or an M "
                                  "code with its required words, such as \"M62 P0\"",
                                  key, text));
}

std::vector<SwitchWord> read_words(TomlSection& section, std::string_view key) {
    std::vector<SwitchWord> words;
    const toml::node* node = section.require(key);
    if (node == nullptr) return words;
    const toml::array* array = node->as_array();
    if (array == nullptr || array->empty()) {
        section.fail(key, fmt::format("'{}' must be a list of M codes, such as [\"M8\"]", key));
        return words;
    }
    for (const toml::node& element : *array) {
        const auto* text = element.as_string();
        if (text == nullptr) {
            section.fail(key, fmt::format("'{}' must be a list of M codes, such as [\"M8\"]", key));
            return words;
        }
        const std::optional<SwitchWord> word = switch_word(text->get());
        if (!word) {
            fail_word(section, key, text->get());
            return words;
        }
        words.push_back(*word);
    }
    return words;
}

void check_distinct(TomlSection& section, const Process& process) {
    for (const SwitchWord& word : process.on) {
        if (std::find(process.off.begin(), process.off.end(), word) == process.off.end()) continue;
        section.fail("off", fmt::format("{} is both in 'on' and in 'off'", word.text()));
        return;
    }
}

std::vector<std::string_view> check_keys() {
    std::vector<std::string_view> keys;
    keys.reserve(kCheckKeys.size() + 1);
    for (const CheckKey& key : kCheckKeys) keys.push_back(key.name);
    keys.push_back(kDwellKey);
    return keys;
}

void read_checks(FirstError& error, const toml::table* table, ProcessChecks& checks) {
    if (table == nullptr) return;
    TomlSection section(error, *table, "[checks]", check_keys());
    for (const CheckKey& key : kCheckKeys) checks.*key.flag = section.flag(key.name, true);
    checks.dwell_s = section.number(kDwellKey, checks.dwell_s, NumberRule::positive);
}

std::string word_list(const std::vector<SwitchWord>& words) {
    std::string list;
    for (const SwitchWord& word : words) list += (list.empty() ? "" : ", ") + base::toml_string(word.text());
    return fmt::format("[{}]", list);
}

}  // namespace

std::string_view name(ProcessKind kind) {
    return kProcessKinds[static_cast<std::size_t>(kind)];
}

std::string SwitchWord::text() const {
    std::string text = fmt::format("M{}", code);
    for (const auto& [letter, value] : words) text += fmt::format(" {}{:.10g}", letter, value);
    return text;
}

std::optional<Process> read_process(FirstError& error, TomlSection& file) {
    const toml::table* table = file.table("process");
    const toml::table* checks = file.table("checks");
    if (table == nullptr) {
        if (checks != nullptr)
            file.fail("checks",
                      "[checks] checks the machine's process, but there is no [process] that defines it");
        return std::nullopt;
    }
    TomlSection section(error, *table, "[process]", kProcessKeys);
    section.require("kind");
    Process process;
    process.kind = static_cast<ProcessKind>(section.choice("kind", 0, kProcessKinds));
    process.on = read_words(section, "on");
    process.off = read_words(section, "off");
    check_distinct(section, process);
    process.checks.dwell_s = kDefaultMaxDwells_s[static_cast<std::size_t>(process.kind)];
    read_checks(error, checks, process.checks);
    return process;
}

void print_process(TomlWriter& out, const Process& process) {
    out.section("[process]");
    out.line("kind", base::toml_string(name(process.kind)));
    out.line("on", word_list(process.on));
    out.line("off", word_list(process.off));
    out.section("[checks]");
    for (const CheckKey& key : kCheckKeys) out.line(key.name, process.checks.*key.flag ? "true" : "false");
    out.number(kDwellKey, process.checks.dwell_s);
}

}  // namespace gsim::machine
