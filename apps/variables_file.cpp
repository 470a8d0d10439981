#include "apps/variables_file.h"

#include <filesystem>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "os/output_file.h"
#include "runtime/machine/text_file.h"

namespace gsim::apps {

tl::expected<std::map<int, double>, std::string> read_variables(const std::string& path) {
    std::map<int, double> values;
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return values;
    const auto text = machine::read_text_file(path, os::NamedBy::command_line);
    if (!text) return tl::unexpected(text.error());
    std::istringstream lines(*text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::istringstream words(line);
        int variable = 0;
        double value = 0;
        std::string rest;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        if (!(words >> variable >> value) || words >> rest)
            return tl::unexpected(
                fmt::format("{}:{}: a line is the number of a variable and its value", path, number));
        values[variable] = value;
    }
    return values;
}

tl::expected<void, std::string> write_variables(const std::string& path,
                                                const std::map<int, double>& values) {
    std::string text;
    for (const auto& [number, value] : values) text += fmt::format("{}\t{}\n", number, value);
    return os::write_file(path, text, os::Reach::disk);
}

}  // namespace gsim::apps
