#include "runtime/machine/machine_data.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "runtime/machine/nearest_name.h"
#include "runtime/machine/text_file.h"

namespace gsim::machine {

namespace {

using std::string_view_literals::operator""sv;

constexpr double kMmPerInch = 25.4;
constexpr double kGreatest = 1e9;
constexpr int kGreatestNumber = 99999;  // of a fixed point or a variable
constexpr std::array kKeywords{"NCFILE"sv,   "OFFSET"sv, "FIXED"sv, "ALIAS"sv,
                               "VARIABLE"sv, "TOOL"sv,   "HOME"sv,  "ENDFILE"sv};
constexpr std::array kSections{"OFFSET"sv, "FIXED"sv, "ALIAS"sv, "VARIABLE"sv, "TOOL"sv, "HOME"sv};

struct Word {
    std::string_view text;
    std::size_t column = 1;  // in bytes, from 1
};

struct Line {
    std::vector<Word> words;
    std::size_t number = 1;
};

bool is_space(char c) {
    return c == ' ' || c == '\t';
}

std::string upper(std::string_view text) {
    std::string out(text);
    for (char& c : out) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return out;
}

std::vector<Word> split(std::string_view line) {
    std::vector<Word> words;
    line = line.substr(0, line.find_first_of("#;"));
    for (std::size_t i = 0; i < line.size();) {
        const std::size_t start = i;
        while (i < line.size() && !is_space(line[i])) ++i;
        if (i > start) words.push_back({line.substr(start, i - start), start + 1});
        while (i < line.size() && is_space(line[i])) ++i;
    }
    return words;
}

// A word shown in a message: short, and without bytes that would upset a terminal.
std::string shown(std::string_view word) {
    std::string out;
    for (const char c : word.substr(0, 40))
        out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return word.size() > 40 ? out + "..." : out;
}

template <typename Number>
std::optional<Number> parse(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

bool is_offset_code(std::string_view code) {
    if (code == "59.1" || code == "59.2" || code == "59.3") return true;
    const auto number = parse<int>(code);
    return number && code == std::to_string(*number) &&
           ((*number >= 54 && *number <= 59) || (*number >= 505 && *number <= 599));
}

// Reads line by line and stops behind the line of the first error; until then a bad value counts as 0.
class Reader {
  public:
    Reader(std::string_view file_name, std::span<const Axis> axes) : file_name_(file_name) {
        further_axes_known_ = !axes.empty();
        for (const Axis& axis : axes) {
            if (axis.letter < 'X' || axis.letter > 'Z') further_axes_.push_back(axis);
        }
    }

    tl::expected<MachineData, std::string> read(std::string_view text) {
        std::size_t number = 0;
        while (!text.empty() && !error_) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            std::string_view line = text.substr(0, end);
            if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
            line_ = {split(line), ++number};
            if (!line_.words.empty()) read_line();
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        line_ = {{}, number + 1};
        if (!begun_) fail(1, "the file does not begin with NCFILE");
        if (!ended_) fail(1, "the file does not end with ENDFILE");
        if (error_) return tl::unexpected(*std::move(error_));
        return std::move(data_);
    }

  private:
    // Keeps the first error.
    void fail(std::size_t column, std::string_view sentence) {
        if (!error_) error_ = fmt::format("{}:{}:{}: {}", file_name_, line_.number, column, sentence);
    }

    const Word& word(std::size_t index) const { return line_.words[index]; }

    void read_line() {
        const Word& first = word(0);
        if (!begun_) {
            if (first.text != "NCFILE") fail(first.column, "the file does not begin with NCFILE");
            expect_words(1);
            begun_ = true;
        } else if (ended_) {
            fail(first.column, "there is text behind ENDFILE");
        } else if (first.text.starts_with("...")) {
            fail(first.column, "'...' stands for lines left out of a printed example; write them out");
        } else if (std::find(kKeywords.begin(), kKeywords.end(), first.text) != kKeywords.end()) {
            read_keyword(first);
        } else {
            read_entry(first);
        }
    }

    void read_keyword(const Word& keyword) {
        expect_words(1);
        if (keyword.text == "NCFILE") return fail(keyword.column, "NCFILE may stand in the first line only");
        if (keyword.text == "ENDFILE") {
            ended_ = true;
            return;
        }
        section_ = *std::find(kSections.begin(), kSections.end(), keyword.text);
        remember_once(std::string(section_), keyword, "the section");
    }

    void read_entry(const Word& first) {
        const bool begins_section = line_.words.size() == 1;
        if (section_.empty() || begins_section) return fail_unknown_keyword(first);
        if (section_ == "OFFSET") return read_offset(first);
        if (section_ == "FIXED") return read_fixed(first);
        if (section_ == "ALIAS") return read_alias(first);
        if (section_ == "TOOL") return read_tool(first);
        if (section_ == "HOME") return read_home(first);
        read_variable(first);
    }

    void fail_unknown_keyword(const Word& first) {
        const bool number = parse<double>(first.text).has_value();
        if (number && !section_.empty()) {
            return fail(first.column, fmt::format("{} has no values", shown(first.text)));
        }
        const auto nearest = nearest_name(first.text, kKeywords);
        const std::string hint = nearest ? fmt::format("; did you mean {}?", *nearest) : "";
        fail(first.column,
             fmt::format(
                 "'{}' is no keyword; a section begins with OFFSET, FIXED, ALIAS, VARIABLE, TOOL or HOME{}",
                 shown(first.text), hint));
    }

    void read_offset(const Word& code) {
        if (!is_offset_code(code.text)) {
            fail(code.column,
                 fmt::format("'{}' is no frame; frames are 54 to 59, 59.1 to 59.3 and 505 to 599",
                             shown(code.text)));
        }
        remember_once(fmt::format("OFFSET {}", code.text), code, "the frame");
        data_.offsets.emplace(std::string(code.text), read_axis_values());
    }

    void read_fixed(const Word& id) {
        const int number = read_number(id, "a fixed point");
        remember_once(fmt::format("FIXED {}", number), id, "the fixed point");
        data_.fixed.emplace(number, read_axis_values());
    }

    void read_alias(const Word& name) {
        expect_words(2);
        remember_once("ALIAS " + upper(name.text), name, "the alias");
        data_.aliases.emplace(std::string(name.text), std::string(word(1).text));
    }

    void read_variable(const Word& id) {
        expect_words(2);
        const int number = read_number(id, "a variable");
        remember_once(fmt::format("VARIABLE {}", number), id, "the variable");
        data_.variables.emplace(number, read_value(word(1)));
    }

    /// number length diameter [METRIC|INCH]
    void read_tool(const Word& id) {
        const int number = read_number(id, "a tool");
        remember_once(fmt::format("TOOL {}", number), id, "the tool");
        const auto [end, unit_mm] = values_end();
        if (end != 3) return fail(id.column, "a tool has its number, its length and its diameter");
        Tool tool;
        tool.length_mm = read_value(word(1)) * unit_mm;
        tool.diameter_mm = read_value(word(2)) * unit_mm;
        data_.tools.emplace(number, tool);
    }

    void read_home(const Word& id) {
        const int number = read_number(id, "a home position");
        if (number != 0 && (number < 2 || number > 4)) {
            fail(id.column, "home positions are 2 to 4; the first one is in the machine file");
        }
        remember_once(fmt::format("HOME {}", number), id, "the home position");
        data_.homes.emplace(number, read_axis_values());
    }

    struct ValuesEnd {
        std::size_t end;  ///< Index behind the line's last value.
        double unit_mm;
    };

    ValuesEnd values_end() const {
        const std::size_t count = line_.words.size();
        const std::string last = upper(word(count - 1).text);
        if (last == "INCH") return {count - 1, kMmPerInch};
        return {last == "METRIC" ? count - 1 : count, 1};
    }

    AxisValues read_axis_values() {
        const auto [end, unit_mm] = values_end();
        if (end < 4) {
            fail(word(0).column, fmt::format("{} needs values for X, Y and Z", shown(word(0).text)));
            return {};
        }
        AxisValues values{{'X', read_value(word(1)) * unit_mm},
                          {'Y', read_value(word(2)) * unit_mm},
                          {'Z', read_value(word(3)) * unit_mm}};
        for (std::size_t i = 4; i < end; ++i) add_further_value(values, i, unit_mm);
        return values;
    }

    void add_further_value(AxisValues& values, std::size_t index, double unit_mm) {
        const double value = read_value(word(index));
        if (!further_axes_known_) return;
        if (index - 4 >= further_axes_.size()) {
            return fail(word(index).column, fmt::format("there are more values than axes; behind X, Y and Z "
                                                        "this machine has {}",
                                                        further_axes_.size()));
        }
        const Axis& axis = further_axes_[index - 4];
        values[axis.letter] = axis.kind == AxisKind::linear ? value * unit_mm : value;
    }

    double read_value(const Word& text) {
        const auto value = parse<double>(text.text);
        if (!value || !std::isfinite(*value)) {
            fail(text.column, fmt::format("'{}' is not a number", shown(text.text)));
            return 0;
        }
        if (std::abs(*value) > kGreatest) {
            fail(text.column, fmt::format("{} is not between -1e9 and 1e9", shown(text.text)));
        }
        return *value;
    }

    int read_number(const Word& text, std::string_view what) {
        const auto number = parse<int>(text.text);
        if (!number || *number < 1 || *number > kGreatestNumber) {
            fail(text.column, fmt::format("'{}' is not the number of {}, 1 to {}", shown(text.text), what,
                                          kGreatestNumber));
            return 0;
        }
        return *number;
    }

    void expect_words(std::size_t count) {
        if (line_.words.size() > count) {
            fail(word(count).column, fmt::format("'{}' is one word too many", shown(word(count).text)));
        }
    }

    void remember_once(std::string key, const Word& at, std::string_view what) {
        const auto [first, added] = first_lines_.try_emplace(std::move(key), line_.number);
        if (added) return;
        fail(at.column,
             fmt::format("{} {} is given twice; first in line {}", what, shown(at.text), first->second));
    }

    std::string_view file_name_;
    bool further_axes_known_ = false;
    std::vector<Axis> further_axes_;
    Line line_;
    bool begun_ = false;
    bool ended_ = false;
    std::string_view section_;
    std::map<std::string, std::size_t> first_lines_;
    MachineData data_;
    std::optional<std::string> error_;
};

}  // namespace

tl::expected<MachineData, std::string> read_machine_data(std::string_view text, std::string_view file_name,
                                                         std::span<const Axis> axes) {
    return Reader(file_name, axes).read(text);
}

tl::expected<MachineData, std::string> load_machine_data(const std::filesystem::path& path,
                                                         std::span<const Axis> axes) {
    return read_text_file(path).and_then(
        [&](const std::string& text) { return read_machine_data(text, path.string(), axes); });
}

}  // namespace gsim::machine
