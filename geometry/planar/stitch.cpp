#include "geometry/planar/stitch.h"

#include <limits>
#include <span>

#include "geometry/planar/box_tree.h"
#include "geometry/planar/chain.h"

namespace gsim::geometry {

namespace {

constexpr double kJoin_mm = 5 * kShortestPart_mm;
constexpr double kLoose_mm = 0.05;  // parts that graze the contour may seem far enough off for so long
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// Candidates that may follow each part.
class Followers {
  public:
    explicit Followers(const std::vector<DirectedPart>& parts) : parts_(parts), before_(parts.size(), 0) {
        std::vector<Box> starts;
        starts.reserve(parts.size());
        for (const DirectedPart& part : parts) starts.push_back({part.edge.start, part.edge.start});
        const BoxTree tree(starts);
        first_.reserve(parts.size() + 1);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            first_.push_back(followers_.size());
            const Point end = parts[i].edge.end;
            tree.visit(Box{end, end}.grown(kJoin_mm), [&](std::size_t j) {
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
    std::vector<bool> lasting() const {
        std::vector<bool> lasts(parts_.size(), true);
        std::vector<std::vector<std::size_t>> predecessors(parts_.size());
        std::vector<std::size_t> after(parts_.size(), 0);
        std::vector<std::size_t> before = before_;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            after[i] = of(i).size();
            for (const std::size_t j : of(i)) predecessors[j].push_back(i);
        }
        std::vector<std::size_t> ended;
        const auto end_if_alone = [&](std::size_t i) {
            if (lasts[i] && (after[i] == 0 || before[i] == 0)) {
                lasts[i] = false;
                ended.push_back(i);
            }
        };
        for (std::size_t i = 0; i < parts_.size(); ++i) end_if_alone(i);
        while (!ended.empty()) {
            const std::size_t i = ended.back();
            ended.pop_back();
            for (const std::size_t j : of(i)) {
                --before[j];
                end_if_alone(j);
            }
            for (const std::size_t j : predecessors[i]) {
                --after[j];
                end_if_alone(j);
            }
        }
        return lasts;
    }

  private:
    void add(std::size_t part) {
        followers_.push_back(part);
        ++before_[part];
    }

    const std::vector<DirectedPart>& parts_;
    std::vector<std::size_t> followers_;
    std::vector<std::size_t> first_;   // into followers_
    std::vector<std::size_t> before_;  // how many parts each may follow
};

class Stitcher {
  public:
    explicit Stitcher(const std::vector<DirectedPart>& parts)
        : parts_(parts), followers_(parts), free_(followers_.lasting()) {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (!free_[i] && length_mm(parts[i].edge) > kLoose_mm) result_.loose = parts[i].edge.end;
        }
    }

    Stitched run() {
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (free_[i]) follow(i);
        }
        return std::move(result_);
    }

  private:
    void follow(std::size_t first) {
        way_.clear();
        double length = 0;
        std::size_t part = first;
        do {
            free_[part] = false;
            way_.push_back(part);
            length += length_mm(parts_[part].edge);
            part = next(part, first);
        } while (part != kNone && part != first);
        if (part == first) {
            close();
        } else if (length > kLoose_mm) {
            result_.loose = parts_[way_.back()].edge.end;
        }
    }

    std::size_t next(std::size_t part, std::size_t first) const {
        std::size_t best = kNone;
        double nearest = HUGE_VAL;
        for (const std::size_t follower : followers_.of(part)) {
            // If two parts almost coincide, the other one would lead past the end.
            if (follower == first) return first;
            const double apart = distance(parts_[part].edge.end, parts_[follower].edge.start);
            if (free_[follower] && apart < nearest) {
                best = follower;
                nearest = apart;
            }
        }
        return best;
    }

    void close() {
        Contour contour;
        contour.closed = true;
        contour.vertices.reserve(way_.size());
        for (const std::size_t part : way_) {
            const DirectedPart& from = parts_[part];
            contour.vertices.push_back({from.edge.start, from.edge.bulge, from.source});
        }
        drop_short_edges(contour);
        if (contour.vertices.size() < 2) return;
        if (std::abs(area_mm2(contour)) <= kJoin_mm * length_mm(contour)) return;
        result_.contours.push_back(std::move(contour));
    }

    const std::vector<DirectedPart>& parts_;
    Followers followers_;
    std::vector<bool> free_;
    std::vector<std::size_t> way_;
    Stitched result_;
};

}  // namespace

Stitched stitch(const std::vector<DirectedPart>& parts) {
    return Stitcher(parts).run();
}

}  // namespace gsim::geometry
