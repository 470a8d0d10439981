#include "machine/data/machine_data_reader.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "base/text/nearest_name.h"
#include "machine/data/machine_data_values.h"

namespace gsim::machine {

namespace {

constexpr std::size_t kMaxErrors = 100;
constexpr std::string_view kEllipsis = "...";
constexpr std::string_view kMissingNcfile = "the file does not begin with NCFILE";

std::vector<DataLine> split_lines(std::string_view text) {
    std::vector<DataLine> lines;
    while (!text.empty()) {
        const std::size_t newline = text.find('\n');
        const std::size_t next = newline == std::string_view::npos ? text.size() : newline + 1;
        std::size_t end = std::min(newline, text.size());
        if (end > 0 && text[end - 1] == '\r') --end;
        DataLine line;
        line.text = text.substr(0, end);
        line.end = text.substr(end, next - end);
        lines.push_back(std::move(line));
        text.remove_prefix(next);
    }
    return lines;
}

class DataReader {
  public:
    DataReader(std::string_view file_name, const DataRules& rules) : file_name_(file_name), rules_(rules) {}

    tl::expected<ParsedData, std::vector<Error>> read(std::string_view text) {
        read_.lines = split_lines(text);
        for (DataLine& line : read_.lines) {
            ++number_;
            has_error_ = false;
            read_line(line);
            if (errors_.size() >= kMaxErrors || lost_) break;
        }
        if (errors_.size() < kMaxErrors && !lost_) check_begin_and_end();
        if (!errors_.empty()) return tl::unexpected(std::move(errors_));
        return std::move(read_);
    }

  private:
    /// Keeps the first error of a line.
    void fail(std::size_t column, std::string_view message) {
        if (!has_error_)
            errors_.emplace_back(fmt::format("{}:{}:{}: {}", file_name_, number_, column, message));
        has_error_ = true;
    }

    /// Reports an error that leaves the rest without a usable meaning.
    void fail_fatally(std::size_t column, std::string_view message) {
        fail(column, message);
        lost_ = true;
    }

    void check_begin_and_end() {
        ++number_;
        has_error_ = false;
        if (!begun_) return fail(1, kMissingNcfile);
        if (!ended_) fail(1, "the file does not end with ENDFILE");
    }

    void read_line(DataLine& line) {
        if (const std::size_t nul = line.text.find('\0'); nul != std::string::npos)
            return fail_fatally(nul + 1, "the file contains a NUL byte; it must be a text file");
        words_ = data_words(line.text);
        if (words_.empty()) return;
        const DataWord& first = words_[0];
        if (!begun_) {
            if (first.text != "NCFILE") return fail_fatally(first.column, kMissingNcfile);
            expect_single_word();
            begun_ = true;
        } else if (ended_) {
            fail_fatally(first.column, "text after ENDFILE is not allowed");
        } else if (const auto section = find_section(first.text)) {
            begin_section(line, *section);
        } else if (first.text == "NCFILE") {
            fail(first.column, "NCFILE is only allowed in the first line");
        } else if (first.text == "ENDFILE") {
            expect_single_word();
            ended_ = true;
            line.kind = DataLine::Kind::end;
        } else if (first.text.starts_with(kEllipsis)) {
            leave_out(line);
        } else {
            read_entry(line);
        }
    }

    void expect_single_word() {
        if (words_.size() < 2) return;
        fail(words_[1].column, fmt::format("'{}' is an extra word", printable_word(words_[1].text)));
    }

    void begin_section(DataLine& line, DataSection section) {
        expect_single_word();
        section_ = section;
        skipping_ = false;
        line.kind = DataLine::Kind::section;
        line.section = section;
        check_unique(std::string(keyword(section)), fmt::format("the section {}", keyword(section)));
    }

    // Entries that are not in the file have their default values, as indicated by the dots of a printed file.
    void leave_out(DataLine& line) {
        if (!section_ || words_.size() > 1 || words_[0].text != kEllipsis) {
            return fail(
                words_[0].column,
                "'...' marks omitted entries of a section: alone in its line, after the section's keyword");
        }
        line.kind = DataLine::Kind::left_out;
        line.section = *section_;
    }

    void read_entry(DataLine& line) {
        const DataWord& first = words_[0];
        if (skipping_) return;
        if (!section_ || words_.size() == 1) return fail_unknown_keyword(first);
        const SectionRules& rules = rules_.of(*section_);
        const auto read = read_row(rules, words_);
        if (!read) return fail(read.error().column, read.error().message);
        line.kind = DataLine::Kind::entry;
        line.section = *section_;
        line.id = read->row.id;
        check_unique(data_key(*section_, read->row.id),
                     fmt::format("the {} {}", rules.what, printable_word(first.text)));
        check_unique_name(rules, *read);
        if (!has_error_) add_row(read_.data, rules, read->row, rules_.has_known_axes());
    }

    void check_unique_name(const SectionRules& rules, const ParsedRow& read) {
        const auto key = name_key(rules, read.row);
        if (!key) return;
        const std::size_t field = *rules.name_field();
        check_unique(*key,
                     fmt::format("the name {} of a {}", printable_word(read.row.values[field]), rules.what),
                     words_[*read.field_word_index[field]].column);
    }

    // Lines that follow a misspelled keyword belong to no known section.
    void fail_unknown_keyword(const DataWord& first) {
        const bool number = parse_number<double>(first.text).has_value();
        if (number && section_)
            return fail(first.column, fmt::format("{} has no values", printable_word(first.text)));
        skipping_ = true;
        std::vector<std::string_view> known{"NCFILE", "ENDFILE"};
        for (const DataSection section : kDataSections) known.push_back(keyword(section));
        const auto nearest = text::nearest_name(first.text, known);
        fail(first.column,
             fmt::format("'{}' is not a keyword; a section begins with OFFSET, FIXED, REFERENCE, HOME, TOOL, "
                         "VARIABLE, ALIAS, SECURITY or WORKING{}",
                         printable_word(first.text),
                         nearest ? fmt::format("; did you mean {}?", *nearest) : std::string()));
    }

    void check_unique(std::string key, const std::string& what) {
        check_unique(std::move(key), what, words_[0].column);
    }

    void check_unique(std::string key, const std::string& what, std::size_t column) {
        const auto [first, is_new] = first_lines_.try_emplace(std::move(key), number_);
        if (!is_new) fail(column, fmt::format("{} is given twice; first in line {}", what, first->second));
    }

    std::string_view file_name_;
    const DataRules& rules_;
    std::vector<DataWord> words_;  // of the line that is read
    std::size_t number_ = 0;       // of that line, from 1
    bool has_error_ = false;       // that line has an error
    bool lost_ = false;
    bool begun_ = false;
    bool ended_ = false;
    bool skipping_ = false;
    std::optional<DataSection> section_;
    std::map<std::string, std::size_t> first_lines_;
    ParsedData read_;
    std::vector<Error> errors_;
};

}  // namespace

tl::expected<ParsedData, std::vector<Error>> read_data_lines(std::string_view text,
                                                             std::string_view file_name,
                                                             const DataRules& rules) {
    return DataReader(file_name, rules).read(text);
}

}  // namespace gsim::machine
