#include "geometry/planar/stitch.h"

#include <limits>
#include <span>

#include "geometry/planar/box_tree.h"
#include "geometry/planar/chain.h"

namespace gsim::geometry {

namespace {

constexpr double kJoinTolerance_mm = 5 * kMinPartLength_mm;
constexpr double kMaxLooseLength_mm =
    0.05;  // parts that graze the contour may seem far enough off for so long
constexpr std::size_t kNoPart = std::numeric_limits<std::size_t>::max();

// Candidates that may follow each part.
class Followers {
  public:
    explicit Followers(const std::vector<DirectedPart>& parts)
        : parts_(parts), predecessor_counts_(parts.size(), 0) {
        std::vector<Box> starts;
        starts.reserve(parts.size());
        for (const DirectedPart& part : parts) starts.push_back({part.edge.start, part.edge.start});
        const BoxTree tree(starts);
        first_.reserve(parts.size() + 1);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            first_.push_back(followers_.size());
            const Point end = parts[i].edge.end;
            tree.visit(Box{end, end}.expanded(kJoinTolerance_mm), [&](std::size_t j) {
                if (j != i) add(j);
                return true;
            });
        }
        first_.push_back(followers_.size());
    }

    std::span<const std::size_t> of(std::size_t part) const {
        return std::span(followers_).subspan(first_[part], first_[part + 1] - first_[part]);
    }

    // Returns the parts on paths that continue at both ends over and over; all other parts lead to dead ends.
    std::vector<bool> find_live_parts() const {
        std::vector<bool> is_live(parts_.size(), true);
        std::vector<std::vector<std::size_t>> predecessors(parts_.size());
        std::vector<std::size_t> after(parts_.size(), 0);
        std::vector<std::size_t> before = predecessor_counts_;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            after[i] = of(i).size();
            for (const std::size_t j : of(i)) predecessors[j].push_back(i);
        }
        std::vector<std::size_t> ended;
        const auto remove_if_dead_end = [&](std::size_t i) {
            if (is_live[i] && (after[i] == 0 || before[i] == 0)) {
                is_live[i] = false;
                ended.push_back(i);
            }
        };
        for (std::size_t i = 0; i < parts_.size(); ++i) remove_if_dead_end(i);
        while (!ended.empty()) {
            const std::size_t i = ended.back();
            ended.pop_back();
            for (const std::size_t j : of(i)) {
                --before[j];
                remove_if_dead_end(j);
            }
            for (const std::size_t j : predecessors[i]) {
                --after[j];
                remove_if_dead_end(j);
            }
        }
        return is_live;
    }

  private:
    void add(std::size_t part) {
        followers_.push_back(part);
        ++predecessor_counts_[part];
    }

    const std::vector<DirectedPart>& parts_;
    std::vector<std::size_t> followers_;
    std::vector<std::size_t> first_;               // into followers_
    std::vector<std::size_t> predecessor_counts_;  // how many parts each may follow
};

class Stitcher {
  public:
    explicit Stitcher(const std::vector<DirectedPart>& parts)
        : parts_(parts), followers_(parts), is_free_(followers_.find_live_parts()) {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (!is_free_[i] && length_mm(parts[i].edge) > kMaxLooseLength_mm)
                result_.loose_end = parts[i].edge.end;
        }
    }

    StitchResult run() {
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (is_free_[i]) trace_chain(i);
        }
        return std::move(result_);
    }

  private:
    void trace_chain(std::size_t first) {
        path_.clear();
        double length = 0;
        std::size_t part = first;
        do {
            is_free_[part] = false;
            path_.push_back(part);
            length += length_mm(parts_[part].edge);
            part = next(part, first);
        } while (part != kNoPart && part != first);
        if (part == first) {
            close();
        } else if (length > kMaxLooseLength_mm) {
            result_.loose_end = parts_[path_.back()].edge.end;
        }
    }

    std::size_t next(std::size_t part, std::size_t first) const {
        std::size_t best = kNoPart;
        double nearest = HUGE_VAL;
        for (const std::size_t follower : followers_.of(part)) {
            // If two parts almost coincide, the other one would lead past the end.
            if (follower == first) return first;
            const double gap = distance(parts_[part].edge.end, parts_[follower].edge.start);
            if (is_free_[follower] && gap < nearest) {
                best = follower;
                nearest = gap;
            }
        }
        return best;
    }

    void close() {
        Contour contour;
        contour.closed = true;
        contour.vertices.reserve(path_.size());
        for (const std::size_t part : path_) {
            const DirectedPart& from = parts_[part];
            contour.vertices.push_back({from.edge.start, from.edge.bulge, from.source});
        }
        remove_short_edges(contour);
        if (contour.vertices.size() < 2) return;
        if (std::abs(area_mm2(contour)) <= kJoinTolerance_mm * length_mm(contour)) return;
        result_.contours.push_back(std::move(contour));
    }

    const std::vector<DirectedPart>& parts_;
    Followers followers_;
    std::vector<bool> is_free_;
    std::vector<std::size_t> path_;
    StitchResult result_;
};

}  // namespace

StitchResult stitch(const std::vector<DirectedPart>& parts) {
    return Stitcher(parts).run();
}

}  // namespace gsim::geometry
