// Changes of the lines of a document.
#include <algorithm>

#include <fmt/format.h>

#include "base/units.h"
#include "machine/data/machine_data_document.h"
#include "machine/data/machine_data_line.h"

namespace gsim::machine {

namespace {

double in_unit(double value, LengthUnit unit) {
    return unit == LengthUnit::inch ? value / kMmPerInch : value * kMmPerInch;
}

// 15 digits, so that 1.5 inches are 38.1 mm and not 38.099999999999994; more if 15 would not lead back.
std::string convert_length(double value, LengthUnit unit) {
    const LengthUnit other = unit == LengthUnit::inch ? LengthUnit::metric : LengthUnit::inch;
    std::string text;
    for (int digits = 15; digits <= 17; ++digits) {
        text = fmt::format("{:.{}g}", in_unit(value, unit), digits);
        const double back = in_unit(parse_number<double>(text).value_or(0), other);
        if (fmt::format("{:.15g}", back) == fmt::format("{:.15g}", value)) break;
    }
    return text;
}

std::string_view indentation(std::string_view line) {
    return line.substr(0, std::min(line.find_first_not_of(" \t"), line.size()));
}

bool is_number(const DataField& field) {
    return field.quantity != Quantity::text;
}

Result<void> check_words(const DataRow& row) {
    const auto invalid = std::find_if(row.values.begin(), row.values.end(), [](const std::string& value) {
        return !value.empty() && !is_data_word(value);
    });
    const std::string& word = invalid == row.values.end() ? row.id : *invalid;
    if (is_data_word(word)) return {};
    return Unexpected(fmt::format("'{}' cannot be written: it must be a single word", printable_word(word)));
}

std::string field_names(const SectionRules& rules) {
    std::string names;
    for (const DataField& field : rules.fields)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", field.name);
    return names;
}

// Writes values into a row by their names.
Result<void> merge(const SectionRules& rules, DataRow& row, const MachineDataDocument::FieldValues& values) {
    for (const auto& [name, value] : values) {
        const auto field = rules.find(name);
        if (!field) {
            return Unexpected(fmt::format("{} has no '{}'; it has {}", rules.keyword, printable_word(name),
                                          field_names(rules)));
        }
        const bool choice = rules.fields[*field].form == FieldForm::choice;
        row.values[*field] = choice ? upper_case(value) : value;
    }
    return check_words(row);
}

// Fills the positions before given values in a row: with 0, or no wall.
Result<void> fill(const SectionRules& rules, DataRow& row) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rules.positional(); ++i) {
        if (rules.fields[i].required || !row.values[i].empty()) count = i + 1;
    }
    if (rules.holds_zones) count += count % 2;
    for (std::size_t i = 0; i < count; ++i) {
        const DataField& field = rules.fields[i];
        if (!row.values[i].empty()) continue;
        if (!is_number(field)) return tl::unexpected(std::string(rules.missing_message));
        if (rules.section == DataSection::home && i >= kSpaceAxes) {
            return Unexpected(fmt::format(
                "a home position also needs a value for {}: its values are positional", field.name));
        }
        row.values[i] = std::string(1, field.may_be_unlimited ? '-' : '0');
    }
    return {};
}

bool is_same(const DataField& field, std::string_view a, std::string_view b) {
    if (!is_number(field)) return a == b;
    const auto first = parse_number<double>(a), second = parse_number<double>(b);
    return first && second ? *first == *second : a == b;
}

/// Change of the words of a line to the content of a row.
class LineChange {
  public:
    LineChange(const SectionRules& rules, std::string_view line, const ParsedRow& read)
        : rules_(rules), line_(line), read_(read) {}

    std::string to(const DataRow& requested) {
        replace_words(requested);
        erase_words(requested);
        insert_words(requested);
        set_unit(requested.unit);
        return line_.text();
    }

  private:
    void replace_words(const DataRow& requested) {
        for (std::size_t i = 0; i < rules_.fields.size(); ++i) {
            const DataField& field = rules_.fields[i];
            const std::string& value = requested.values[i];
            if (!read_.field_word_index[i] || value.empty() || is_same(field, value, read_.row.values[i]))
                continue;
            line_.replace(*read_.field_word_index[i], value_word(field, value));
        }
    }

    // Such words shift the indices of all later words.
    void moved(std::size_t from, std::ptrdiff_t by) {
        for (auto& word : read_.field_word_index) {
            if (word && *word >= from)
                *word = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(*word) + by);
        }
        if (read_.unit_word_index && *read_.unit_word_index >= from) {
            read_.unit_word_index =
                static_cast<std::size_t>(static_cast<std::ptrdiff_t>(*read_.unit_word_index) + by);
        }
    }

    void erase_words(const DataRow& requested) {
        for (std::size_t i = 0; i < rules_.fields.size(); ++i) {
            if (!read_.field_word_index[i] || !requested.values[i].empty()) continue;
            const std::size_t word = *read_.field_word_index[i];
            line_.erase(word);
            read_.field_word_index[i].reset();
            moved(word + 1, -1);
        }
    }

    void insert_words(const DataRow& requested) {
        for (std::size_t i = 0; i < rules_.fields.size(); ++i) {
            const DataField& field = rules_.fields[i];
            if (read_.field_word_index[i] || requested.values[i].empty()) continue;
            const std::size_t end = read_.unit_word_index.value_or(line_.size());
            const std::size_t word = field.form == FieldForm::positional ? i + 1 : end;
            line_.insert(word, value_word(field, requested.values[i]));
            moved(word, 1);
            read_.field_word_index[i] = word;
        }
    }

    void set_unit(LengthUnit unit) {
        if (unit == read_.row.unit) return;
        const std::string_view word = unit == LengthUnit::inch ? "inch" : "metric";
        if (read_.unit_word_index) return line_.replace(*read_.unit_word_index, word);
        line_.insert(line_.size(), word);
    }

    const SectionRules& rules_;
    EditedLine line_;
    ParsedRow read_;
};

}  // namespace

