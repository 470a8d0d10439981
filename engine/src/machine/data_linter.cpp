#include "engine/src/machine/data_linter.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "grammar/dialect.h"
#include "lexer/alias.h"

namespace gsim::engine {

using machine::DataRow;
using machine::DataSection;
using machine::MachineDataDocument;
using machine::SectionRules;

namespace {

constexpr std::size_t kMaxWarnings = 100;

class MachineDataLinter {
  public:
    MachineDataLinter(const MachineDataDocument& document, std::string file_name,
                      const std::optional<machine::Machine>& machine)
        : document_(document), file_name_(std::move(file_name)), machine_(machine) {}

    std::vector<std::string> run() {
        for (const DataSection section : machine::kDataSections) {
            const SectionRules& rules = document_.rules().of(section);
            for (const DataRow& row : document_.rows(section)) {
                if (machine_ && (rules.holds_points || rules.holds_zones)) check_ranges(rules, row);
                if (section == DataSection::alias) check_alias(rules, row);
                if (section == DataSection::security) check_switch(rules, row);
            }
        }
        return std::move(warnings_);
    }

  private:
    void warn(const SectionRules& rules, const DataRow& row, std::optional<std::size_t> field,
              std::string_view message) {
        if (warnings_.size() >= kMaxWarnings) return;
        const auto location = document_.location(rules.section, row.id, field);
        warnings_.push_back(
            fmt::format("{}:{}:{}: warning: {}", file_name_, location.line, location.column, message));
    }

    // Checks points and walls: both have fields that begin with the letter of their axis.
    void check_ranges(const SectionRules& rules, const DataRow& row) {
        for (std::size_t i = 0; i < rules.positional(); ++i) {
            const auto index = machine_->find(rules.fields[i].name[0]);
            if (!index || !machine::parse_number<double>(row.values[i])) continue;
            const machine::Axis& axis = machine_->axes[*index];
            const double value = row.number(rules, i);
            if (value >= axis.min && value <= axis.max) continue;
            warn(rules, row, i,
                 fmt::format("{} of {} {} is {} {}, outside the machine's range of {} to {}",
                             rules.fields[i].name, rules.keyword, row.id, value,
                             axis.kind == machine::AxisKind::linear ? "mm" : "deg", axis.min, axis.max));
        }
    }

    void check_alias(const SectionRules& rules, const DataRow& row) {
        lexer::Aliases aliases;
        if (const auto error = aliases.add(row.id, row.values[0])) return warn(rules, row, 0, *error);
        const lexer::Aliases::Word& word = *aliases.find(row.id);
        const grammar::Dialect& dialect = grammar::dialect_ab9();
        if (word.letter == 'G' || word.letter == 'M') {
            const double number = machine::parse_number<double>(word.number).value_or(0);
            if (number < 1000 &&
                dialect.find(word.letter, static_cast<std::int32_t>(std::lround(number * 10))))
                return;
        } else {
            const auto letters = dialect.rules().letters;
            if (std::any_of(letters.begin(), letters.end(), [&](const grammar::Letter& letter) {
                    return letter.address == std::string_view(&word.letter, 1);
                })) {
                return;
            }
        }
        warn(rules, row, 0,
             fmt::format("{} is an alias of '{}', which is not a word of {}", row.id, row.values[0],
                         dialect.title()));
    }

    void check_switch(const SectionRules& rules, const DataRow& row) {
        const auto state = rules.find("STATE"), number = rules.find("SWITCH");
        if (!state || !number || row.values[*state] != "OFF" || !row.values[*number].empty()) return;
        warn(rules, row, state,
             fmt::format("zone {} is off at the start and has no SWITCH: it is never active", row.id));
    }

    const MachineDataDocument& document_;
    std::string file_name_;
    const std::optional<machine::Machine>& machine_;
    std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> lint_machine_data(const MachineDataDocument& document, const std::string& file_name,
                                           const std::optional<machine::Machine>& machine) {
    return MachineDataLinter(document, file_name, machine).run();
}

}  // namespace gsim::engine
