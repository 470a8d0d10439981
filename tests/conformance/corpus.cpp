#include "tests/conformance/corpus.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

namespace gsim::conformance {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPlain = ".canon.gz";
constexpr std::string_view kWithout = ".canon-without-M428-430.gz";

std::optional<Recorded> recorded(const fs::path& canon) {
    const std::string name = canon.string();
    const bool without = name.ends_with(kWithout);
    if (!without && !name.ends_with(kPlain)) return std::nullopt;
    const std::size_t suffix = without ? kWithout.size() : kPlain.size();
    return Recorded{name.substr(0, name.size() - suffix), canon, without};
}

// Length of a word M428, M429 or M430 that the text begins with, else 0.
std::size_t length_of_switch(std::string_view text) {
    if (!text.starts_with('M') && !text.starts_with('m')) return 0;
    const std::size_t digits = text.find_first_not_of('0', 1);
    if (digits == std::string_view::npos) return 0;
    const std::size_t end = std::min(text.find_first_not_of("0123456789.", digits), text.size());
    const std::string_view code = text.substr(digits, end - digits);
    return code == "428" || code == "429" || code == "430" ? end : 0;
}

}  // namespace

Result<std::vector<Recorded>> find_recorded(const fs::path& folder) {
    std::vector<Recorded> all;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::optional<Recorded> found = recorded(entry->path());
        if (found && fs::is_regular_file(found->program)) all.push_back(*std::move(found));
    }
    if (error) return Unexpected(fmt::format("cannot read {}: {}", folder.string(), error.message()));
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.canon < b.canon; });
    return all;
}

std::string without_kinematics_switches(const std::string& program) {
    std::string kept;
    for (std::size_t at = 0; at < program.size();) {
        const std::size_t length = length_of_switch(std::string_view(program).substr(at));
        if (length == 0) kept += program[at];
        at += std::max<std::size_t>(length, 1);
    }
    return kept;
}

}  // namespace gsim::conformance
