#include "machine/import/linuxcnc_tables.h"

#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "base/text/digits.h"
#include "base/text/letter_case.h"
#include "base/units.h"
#include "machine/import/ini_file.h"

namespace gsim::import {

namespace {

constexpr std::string_view kLettersInOrder = "XYZABCUVW";  // of parameters
constexpr double kStoredUnit_mm =
    kMmPerInch;  // parameters of this project's RS274/NGC hold lengths in inches
constexpr int kFirstHome = 5161;
constexpr int kSecondHome = 5181;
constexpr int kG92Active = 5210;
constexpr int kFirstG92 = 5211;
constexpr int kActiveSystem = 5220;
constexpr int kFirstSystem = 5221;
constexpr int kParametersPerSystem = 20;
constexpr int kRotation = 9;
constexpr int kFirstUserVariable = 31;  // of the variables that programs may keep
constexpr int kLastUserVariable = 5000;
constexpr std::array<std::string_view, 9> kSystems{"54", "55",   "56",   "57",  "58",
                                                   "59", "59.1", "59.2", "59.3"};

bool is_rotary(char letter) {
    return letter >= 'A' && letter <= 'C';
}

// Calls read_line(line) for each line with content, until it returns an error.
template <typename LineHandler>
Result<void> for_each_line(std::string_view text, std::string_view file_name, LineHandler read_line) {
    std::size_t at = 0;
    for (int number = 1; at < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view line = text.substr(at, end - at);
        at = end + 1;
        line = trimmed_text(line.substr(0, line.find_first_of(";#")));
        if (line.empty()) continue;
        if (const Result<void> done = read_line(line); !done)
            return Unexpected(fmt::format("{}:{}: {}", file_name, number, done.error().message));
    }
    return {};
}

class Parameters {
  public:
    Parameters(double unit_mm, std::string_view axes, machine::MachineData& data, ImportNotes& notes)
        : unit_mm_(unit_mm), axes_(axes), data_(data), notes_(notes) {}

    Result<void> read_line(std::string_view line) {
        const std::size_t blank = std::min(line.find_first_of(" \t"), line.size());
        const auto number = parse_number_text(line.substr(0, blank));
        const auto value = parse_number_text(line.substr(blank));
        if (!number || !value || *number != std::floor(*number) || *number < 1 || *number > kLastParameter)
            return Unexpected(fmt::format("'{}' must be the number of a parameter and its value", line));
        values_[static_cast<int>(*number)] = *value;
        return {};
    }

    void use() {
        for (std::size_t system = 0; system < kSystems.size(); ++system) import_system(system);
        import_point(kFirstHome, "G28");
        import_point(kSecondHome, "G30");
        import_point(kFirstG92, "the G92 offset");
        if (value(kG92Active) != 0) data_.variables[kG92Active] = value(kG92Active);
        for (const auto& [number, of] : values_) {
            if (number >= kFirstUserVariable && number <= kLastUserVariable && of != 0)
                data_.variables[number] = of;
        }
        if (value(kActiveSystem) > 1)
            notes_.left_out.push_back(
                fmt::format("#5220 = {:.0f}: runs begin in G54, not in that system", value(kActiveSystem)));
    }

  private:
    static constexpr int kLastParameter = 9999;

    double value(int number) const {
        const auto found = values_.find(number);
        return found == values_.end() ? 0 : found->second;
    }

    // True if the machine has the axis of a value; reports a missing axis if the value is not 0.
    bool has_axis(char letter, double of, std::string_view what) {
        if (axes_.find(letter) != std::string_view::npos) return true;
        if (of != 0)
            notes_.left_out.push_back(
                fmt::format("{} of {}: the machine does not have this axis", letter, what));
        return false;
    }

    void import_system(std::size_t system) {
        const int first = kFirstSystem + static_cast<int>(system) * kParametersPerSystem;
        machine::AxisValues values;
        bool any = false;
        for (std::size_t i = 0; i < kLettersInOrder.size(); ++i) {
            const char letter = kLettersInOrder[i];
            const double of = value(first + static_cast<int>(i));
            if (!has_axis(letter, of, "G" + std::string(kSystems[system]))) continue;
            values[letter] = is_rotary(letter) ? of : remove_rounding_noise(of * unit_mm_);
            any = any || of != 0;
        }
        if (any) data_.offsets[std::string(kSystems[system])] = std::move(values);
        if (value(first + kRotation) != 0) data_.variables[first + kRotation] = value(first + kRotation);
    }

