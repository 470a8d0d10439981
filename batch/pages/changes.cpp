#include "batch/pages/changes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "base/text/json.h"

namespace gsim::batch {

namespace {

using nlohmann::json;

constexpr double kTimeTolerance = 1e-6;  // of the time: what rounding may do

bool has_different_time(const Case& of) {
    if (!of.now->has_time() || !of.before->has_time()) return false;
    return std::abs(time_difference_s(of)) > kTimeTolerance * std::max(of.now->time_s, of.before->time_s);
}

bool has_different_counts(const RunSummary& before, const RunSummary& now) {
    return before.status != now.status || before.cause != now.cause || before.violations != now.violations ||
           before.collisions != now.collisions || before.process_findings != now.process_findings ||
           before.warnings != now.warnings;
}

/// Counts each finding regardless of its position, because lines move if a remark is added.
std::map<std::string, int> count_findings(const std::string& findings) {
    std::map<std::string, int> counts;
    for (const json& each : text::try_parse_json<json>(findings)) {
        if (each.is_object()) ++counts[each.value("code", json()).dump() + each.value("text", json()).dump()];
    }
    return counts;
}

Result<bool> has_different_findings(const Case& of, RunHistory& run_history) {
    if (has_different_counts(*of.before, *of.now)) return true;
    const auto before = run_history.read(of.before->id);
    if (!before) return tl::unexpected(before.error());
    const auto now = run_history.read(of.now->id);
    if (!now) return tl::unexpected(now.error());
    return before->findings != now->findings &&
           count_findings(before->findings) != count_findings(now->findings);
}

std::string describe_file_change(const std::string& file, const std::string& before, const std::string& now) {
    return fmt::format("'{}'{}", file,
                       before.empty() ? " now exists" : (now.empty() ? " no longer exists" : ""));
}

/// Classifies a case that was run again.
Result<void> classify_case(Changes& changes, std::size_t position, const Case& of, RunHistory& run_history) {
    bool is_same = false;
    if (of.before->is_clean() != of.now->is_clean()) {
        (of.now->is_clean() ? changes.fixed : changes.newly_failing).push_back(position);
    } else {
        const auto others = has_different_findings(of, run_history);
        if (!others) return tl::unexpected(others.error());
        is_same = !*others;
        if (*others) changes.changed_findings.push_back(position);
    }
    if (has_different_time(of)) {
        changes.changed_times.push_back(position);
    } else if (is_same) {
        ++changes.same;
    }
    return {};
}

}  // namespace

double time_difference_s(const Case& of) {
    return of.now->time_s - of.before->time_s;
}

Result<Changes> find_changes(const NightlyReport& report, RunHistory& run_history) {
    Changes changes;
    if (!report.before) return changes;
    for (std::size_t i = 0; i < report.cases.size(); ++i) {
        const Case& of = report.cases[i];
        if (of.before == nullptr) {
            changes.added.push_back(i);
        } else if (of.now == nullptr) {
            changes.removed.push_back(i);
        } else if (of.now == of.before) {
            ++changes.same;
        } else if (const auto sorted = classify_case(changes, i, of, run_history); !sorted) {
            return tl::unexpected(sorted.error());
        }
    }
    std::stable_sort(changes.changed_times.begin(), changes.changed_times.end(),
                     [&](std::size_t a, std::size_t b) {
                         return std::abs(time_difference_s(report.cases[a])) >
                                std::abs(time_difference_s(report.cases[b]));
                     });
    return changes;
}

std::vector<std::string> rerun_reasons(const RunDetails& before, const RunDetails& now) {
    std::vector<std::string> reasons;
    if (before.program_sha256 != now.program_sha256) reasons.emplace_back("the program");
    if (before.machine_sha256 != now.machine_sha256) reasons.emplace_back("the machine");
    if (before.options != now.options) reasons.emplace_back("options");
    std::map<std::string, std::string> previous_files;
    for (const ReadFile& file : before.files) previous_files[file.name] = file.sha256;
    for (const ReadFile& file : now.files) {
        // A file that only one run looked for is a consequence of another change.
        const auto other = previous_files.find(file.name);
        if (other == previous_files.end() || other->second == file.sha256) continue;
        const bool is_machine = other->second == before.machine_sha256 && file.sha256 == now.machine_sha256;
        if (file.name != now.program && !is_machine)
            reasons.push_back(describe_file_change(file.name, other->second, file.sha256));
    }
    if (before.version != now.version) reasons.emplace_back("the version of gsim");
    return reasons;
}

}  // namespace gsim::batch
