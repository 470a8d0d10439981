// Update of a document with data that a run has changed.
#include <cmath>
#include <map>

#include "base/units.h"
#include "machine/data/machine_data_document.h"
#include "machine/data/machine_data_values.h"

namespace gsim::machine {

namespace {

using RowsByKey = std::map<std::string, DataRow>;

RowsByKey rows_by_key(const SectionRules& rules, std::vector<DataRow> rows) {
    RowsByKey keyed_rows;
    for (DataRow& row : rows) {
        std::string key = data_key(rules.section, row.id);
        keyed_rows.emplace(std::move(key), std::move(row));
    }
    return keyed_rows;
}

// Returns the shortest text of a number of inches that reads as exactly so many mm; the nearest if none does.
std::string inch_text(double value_mm) {
    const double inches = value_mm / kMmPerInch;
    std::string shortest;
    for (const double candidate :
         {inches, std::nextafter(inches, -HUGE_VAL), std::nextafter(inches, HUGE_VAL)}) {
        std::string text = number_text(candidate);
        const bool exact = candidate * kMmPerInch == value_mm;
        if (exact && (shortest.empty() || text.size() < shortest.size())) shortest = std::move(text);
    }
    return shortest.empty() ? number_text(inches) : shortest;
}

// A missing number is 0, except in home positions: there it means that the position does not exist.
bool is_same_value(const SectionRules& rules, const DataField& field, const std::string& a,
                   const std::string& b) {
    if (a == b) return true;
    if (field.quantity == Quantity::text || field.may_be_unlimited || rules.section == DataSection::home)
        return false;
    return (a.empty() && b == "0") || (b.empty() && a == "0");
}

}  // namespace

Result<void> MachineDataDocument::update_section(const SectionRules& rules, const MachineData& data) {
    const RowsByKey before = rows_by_key(rules, section_rows(data_, rules));
    const RowsByKey after = rows_by_key(rules, section_rows(data, rules));
    for (const auto& [key, row] : before) {
        if (!after.contains(key)) erase_line(find_line(rules.section, row.id).value());
    }
    for (const DataRow& row : section_rows(data, rules)) {
        const auto known = before.find(data_key(rules.section, row.id));
        Result<void> changed =
            known == before.end() ? add(rules, row, {}) : update_entry(rules, known->second, row);
        if (!changed) return changed;
    }
    return {};
}

Result<void> MachineDataDocument::update_entry(const SectionRules& rules, const DataRow& before,
                                               const DataRow& after) {
    FieldValues changed;
    for (std::size_t i = 0; i < rules.fields.size(); ++i) {
        if (!is_same_value(rules, rules.fields[i], before.values[i], after.values[i]))
            changed.emplace_back(rules.fields[i].name, after.values[i]);
    }
    if (changed.empty()) return {};
    const std::size_t line = find_line(rules.section, before.id).value();
    const bool inch = row_at(line).row.unit == LengthUnit::inch;
    for (auto& [name, value] : changed) {
        const auto number = parse_number<double>(value);
        if (inch && number && rules.fields[*rules.find(name)].quantity == Quantity::length)
            value = inch_text(*number);
    }
    return edit(line, changed);
}

}  // namespace gsim::machine
