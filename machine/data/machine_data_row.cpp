#include "machine/data/machine_data_row.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/digits.h"
#include "base/units.h"

namespace gsim::machine {

namespace {

constexpr double kMaxValue = 1e9;
constexpr int kMaxNumber = 99999;

bool is_offset_code(std::string_view code) {
    if (code == "59.1" || code == "59.2" || code == "59.3") return true;
    const auto number = parse_number<int>(code);
    return number && code == std::to_string(*number) &&
           ((*number >= 54 && *number <= 59) || (*number >= 505 && *number <= 599));
}

bool is_letter(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

// A name is never a number, because points are searched by number, too.
bool is_name(std::string_view text) {
    return !text.empty() && is_letter(text[0]) && std::all_of(text.begin(), text.end(), [](char c) {
        return is_letter(c) || text::is_digit(c) || c == '_';
    });
}

std::string with_article(std::string_view what) {
    return fmt::format("{} {}", what.starts_with('a') ? "an" : "a", what);
}

double mm_per_unit(const DataField& field, LengthUnit unit) {
    return field.quantity == Quantity::length && unit == LengthUnit::inch ? kMmPerInch : 1;
}

class RowReader {
  public:
    RowReader(const SectionRules& rules, std::span<const DataWord> words) : rules_(rules), words_(words) {
        read_.row.values.resize(rules.fields.size());
        read_.field_word_index.resize(rules.fields.size());
    }

    Result<ParsedRow> read() {
        const auto id = read_id(rules_, words_[0].text);
        if (!id) return make_error(0, id.error().message);
        read_.row.id = *id;
        for (std::size_t i = 1; i < words_.size() && !error_; ++i) read_word(i);
        if (!error_) check_required();
        if (!error_) check_ranges();
        if (!error_ && rules_.holds_zones) check_walls();
        if (error_) return tl::unexpected(*std::move(error_));
        return std::move(read_);
    }

  private:
    Error error_at(std::size_t word, std::string message) const {
        return {std::move(message), 0, static_cast<std::uint32_t>(words_[word].column)};
    }

    Unexpected make_error(std::size_t word, std::string message) {
        return tl::unexpected(error_at(word, std::move(message)));
    }

    void fail(std::size_t word, std::string message) {
        if (!error_) error_ = error_at(word, std::move(message));
    }

    void fail_extra_word(std::size_t word) {
        fail(word, fmt::format("'{}' is an extra word", printable_word(words_[word].text)));
    }

    void read_word(std::size_t word) {
        const std::string upper = upper_case(words_[word].text);
        if (rules_.has_unit && (upper == "INCH" || upper == "METRIC"))
            return read_unit(word, upper == "INCH");
        if (const auto field = find_choice_field(upper)) return set_field(*field, word, upper);
        if (const std::size_t equals = upper.find('='); equals != std::string::npos && has_named_fields())
            return read_named(word, upper.substr(0, equals));
        read_positional(word);
    }

    void read_unit(std::size_t word, bool inch) {
        if (read_.unit_word_index) return fail_extra_word(word);
        read_.unit_word_index = word;
        read_.row.unit = inch ? LengthUnit::inch : LengthUnit::metric;
    }

    std::optional<std::size_t> find_choice_field(const std::string& upper) const {
        for (std::size_t i = 0; i < rules_.fields.size(); ++i) {
            const auto& choices = rules_.fields[i].choices;
            if (std::find(choices.begin(), choices.end(), upper) != choices.end()) return i;
        }
        return std::nullopt;
    }

    bool has_named_fields() const {
        return std::any_of(rules_.fields.begin(), rules_.fields.end(),
                           [](const DataField& field) { return field.form == FieldForm::named_field; });
    }

    void read_named(std::size_t word, const std::string& name) {
        const auto field = rules_.find(name);
        if (!field || rules_.fields[*field].form != FieldForm::named_field) {
            return fail(word, fmt::format("{} has no value with the name '{}'", with_article(rules_.what),
                                          printable_word(name)));
        }
        set_field(*field, word, std::string(words_[word].text.substr(name.size() + 1)));
    }

    void read_positional(std::size_t word) {
        if (position_ < rules_.positional()) {
            if (word != position_ + 1) {
                return fail(word, fmt::format("'{}' is too late: values come before other words",
                                              printable_word(words_[word].text)));
            }
            return set_field(position_++, word, std::string(words_[word].text));
        }
        if (!rules_.holds_points) return fail_extra_word(word);
        fail(word, fmt::format("there are more values than axes; after X, Y and Z this machine has {}",
                               rules_.positional() - 3));
    }

    void set_field(std::size_t field, std::size_t word, std::string value) {
        if (read_.field_word_index[field]) return fail_extra_word(word);
        read_.field_word_index[field] = word;
        if (const auto error = value_error(rules_.fields[field], value)) return fail(word, error->message);
        read_.row.values[field] = std::move(value);
    }

    static std::optional<Error> value_error(const DataField& field, std::string_view value) {
        if (field.is_name && !is_name(value)) {
            return fmt::format("'{}' is not a valid name: a letter first, then letters, digits and '_'",
                               printable_word(value));
        }
        if (field.quantity == Quantity::text || (field.may_be_unlimited && value == kNoLimit))
            return std::nullopt;
        if (field.quantity == Quantity::integer) {
            const auto number = parse_number<int>(value);
            if (number && *number >= field.min && *number <= field.max) return std::nullopt;
            return fmt::format("{} must be an integer from {} to {}, not '{}'", field.name, field.min,
                               field.max, printable_word(value));
        }
        const auto number = parse_number<double>(value);
        if (number && std::isfinite(*number)) return std::nullopt;
        return fmt::format("'{}' is not a number", printable_word(value));
    }

    void check_required() {
        for (std::size_t i = 0; i < rules_.fields.size(); ++i) {
            if (!rules_.fields[i].required || read_.field_word_index[i]) continue;
            return fail(0, rules_.holds_points
                               ? fmt::format("{} needs values for X, Y and Z", printable_word(words_[0].text))
                               : std::string(rules_.missing_message));
        }
    }

    void check_ranges() {
        for (std::size_t i = 0; i < rules_.fields.size(); ++i) {
            if (!read_.field_word_index[i] || std::abs(read_.row.number(rules_, i)) <= kMaxValue) continue;
            const bool inch = mm_per_unit(rules_.fields[i], read_.row.unit) != 1;
            fail(*read_.field_word_index[i],
                 fmt::format("{} must be between -1e9 and 1e9{}", printable_word(read_.row.values[i]),
                             inch ? " mm" : ""));
        }
    }

    bool is_open(std::size_t field) const {
        return !read_.field_word_index[field] || read_.row.values[field] == kNoLimit;
    }

    void check_walls() {
        bool any = false;
        for (std::size_t low = 0; low < 6 && !error_; low += 2) {
            const DataField& field = rules_.fields[low];
            if (is_open(low) != is_open(low + 1)) {
                return fail(0, fmt::format("{0}min and {0}max must both be numbers, or both '-' (no limits)",
                                           field.name[0]));
            }
            if (is_open(low)) continue;
            any = true;
            if (read_.row.number(rules_, low) < read_.row.number(rules_, low + 1)) continue;
            fail(*read_.field_word_index[low],
                 fmt::format("{0}min is {1} and {0}max is {2}; min must be less than max", field.name[0],
                             printable_word(read_.row.values[low]),
                             printable_word(read_.row.values[low + 1])));
        }
        if (!any) fail(0, "a zone needs its two limits on at least one axis");
    }

    const SectionRules& rules_;
    std::span<const DataWord> words_;
    ParsedRow read_;
    std::size_t position_ = 0;
    std::optional<Error> error_;
};

}  // namespace

double DataRow::number(const SectionRules& rules, std::size_t field) const {
    return parse_number<double>(values[field]).value_or(0) * mm_per_unit(rules.fields[field], unit);
}

Result<ParsedRow> read_row(const SectionRules& rules, std::span<const DataWord> words) {
    return RowReader(rules, words).read();
}

std::string data_key(DataSection section, std::string_view id) {
    return fmt::format("{} {}", keyword(section),
                       section == DataSection::alias ? upper_case(id) : std::string(id));
}

std::optional<std::string> name_key(const SectionRules& rules, const DataRow& row) {
    const auto field = rules.name_field();
    if (!field || row.values[*field].empty()) return std::nullopt;
    return fmt::format("{} NAME={}", rules.keyword, upper_case(row.values[*field]));
}

Result<std::string> read_id(const SectionRules& rules, std::string_view word) {
    if (rules.section == DataSection::alias) return std::string(word);
    if (rules.section == DataSection::offset) {
        if (is_offset_code(word)) return std::string(word);
        return Unexpected(fmt::format("'{}' is not a frame; frames are 54 to 59, 59.1 to 59.3 and 505 to 599",
                                      printable_word(word)));
    }
    const auto number = parse_number<int>(word);
    if (!number || *number < 1 || *number > kMaxNumber) {
        return Unexpected(fmt::format("'{}' is not a valid number of {}, 1 to {}", printable_word(word),
                                      with_article(rules.what), kMaxNumber));
    }
    if (rules.section == DataSection::home && (*number < 2 || *number > 4))
        return Unexpected("home positions are 2 to 4; the first is in the machine file");
    if (rules.section == DataSection::working && *number != 1)
        return Unexpected("there is only one working zone; its number is 1");
    return std::to_string(*number);
}

std::string value_word(const DataField& field, std::string_view value) {
    return field.form == FieldForm::named_field ? fmt::format("{}={}", field.name, value)
                                                : std::string(value);
}

std::string row_line(const SectionRules& rules, const DataRow& row) {
    std::string line = row.id;
    for (std::size_t i = 0; i < rules.fields.size(); ++i) {
        if (!row.values[i].empty()) line += fmt::format("  {}", value_word(rules.fields[i], row.values[i]));
    }
    return row.unit == LengthUnit::inch ? line + "  inch" : line;
}

}  // namespace gsim::machine