    void import_point(int first, std::string_view what) {
        for (std::size_t i = 0; i < kLettersInOrder.size(); ++i) {
            const char letter = kLettersInOrder[i];
            const double of = value(first + static_cast<int>(i));
            if (of == 0 || !has_axis(letter, of, what)) continue;
            data_.variables[first + static_cast<int>(i)] =
                is_rotary(letter) ? of : of * unit_mm_ / kStoredUnit_mm;
        }
    }

    double unit_mm_;
    std::string_view axes_;
    machine::MachineData& data_;
    ImportNotes& notes_;
    std::map<int, double> values_;
};

class ToolTableReader {
  public:
    ToolTableReader(double unit_mm, std::string_view axes, machine::MachineData& data, ImportNotes& notes)
        : unit_mm_(unit_mm), axes_(axes), data_(data), notes_(notes) {}

    Result<void> read_line(std::string_view line) {
        std::map<char, double> words;
        for (std::size_t at = 0; at < line.size();) {
            const std::size_t begin = line.find_first_not_of(" \t", at);
            if (begin == std::string_view::npos) break;
            std::size_t end = begin + 1;
            while (end < line.size() &&
                   (text::is_digit(line[end]) || line[end] == '.' || line[end] == '-' || line[end] == '+'))
                ++end;
            const char letter = text::upper(line.substr(begin, 1)).front();
            const auto value = parse_number_text(line.substr(begin + 1, end - begin - 1));
            if (kToolLetters.find(letter) == std::string_view::npos || !value)
                return Unexpected(fmt::format(
                    "'{}' is not a word of a tool: T P D X Y Z A B C U V W I J Q, each with a number",
                    line.substr(begin, line.find_first_of(" \t", begin) - begin)));
            words[letter] = *value;
            at = end;
        }
        return make_tool(words);
    }

  private:
    static constexpr std::string_view kToolLetters = "TPDXYZABCUVWIJQ";
    static constexpr double kMaxNumber = 99999;
    static constexpr int kOrientations = 10;

    Result<void> make_tool(const std::map<char, double>& words) {
        const auto of = [&](char letter) {
            const auto found = words.find(letter);
            return found == words.end() ? 0.0 : found->second;
        };
        if (words.find('T') == words.end()) return Unexpected("a tool needs its number T");
        const double number = of('T');
        if (number != std::floor(number) || number < 0 || number > kMaxNumber)
            return Unexpected(fmt::format("T{} is not a valid tool number", number));
        if (number == 0) {
            notes_.left_out.emplace_back("T0: tool numbers start at 1");
            return {};
        }
        machine::Tool tool;
        tool.length_mm = remove_rounding_noise(of('Z') * unit_mm_);
        tool.diameter_mm = remove_rounding_noise(of('D') * unit_mm_);
        tool.front_angle_deg = of('I');
        tool.back_angle_deg = of('J');
        const double orientation = of('Q');
        if (orientation != std::floor(orientation) || orientation < 0 || orientation >= kOrientations)
            return Unexpected(
                fmt::format("Q{} is not a valid orientation, which must be 0 to 9", orientation));
        tool.orientation = static_cast<int>(orientation);
        for (const char letter : {'X', 'Y', 'A', 'B', 'C', 'U', 'V', 'W'}) {
            if (of(letter) == 0) continue;
            if (axes_.find(letter) == std::string_view::npos) {
                notes_.left_out.push_back(
                    fmt::format("{} of tool {}: the machine does not have this axis", letter, number));
                continue;
            }
            tool.offsets[letter] =
                is_rotary(letter) ? of(letter) : remove_rounding_noise(of(letter) * unit_mm_);
        }
        if (words.find('P') != words.end() && of('P') != number)
            notes_.left_out.push_back(fmt::format("P{} of tool {}: magazine pockets", of('P'), number));
        data_.tools[static_cast<int>(number)] = std::move(tool);
        return {};
    }

    double unit_mm_;
    std::string_view axes_;
    machine::MachineData& data_;
    ImportNotes& notes_;
};

}  // namespace

Result<void> import_parameters(std::string_view text, std::string_view file_name, double unit_mm,
                               std::string_view axes, machine::MachineData& data, ImportNotes& notes) {
    Parameters parameters(unit_mm, axes, data, notes);
    return for_each_line(text, file_name, [&](std::string_view line) { return parameters.read_line(line); })
        .map([&] { parameters.use(); });
}

Result<void> import_tools(std::string_view text, std::string_view file_name, double unit_mm,
                          std::string_view axes, machine::MachineData& data, ImportNotes& notes) {
    ToolTableReader tools(unit_mm, axes, data, notes);
    return for_each_line(text, file_name, [&](std::string_view line) { return tools.read_line(line); });
}

}  // namespace gsim::import
