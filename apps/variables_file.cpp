#include "apps/variables_file.h"

#include <filesystem>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "base/os/input_file.h"
#include "base/os/output_file.h"

namespace gsim::apps {

tl::expected<std::map<int, double>, std::string> read_variables(const std::string& path) {
    // What cannot be looked at is no new file: reading it tells why.
    std::error_code error;
    if (!std::filesystem::exists(path, error) && !error) return std::map<int, double>();
    return os::read_text_file(path, os::NamedBy::command_line).and_then([&](const std::string& text) {
        return variables_of(text, path);
    });
}

tl::expected<std::map<int, double>, std::string> variables_of(std::string_view text,
                                                              std::string_view file_name) {
    std::map<int, double> values;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::istringstream words(line);
        int variable = 0;
        double value = 0;
        std::string rest;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        if (!(words >> variable >> value) || words >> rest)
            return tl::unexpected(
                fmt::format("{}:{}: a line is the number of a variable and its value", file_name, number));
        values[variable] = value;
    }
    return values;
}

std::string variables_text(const std::map<int, double>& values) {
    std::string text;
    for (const auto& [number, value] : values) text += fmt::format("{}\t{}\n", number, value);
    return text;
}

tl::expected<void, std::string> write_variables(const std::string& path,
                                                const std::map<int, double>& values) {
    return os::write_file(path, variables_text(values), os::Reach::disk);
}

}  // namespace gsim::apps
