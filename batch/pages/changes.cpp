#include "batch/pages/changes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "base/text/json.h"

namespace gsim::batch {

namespace {

using nlohmann::json;

constexpr double kSameTime = 1e-6;  // of the time: what rounding may do

bool has_other_time(const Case& of) {
    if (!of.now->has_time() || !of.before->has_time()) return false;
    return std::abs(time_difference_s(of)) > kSameTime * std::max(of.now->time_s, of.before->time_s);
}

bool has_other_counts(const RunFacts& before, const RunFacts& now) {
    return before.status != now.status || before.cause != now.cause || before.violations != now.violations ||
           before.collisions != now.collisions || before.process_findings != now.process_findings ||
           before.warnings != now.warnings;
}

/// Counts each finding regardless of its position, because lines move if a remark is added.
std::map<std::string, int> told_in(const std::string& findings) {
    std::map<std::string, int> told;
    for (const json& each : text::try_parse_json<json>(findings)) {
        if (each.is_object()) ++told[each.value("code", json()).dump() + each.value("text", json()).dump()];
    }
    return told;
}

tl::expected<bool, std::string> has_other_findings(const Case& of, RunBook& book) {
    if (has_other_counts(*of.before, *of.now)) return true;
    const auto before = book.read(of.before->id);
    if (!before) return tl::unexpected(before.error());
    const auto now = book.read(of.now->id);
    if (!now) return tl::unexpected(now.error());
    return before->findings != now->findings && told_in(before->findings) != told_in(now->findings);
}

std::string what_became_of(const std::string& file, const std::string& before, const std::string& now) {
    return fmt::format("'{}'{}", file,
                       before.empty() ? " is there now" : (now.empty() ? " is there no more" : ""));
}

/// Classifies a case that was run again.
tl::expected<void, std::string> sort_in(Changes& changes, std::size_t place, const Case& of, RunBook& book) {
    bool is_same = false;
    if (of.before->is_clean() != of.now->is_clean()) {
        (of.now->is_clean() ? changes.mended : changes.newly_failing).push_back(place);
    } else {
        const auto others = has_other_findings(of, book);
        if (!others) return tl::unexpected(others.error());
        is_same = !*others;
        if (*others) changes.other_findings.push_back(place);
    }
    if (has_other_time(of)) {
        changes.other_times.push_back(place);
    } else if (is_same) {
        ++changes.same;
    }
    return {};
}

}  // namespace

double time_difference_s(const Case& of) {
    return of.now->time_s - of.before->time_s;
}

tl::expected<Changes, std::string> find_changes(const Night& night, RunBook& book) {
    Changes changes;
    if (!night.before) return changes;
    for (std::size_t i = 0; i < night.cases.size(); ++i) {
        const Case& of = night.cases[i];
        if (of.before == nullptr) {
            changes.fresh.push_back(i);
        } else if (of.now == nullptr) {
            changes.gone.push_back(i);
        } else if (of.now == of.before) {
            ++changes.same;
        } else if (const auto sorted = sort_in(changes, i, of, book); !sorted) {
            return tl::unexpected(sorted.error());
        }
    }
    std::stable_sort(
        changes.other_times.begin(), changes.other_times.end(), [&](std::size_t a, std::size_t b) {
            return std::abs(time_difference_s(night.cases[a])) > std::abs(time_difference_s(night.cases[b]));
        });
    return changes;
}

std::vector<std::string> why_anew(const WholeRun& before, const WholeRun& now) {
    std::vector<std::string> why;
    if (before.program_sha256 != now.program_sha256) why.emplace_back("the program");
    if (before.machine_sha256 != now.machine_sha256) why.emplace_back("the machine");
    if (before.options != now.options) why.emplace_back("options");
    std::map<std::string, std::string> files_before;
    for (const ReadFile& file : before.files) files_before[file.name] = file.sha256;
    for (const ReadFile& file : now.files) {
        // A file that only one run looked for is a consequence of another change.
        const auto other = files_before.find(file.name);
        if (other == files_before.end() || other->second == file.sha256) continue;
        const bool is_machine = other->second == before.machine_sha256 && file.sha256 == now.machine_sha256;
        if (file.name != now.program && !is_machine)
            why.push_back(what_became_of(file.name, other->second, file.sha256));
    }
    if (before.version != now.version) why.emplace_back("gsim itself");
    return why;
}

}  // namespace gsim::batch
