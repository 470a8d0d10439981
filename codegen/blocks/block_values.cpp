#include "codegen/blocks/block_values.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "base/text/format.h"
#include "codegen/lua/expression_writer.h"

namespace gsim::codegen {

using grammar::Block;
using lexer::Word;

BlockValues::BlockValues(const Block& block, const BlockPlan& plan) {
    if (block.assignments.empty() && plan.calls().size() < 2) return;
    const std::vector<Word>& words = block.text->words;
    for (std::uint32_t i = 0; i < words.size(); ++i) {
        if (words[i].expression >= 0 && grammar::reads_parameter(block, words[i].expression))
            words_.push_back(i);
    }
}

bool BlockValues::has(std::uint32_t word) const {
    return std::binary_search(words_.begin(), words_.end(), word);
}

void BlockValues::write(const Block& block, std::string& out) const {
    std::string_view separator = "local ";
    for (const std::uint32_t word : words_) {
        out += separator;
        write_name(word, out);
        separator = ", ";
    }
    separator = " = ";
    for (const std::uint32_t word : words_) {
        out += separator;
        write_number(block, block.text->words[word].expression, out);
        separator = ", ";
    }
    out += ' ';
}

void BlockValues::write_name(std::uint32_t word, std::string& out) const {
    const auto word_position = std::lower_bound(words_.begin(), words_.end(), word);
    text::append_format(out, "w{}", word_position - words_.begin() + 1);
}

Settings::Settings(const Block& block) : block_(block) {
    bool computed = false;
    for (const grammar::Assignment& assignment : block.assignments) {
        std::string target;
        write_number(block, assignment.target, target);
        std::erase_if(settings_, [&](const Setting& setting) { return setting.target == target; });
        settings_.push_back({target, assignment.value});
        computed |= block.node(assignment.target).kind == grammar::NodeKind::indirect;
    }
    // Two of them may be the same parameter: the later one is valid, and Lua assigns from right to left.
    if (computed) std::reverse(settings_.begin(), settings_.end());
}

void Settings::write(std::string& out) const {
    std::string_view separator;
    for (const Setting& setting : settings_) {
        out += separator;
        out += setting.target;
        separator = ", ";
    }
    separator = " = ";
    for (const Setting& setting : settings_) {
        out += separator;
        write_number(block_, setting.value, out);
        separator = ", ";
    }
    out += ' ';
}

void write_assignments(const Block& block, std::string& out) {
    for (const grammar::Assignment& assignment : block.assignments) {
        write_number(block, assignment.target, out);
        out += " = ";
        write_number(block, assignment.value, out);
        out += ' ';
    }
}

}  // namespace gsim::codegen
