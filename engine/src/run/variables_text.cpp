#include "engine/src/run/variables_text.h"

#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace gsim::engine {

Result<std::map<int, double>> read_variables(const os::Files& files, const std::string& path) {
    if (files.is_absent(path)) return std::map<int, double>();
    return files.read_text(path, os::NameSource::command_line).and_then([&](const std::string& text) {
        return parse_variables(text, path);
    });
}

Result<std::map<int, double>> parse_variables(std::string_view text, std::string_view file_name) {
    std::map<int, double> values;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::istringstream words(line);
        int variable = 0;
        double value = 0;
        std::string remainder;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        if (!(words >> variable >> value) || words >> remainder)
            return Unexpected(fmt::format("{}:{}: a line must have the number of a variable and its value",
                                          file_name, number));
        values[variable] = value;
    }
    return values;
}

std::string variables_text(const std::map<int, double>& values) {
    std::string text;
    for (const auto& [number, value] : values) text += fmt::format("{}\t{}\n", number, value);
    return text;
}

}  // namespace gsim::engine
