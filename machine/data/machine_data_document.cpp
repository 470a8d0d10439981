#include "machine/data/machine_data_document.h"

#include <fmt/format.h>

namespace gsim::machine {

namespace {

constexpr std::string_view kEmptyFile = "NCFILE\nENDFILE\n";

std::string joined(const std::vector<DataLine>& lines) {
    std::string text;
    for (const DataLine& line : lines) text += line.text + line.end;
    return text;
}

std::string missing_entry_text(DataSection section, std::string_view id) {
    return fmt::format("{} {} does not exist in the file", keyword(section), printable_word(id));
}

// Returns the message of "x:line:column: message"; line numbers of a rejected change refer to a text that
// users never see.
std::string format_error(const std::string& error) {
    return error.substr(error.find(": ") + 2);
}

}  // namespace

MachineDataDocument::MachineDataDocument(std::span<const Axis> axes)
    : rules_(axes), lines_(read_data_lines(kEmptyFile, "", rules_)->lines) {}

tl::expected<MachineDataDocument, std::vector<Error>> MachineDataDocument::read(std::string_view text,
                                                                                std::string_view file_name,
                                                                                std::span<const Axis> axes) {
    MachineDataDocument document(axes);
    auto read = read_data_lines(text, file_name, document.rules_);
    if (!read) return tl::unexpected(std::move(read.error()));
    document.lines_ = std::move(read->lines);
    document.data_ = std::move(read->data);
    return document;
}

std::string MachineDataDocument::text() const {
    return joined(lines_);
}

std::vector<DataRow> MachineDataDocument::rows(DataSection section) const {
    std::vector<DataRow> rows;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (lines_[i].kind == DataLine::Kind::entry && lines_[i].section == section)
            rows.push_back(row_at(i).row);
    }
    return rows;
}

std::optional<DataRow> MachineDataDocument::find(DataSection section, std::string_view id) const {
    const auto line = find_line(section, id);
    if (!line) return std::nullopt;
    return row_at(*line).row;
}

MachineDataDocument::SourceLocation MachineDataDocument::location(DataSection section, std::string_view id,
                                                                  std::optional<std::size_t> field) const {
    const std::size_t line = find_line(section, id).value();
    const std::size_t word = field ? row_at(line).field_word_index[*field].value_or(0) : 0;
    return {line + 1, data_words(lines_[line].text)[word].column};
}

template <typename Change>
Result<void> MachineDataDocument::attempt(Change change) {
    std::vector<DataLine> before = lines_;
    Result<void> changed = change();
    if (changed) {
        auto read = read_data_lines(joined(lines_), "x", rules_);
        if (read) {
            lines_ = std::move(read->lines);
            data_ = std::move(read->data);
            return {};
        }
        changed = Unexpected(format_error(read.error().front().message));
    }
    lines_ = std::move(before);
    return changed;
}

Result<void> MachineDataDocument::set(DataSection section, std::string_view id, const FieldValues& values,
                                      std::optional<LengthUnit> unit) {
    return attempt([&]() -> Result<void> {
        const SectionRules& rules = rules_.of(section);
        if (unit && !rules.has_unit)
            return Unexpected(fmt::format("{} has no lengths and therefore no unit", rules.keyword));
        auto known = read_id(rules, id);
        if (!known) return tl::unexpected(std::move(known.error()));
        if (const auto line = find_line(section, *known)) {
            return convert_line(*line, unit.value_or(row_at(*line).row.unit)).and_then([&] {
                return edit(*line, values);
            });
        }
        DataRow row;
        row.id = *std::move(known);
        row.unit = unit.value_or(LengthUnit::metric);
        return add(rules, std::move(row), values);
    });
}

Result<void> MachineDataDocument::erase(DataSection section, std::string_view id) {
    return attempt([&]() -> Result<void> {
        const auto line = find_line(section, id);
        if (!line) return tl::unexpected(missing_entry_text(section, id));
        erase_line(*line);
        return {};
    });
}

Result<void> MachineDataDocument::reset(DataSection section, std::string_view id) {
    return attempt([&]() -> Result<void> {
        const auto line = find_line(section, id);
        return line ? reset_line(*line) : tl::unexpected(missing_entry_text(section, id));
    });
}

Result<void> MachineDataDocument::reset_all(DataSection section) {
    return attempt([&]() -> Result<void> {
        for (std::size_t i = lines_.size(); i-- > 0;) {  // from the end, as lines may go away
            if (lines_[i].kind != DataLine::Kind::entry || lines_[i].section != section) continue;
            if (Result<void> changed = reset_line(i); !changed) return changed;
        }
        return {};
    });
}

Result<void> MachineDataDocument::convert(LengthUnit unit) {
    return attempt([&]() -> Result<void> {
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (lines_[i].kind != DataLine::Kind::entry) continue;
            if (Result<void> changed = convert_line(i, unit); !changed) return changed;
        }
        return {};
    });
}

Result<void> MachineDataDocument::update(const MachineData& data) {
    return attempt([&]() -> Result<void> {
        for (const DataSection section : kDataSections) {
            if (Result<void> changed = update_section(rules_.of(section), data); !changed) return changed;
        }
        return {};
    });
}

}  // namespace gsim::machine
