#include "engine/src/run/process_words.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/text/format.h"

namespace gsim::engine {

namespace {

using machine::SwitchWord;

const grammar::Code* find_code(const SwitchWord& word, const grammar::Dialect& dialect) {
    return dialect.find('M', word.code * 10);
}

bool is_word_in_dialect(const SwitchWord& word, const grammar::Dialect& dialect) {
    const grammar::Code* code = find_code(word, dialect);
    return code != nullptr && std::all_of(word.words.begin(), word.words.end(), [&](const auto& each) {
               return code->words.find(each.first) != std::string_view::npos;
           });
}

/// Returns the dialects with words for processes: those that are read in blocks.
std::vector<const grammar::Dialect*> block_dialects() {
    std::vector<const grammar::Dialect*> dialects;
    for (const grammar::Dialect* dialect : grammar::dialects()) {
        if (dialect->text().form == lexer::TextForm::blocks) dialects.push_back(dialect);
    }
    return dialects;
}

std::optional<gsim::Error> find_word_error(const SwitchWord& word) {
    const std::vector<const grammar::Dialect*> dialects = block_dialects();
    const auto has_word = [&](const grammar::Dialect* dialect) { return is_word_in_dialect(word, *dialect); };
    if (std::any_of(dialects.begin(), dialects.end(), has_word)) return std::nullopt;
    const auto has_code = [&](const grammar::Dialect* dialect) {
        return find_code(word, *dialect) != nullptr;
    };
    if (std::any_of(dialects.begin(), dialects.end(), has_code))
        return fmt::format("[process]: M{} does not accept the words in {}", word.code, word.text());
    std::vector<std::string> names;
    names.reserve(dialects.size());
    for (const grammar::Dialect* dialect : dialects) names.push_back(dialect->name());
    return fmt::format("[process]: M{} is not a code of {}; user codes are M100 to M199, in ab9 to M999",
                       word.code, text::enumerated(names, "or"));
}

bool has_word_in_dialect(const std::vector<SwitchWord>& words, const grammar::Dialect& dialect) {
    return std::any_of(words.begin(), words.end(),
                       [&](const SwitchWord& word) { return is_word_in_dialect(word, dialect); });
}

std::string texts(const std::vector<SwitchWord>& words) {
    std::vector<std::string> list;
    list.reserve(words.size());
    for (const SwitchWord& word : words) list.push_back(word.text());
    return text::joined(list, ", ");
}

}  // namespace

std::optional<gsim::Error> find_process_error(const machine::Process& process) {
    for (const auto* words : {&process.on, &process.off}) {
        for (const SwitchWord& word : *words) {
            if (auto error = find_word_error(word)) return error;
        }
    }
    return std::nullopt;
}

std::optional<gsim::Error> find_process_error(const machine::Process& process,
                                              const grammar::Dialect& dialect) {
    for (const auto& [words, state] : {std::pair{&process.on, "on"}, {&process.off, "off"}}) {
        if (has_word_in_dialect(*words, dialect)) continue;
        return fmt::format("[process]: the {} is switched {} by {}, which {} does not support",
                           machine::name(process.kind), state, texts(*words), dialect.name());
    }
    return std::nullopt;
}

}  // namespace gsim::engine
