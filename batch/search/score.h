#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "batch/search/search_plan.h"
#include "batch/store/sqlite.h"

namespace gsim::batch {

/// What a run came to, as the file of results has it.
struct RunFigures {
    std::int64_t run = 0;
    std::string status = {}, cause = {}, message = {}, program = {};
    std::map<std::string, std::optional<double>, std::less<>> figures = {};  ///< Of kFigures.

    bool is_clean() const { return status == "completed" && cause.empty(); }
    double figure(std::string_view name, double fallback = 0) const;
};

/// The runs of a batch in the order of its jobs. The error: some jobs have none.
tl::expected<std::vector<RunFigures>, std::string> read_figures(Database& results, std::int64_t batch,
                                                                std::uint64_t jobs);

/// Whether a run was not even begun: its program or an input was refused, or its process was lost.
bool was_not_begun(const RunFigures& run);

/// How good a variant is, over all programs and machines of its plan.
struct Score {
    /// Of the objective: what is less is better. Nothing where a run was not made to its end.
    std::optional<double> value = {};
    double violation = 0;  ///< By how much it is not allowed: 0 where all runs are within all limits.

    bool is_allowed() const { return violation == 0; }
    /// What is allowed is better, and else what is nearer to it (Deb 2000).
    bool operator<(const Score& other) const {
        if (violation != other.violation) return violation < other.violation;
        return value && (!other.value || *value < *other.value);
    }
};

/// `start`: the same runs of the files as they are; a variant must not have more process findings.
Score score_of(const SearchPlan& search, std::span<const RunFigures> runs, std::span<const RunFigures> start);

/// A figure of the objective or a limit that a run which came to its end does not have, in a sentence;
/// nothing where all are there.
std::string find_missing_figure(const SearchPlan& search, std::span<const RunFigures> runs);

}  // namespace gsim::batch