std::optional<std::size_t> MachineDataDocument::find_line(DataSection section, std::string_view id) const {
    const bool ignore_case = section == DataSection::alias;
    const std::string upper = upper_case(id);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        const DataLine& line = lines_[i];
        if (line.kind != DataLine::Kind::entry || line.section != section) continue;
        if (ignore_case ? upper_case(line.id) == upper : line.id == id) return i;
    }
    return std::nullopt;
}

ParsedRow MachineDataDocument::row_at(std::size_t line) const {
    return read_row(rules_.of(lines_[line].section), data_words(lines_[line].text)).value();
}

Result<void> MachineDataDocument::edit(std::size_t line, const FieldValues& values) {
    const SectionRules& rules = rules_.of(lines_[line].section);
    const ParsedRow read = row_at(line);
    DataRow requested = read.row;
    return merge(rules, requested, values).and_then([&] { return fill(rules, requested); }).map([&] {
        lines_[line].text = LineChange(rules, lines_[line].text, read).to(requested);
    });
}

Result<void> MachineDataDocument::convert_line(std::size_t line, LengthUnit unit) {
    const SectionRules& rules = rules_.of(lines_[line].section);
    const ParsedRow read = row_at(line);
    if (!rules.has_unit || read.row.unit == unit) return {};
    DataRow requested = read.row;
    requested.unit = unit;
    for (std::size_t i = 0; i < rules.fields.size(); ++i) {
        const Quantity quantity = rules.fields[i].quantity;
        const auto value = parse_number<double>(requested.values[i]);
        if (!value) continue;
        if (quantity == Quantity::length) requested.values[i] = convert_length(*value, unit);
        if (quantity != Quantity::unknown || *value == 0) continue;
        return Unexpected(
            fmt::format("{} {} has values of further axes; only the machine file defines whether they are "
                        "lengths or angles",
                        rules.keyword, read.row.id));
    }
    lines_[line].text = LineChange(rules, lines_[line].text, read).to(requested);
    return {};
}

Result<void> MachineDataDocument::add(const SectionRules& rules, DataRow row, const FieldValues& values) {
    row.values.resize(rules.fields.size());
    return merge(rules, row, values).and_then([&] { return fill(rules, row); }).map([&] {
        const std::size_t before = section_end(rules.section);
        const DataLine& above = lines_[before - 1];
        const bool sibling = above.kind == DataLine::Kind::entry;
        insert_line(
            before,
            sibling ? std::string(indentation(above.text)) + row_line(rules, row) : row_line(rules, row),
            DataLine::Kind::entry, rules.section);
        lines_[before].id = row.id;
    });
}

// Returns the position that follows the last entry of the section, or its keyword; a missing section is
// added.
std::size_t MachineDataDocument::section_end(DataSection section) {
    for (std::size_t i = lines_.size(); i-- > 0;) {
        const DataLine& line = lines_[i];
        const bool in_section = line.kind == DataLine::Kind::section || line.kind == DataLine::Kind::entry ||
                                line.kind == DataLine::Kind::left_out;
        if (in_section && line.section == section) return i + 1;
    }
    const auto end = std::find_if(lines_.begin(), lines_.end(),
                                  [](const DataLine& line) { return line.kind == DataLine::Kind::end; });
    const auto before = static_cast<std::size_t>(end - lines_.begin());
    insert_line(before, std::string(keyword(section)), DataLine::Kind::section, section);
    return before + 1;
}

// The line end is that of the line above.
void MachineDataDocument::insert_line(std::size_t before, std::string text, DataLine::Kind kind,
                                      DataSection section) {
    DataLine line;
    line.text = std::move(text);
    line.end = lines_[before - 1].end;
    line.kind = kind;
    line.section = section;
    lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(before), std::move(line));
}

void MachineDataDocument::erase_line(std::size_t line) {
    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(line));
}

Result<void> MachineDataDocument::reset_line(std::size_t line) {
    const SectionRules& rules = rules_.of(lines_[line].section);
    if (rules.section == DataSection::alias || rules.holds_zones) {
        erase_line(line);
        return {};
    }
    const DataRow row = row_at(line).row;
    FieldValues values;
    for (std::size_t i = 0; i < rules.fields.size(); ++i) {
        const DataField& field = rules.fields[i];
        if (!is_number(field) || row.values[i].empty()) continue;
        values.emplace_back(field.name, field.form == FieldForm::named_field ? "" : "0");
    }
    return edit(line, values);
}

}  // namespace gsim::machine
