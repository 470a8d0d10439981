#include "tests/conformance/known.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "tests/conformance/programs.h"

namespace gsim::conformance {

namespace {

Result<std::vector<Known>> parse_known(const std::string& text, const std::filesystem::path& list) {
    std::vector<Known> known;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::istringstream words(line.substr(0, line.find('#')));
        Known entry;
        if (!(words >> entry.file)) continue;
        std::getline(words >> std::ws, entry.reason);
        entry.reason.erase(entry.reason.find_last_not_of(" \t\r") + 1);
        if (entry.reason.empty()) {
            return Unexpected(
                fmt::format("{}:{}: what does the error of {} hold?", list.string(), number, entry.file));
        }
        known.push_back(std::move(entry));
    }
    return known;
}

}  // namespace

Result<std::vector<Known>> read_known(const std::filesystem::path& list) {
    return read_text(list).and_then([&list](const std::string& text) { return parse_known(text, list); });
}

const Known* find_known(const std::vector<Known>& known, std::string_view program) {
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const Known& entry) { return program.ends_with(entry.file); });
    return found == known.end() ? nullptr : &*found;
}

}  // namespace gsim::conformance
