#include "batch/plan/plan.h"
#include "batch/plan/plan_json.h"
#include "batch/search/search_plan.h"
#include "batch/search/space.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"

namespace gsim::fuzz {
namespace {

constexpr std::uint64_t kMostJobs = 10'000;  // which take milliseconds

std::optional<std::string> fault_of_job(const batch::Job& job) {
    const std::string line = batch::print_job(job);
    if (line.find('\n') != std::string::npos) return "a job of two lines";
    const auto repeated = batch::read_job(line);
    if (!repeated) return "a job is refused: " + repeated.error().message;
    if (batch::print_job(*repeated) != line) return "a job is another one when it is written";
    return std::nullopt;
}

/// Returns the result of a plan's search, if it has one.
Outcome check_search(std::string_view toml, const std::string& file) {
    const auto search = batch::read_search(toml, file);
    if (!search) return refused_with(search.error().message, file);
    const batch::SearchSpace space(search->plan.settings);
    if (space.dimensions() == 0 || search->objective.empty()) return broken("a search for nothing");
    for (const double place : {0.0, 0.5, 1.0}) {
        const auto count = static_cast<Eigen::Index>(space.dimensions());
        const batch::Job job{.program = "p",
                             .machine = "",
                             .options = nlohmann::json::object(),
                             .settings = space.variant(Eigen::VectorXd::Constant(count, place))};
        if (auto violation = fault_of_job(job)) return broken(*std::move(violation));
    }
    return accepted();
}

}  // namespace

Outcome check_batch_plan(std::string_view toml) {
    const std::string file = name_beside(".toml");
    if (Outcome search = check_search(toml, file); search.broken) return search;
    const auto plan = batch::read_plan(toml, file);
    if (!plan) return refused_with(plan.error().message, file);
    const auto handed = batch::read_plan_json(batch::print_plan_json(*plan));
    if (!handed) return broken("a plan is refused when it is handed on: " + handed.error().message);
    if (plan->design.runs * (plan->settings.size() + 1) > kMostJobs) return accepted();
    const batch::Jobs ours(*plan), theirs(*handed);
    if (ours.size() == 0 || ours.size() != theirs.size()) return broken("a plan of other jobs");
    for (const std::uint64_t number : {std::uint64_t{0}, ours.size() / 2, ours.size() - 1}) {
        const batch::Job job = ours.job(number);
        if (auto violation = fault_of_job(job)) return broken(*std::move(violation));
        if (batch::print_job(theirs.job(number)) != batch::print_job(job))
            return broken("another job of the same plan");
    }
    return accepted();
}

}  // namespace gsim::fuzz
