#include "grammar/dialect.h"

#include <utility>

namespace gsim::grammar {

namespace {

constexpr std::size_t kIndexedCodes = 10000;  // codes_x10 up to 999.9

std::size_t slot(char letter, std::int32_t code_x10) {
    return (letter == 'M' ? kIndexedCodes : 0) + static_cast<std::size_t>(code_x10);
}

}  // namespace

Dialect::Dialect(DialectRules rules) : rules_(std::move(rules)), index_(2 * kIndexedCodes, 0) {
    rules_.text.expression_names = rules_.expression_names;
    for (std::size_t row = 0; row < rules_.codes.size(); ++row) {
        index_[slot(rules_.codes[row].letter, rules_.codes[row].code_x10)] =
            static_cast<std::uint16_t>(row + 1);
    }
    for (std::size_t phase = 0; phase < kPhaseCount; ++phase)
        ranks_[phase] = static_cast<int>(kPhaseCount + phase);
    for (std::size_t position = 0; position < rules_.blocks.order.size(); ++position)
        ranks_[static_cast<std::size_t>(rules_.blocks.order[position])] = static_cast<int>(position);
}

namespace {

DialectRules changed_rules(const Dialect& base, const std::function<void(DialectRules&)>& change) {
    DialectRules rules = base.rules();
    change(rules);
    return rules;
}

}  // namespace

Dialect::Dialect(const Dialect& base, const std::function<void(DialectRules&)>& change)
    : Dialect(changed_rules(base, change)) {}

const Code* Dialect::find(char letter, std::int32_t code_x10) const {
    if (code_x10 < 0 || code_x10 >= static_cast<std::int32_t>(kIndexedCodes)) return nullptr;
    const std::uint16_t row = index_[slot(letter, code_x10)];
    return row == 0 ? nullptr : &rules_.codes[row - 1U];
}

std::span<const Dialect* const> dialects() {
    static const std::array all{&dialect_ab9(), &dialect_rs274ngc(), &dialect_klipper()};
    return all;
}

std::vector<std::string_view> dialect_names() {
    std::vector<std::string_view> names;
    for (const Dialect* dialect : dialects()) names.push_back(dialect->rules().name);
    return names;
}

const Dialect* find_dialect(std::string_view name) {
    for (const Dialect* dialect : dialects()) {
        if (dialect->name() == name) return dialect;
    }
    return nullptr;
}

}  // namespace gsim::grammar
