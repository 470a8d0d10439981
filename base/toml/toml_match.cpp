#include "base/toml/toml_match.h"

#include <algorithm>
#include <cstdint>

namespace gsim::base {

namespace {

using nlohmann::json;

/// Max number of comparisons; in longer lists equal values are searched only at both ends.
constexpr std::size_t kMaxComparisons = std::size_t{1} << 20U;

/// Matching of elements from both ends inwards.
class ElementMatcher {
  public:
    ElementMatcher(const json& old, const json& requested)
        : old_(old), target_(requested), found_(requested.size()), used_(old.size()) {}

    std::vector<std::optional<std::size_t>> find() {
        match_ends();
        if ((old_end_ - begin_) * (requested_end_ - begin_) <= kMaxComparisons) {
            match_in_order();
            match_moved();
        }
        match_between();
        return std::move(found_);
    }

  private:
    void match(std::size_t old, std::size_t requested) {
        found_[requested] = old;
        used_[old] = true;
    }

    void match_ends() {
        old_end_ = old_.size();
        requested_end_ = target_.size();
        while (begin_ < std::min(old_end_, requested_end_) && old_[begin_] == target_[begin_]) {
            match(begin_, begin_);
            ++begin_;
        }
        while (std::min(old_end_, requested_end_) > begin_ &&
               old_[old_end_ - 1] == target_[requested_end_ - 1]) {
            match(--old_end_, --requested_end_);
        }
    }

    // Matches the longest common subsequence: entry (i, j) is its length from there on.
    void match_in_order() {
        const std::size_t rows = old_end_ - begin_;
        const std::size_t columns = requested_end_ - begin_;
        std::vector<std::uint32_t> lengths((rows + 1) * (columns + 1));
        const auto length = [&](std::size_t i, std::size_t j) -> std::uint32_t& {
            return lengths[i * (columns + 1) + j];
        };
        const auto same = [&](std::size_t i, std::size_t j) {
            return old_[begin_ + i] == target_[begin_ + j];
        };
        for (std::size_t i = rows; i-- > 0;) {
            for (std::size_t j = columns; j-- > 0;) {
                length(i, j) =
                    same(i, j) ? length(i + 1, j + 1) + 1 : std::max(length(i + 1, j), length(i, j + 1));
            }
        }
        std::size_t i = 0;
        std::size_t j = 0;
        while (i < rows && j < columns) {
            if (same(i, j)) {
                anchors_.push_back(begin_ + j);
                match(begin_ + i++, begin_ + j++);
            } else if (length(i + 1, j) >= length(i, j + 1)) {
                ++i;
            } else {
                ++j;
            }
        }
    }

    void match_moved() {
        for (std::size_t j = begin_; j < requested_end_; ++j) {
            for (std::size_t i = begin_; i < old_end_ && !found_[j]; ++i) {
                if (!used_[i] && old_[i] == target_[j]) match(i, j);
            }
        }
    }

    // Matches from one value that stays in its order to the next.
    void match_between() {
        std::size_t old = begin_;
        std::size_t requested = begin_;
        for (const std::size_t anchor : anchors_) {
            match_gap(old, *found_[anchor], requested, anchor);
            old = *found_[anchor] + 1;
            requested = anchor + 1;
        }
        match_gap(old, old_end_, requested, requested_end_);
    }

    void match_gap(std::size_t old, std::size_t old_end, std::size_t requested, std::size_t requested_end) {
        std::vector<std::size_t> removed;
        std::vector<std::size_t> added;
        for (; old < old_end; ++old) {
            if (!used_[old]) removed.push_back(old);
        }
        for (; requested < requested_end; ++requested) {
            if (!found_[requested]) added.push_back(requested);
        }
        const auto is_structured = [&](std::size_t i) {
            return old_[removed[i]].is_structured() && old_[removed[i]].type() == target_[added[i]].type();
        };
        for (std::size_t i = 0; i < std::min(removed.size(), added.size()); ++i) {
            if (removed.size() == added.size() || is_structured(i)) match(removed[i], added[i]);
        }
    }

    const json& old_;
    const json& target_;
    std::vector<std::optional<std::size_t>> found_;
    std::vector<bool> used_;
    std::vector<std::size_t> anchors_;  ///< Wanted elements that stay in their order.
    std::size_t begin_ = 0;
    std::size_t old_end_ = 0;
    std::size_t requested_end_ = 0;
};

}  // namespace

std::vector<std::optional<std::size_t>> match_elements(const json& old, const json& requested) {
    return ElementMatcher(old, requested).find();
}

}  // namespace gsim::base
