#include "cam/cutting/order.h"

#include <algorithm>
#include <numeric>

#include "cam/cutting/tour.h"

namespace gsim::cutting {

using geometry::Point;

namespace {

// An outline's cuts with all cuts within it: a sequence that is kept together.
struct Group {
    std::vector<std::size_t> cuts;
    Stop stop;
};

class Grouping {
  public:
    Grouping(const Layout& layout, const std::vector<Cut>& cuts)
        : cuts_(cuts), cuts_by_outline_(layout.outlines.size()), children_(layout.outlines.size()) {
        for (std::size_t i = 0; i < cuts.size(); ++i) cuts_by_outline_[cuts[i].outline].push_back(i);
        // The innermost outlines come first, so that each finds its children grouped.
        std::vector<std::size_t> innermost_first(layout.outlines.size());
        std::iota(innermost_first.begin(), innermost_first.end(), 0U);
        std::stable_sort(innermost_first.begin(), innermost_first.end(), [&](std::size_t a, std::size_t b) {
            return layout.outlines[a].depth > layout.outlines[b].depth;
        });
        for (const std::size_t outline : innermost_first) {
            Group group = make_group(outline);
            const auto& parent = layout.outlines[outline].parent;
            (parent ? children_[*parent] : outermost_).push_back(std::move(group));
        }
    }

    std::vector<std::size_t> from(Point start) { return joined(std::move(outermost_), start, {}); }

  private:
    static std::vector<std::size_t> joined(std::vector<Group> groups, Point start, std::optional<Point> end) {
        std::vector<Stop> stops;
        stops.reserve(groups.size());
        for (const Group& group : groups) stops.push_back(group.stop);
        std::vector<std::size_t> cuts;
        for (const std::size_t i : short_tour(stops, start, end)) {
            cuts.insert(cuts.end(), groups[i].cuts.begin(), groups[i].cuts.end());
        }
        return cuts;
    }

    Group make_group(std::size_t outline) {
        std::vector<Group> inner = std::move(children_[outline]);
        // Smaller loops of the outline itself count as inner ones.
        const std::vector<std::size_t>& contours_of_outline = cuts_by_outline_[outline];
        for (std::size_t i = 0; i + 1 < contours_of_outline.size(); ++i)
            inner.push_back({{contours_of_outline[i]}, cut_stop(contours_of_outline[i])});
        const Stop last = cut_stop(contours_of_outline.back());
        // The tour starts near the outline's own pierce, because it also ends there.
        Group group{joined(std::move(inner), last.entry, last.entry), {}};
        group.cuts.push_back(contours_of_outline.back());
        group.stop = {cuts_[group.cuts.front()].pierce(), last.exit};
        return group;
    }

    Stop cut_stop(std::size_t cut) const { return {cuts_[cut].pierce(), cuts_[cut].end()}; }

    const std::vector<Cut>& cuts_;
    std::vector<std::vector<std::size_t>> cuts_by_outline_;  // cuts of an outline, the largest last
    std::vector<std::vector<Group>> children_;
    std::vector<Group> outermost_;
};

}  // namespace

std::vector<std::size_t> cutting_order(const Layout& layout, const std::vector<Cut>& cuts, Point start) {
    return Grouping(layout, cuts).from(start);
}

}  // namespace gsim::cutting
