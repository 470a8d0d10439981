#include "cam/cutting/lead.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>

#include "geometry/planar/box_tree.h"
#include "geometry/planar/intersection.h"

namespace gsim::cutting {

using geometry::Box;
using geometry::Contour;
using geometry::Edge;
using geometry::Point;

namespace {

constexpr std::size_t kLeadPositions = 8;  // in which a lead is tried
constexpr int kLeadSizeCount = 6;          // each half of the one before
constexpr double kMinLeadRadius_mm = 0.05;
constexpr double kClearTolerance_mm = 1e-4;

// The edges of many contours.
class EdgeIndex {
  public:
    void add(const Contour& contour) {
        for (std::size_t e = 0; e < contour.edges(); ++e) {
            edges_.push_back(contour.edge(e));
            boxes_.push_back(bounding_box(edges_.back()));
        }
    }
    void build() { tree_ = geometry::BoxTree(boxes_); }

    bool is_near(Point point, double distance) const {
        bool near = false;
        tree_.visit(Box{point, point}.expanded(distance), [&](std::size_t i) {
            near = distance_mm(edges_[i], point) < distance;
            return !near;
        });
        return near;
    }

    // Returns true if an edge is met farther than `ignored_radius_mm` from the point `ignored_point`.
    bool is_met(const Edge& edge, Point ignored_point, double ignored_radius_mm) const {
        bool is_hit = false;
        tree_.visit(bounding_box(edge), [&](std::size_t i) {
            for (const Point& point : geometry::intersections(edge, edges_[i])) {
                is_hit = is_hit || distance(point, ignored_point) > ignored_radius_mm;
            }
            return !is_hit;
        });
        return is_hit;
    }

  private:
    std::vector<Edge> edges_;
    std::vector<Box> boxes_;
    geometry::BoxTree tree_;
};

// Leads found so far, by the cells of a grid that they touch.
class LeadGrid {
  public:
    explicit LeadGrid(double cell_mm) : cell_mm_(cell_mm) {}

    void add(const Edge& lead) {
        for_each_cell(bounding_box(lead), [&](std::uint64_t key) { cells_[key].push_back(lead); });
    }

    /// Returns true if a lead comes nearer than `distance` to one of them.
    bool is_near(const Edge& lead, double distance) const {
        bool near = false;
        for_each_cell(bounding_box(lead).expanded(distance), [&](std::uint64_t key) {
            const auto cell = cells_.find(key);
            if (near || cell == cells_.end()) return;
            near = std::any_of(cell->second.begin(), cell->second.end(), [&](const Edge& other) {
                if (!bounding_box(other).expanded(distance).overlaps(bounding_box(lead))) return false;
                return geometry::intersections(lead, other).count > 0 ||
                       has_end_near(lead, other, distance) || has_end_near(other, lead, distance);
            });
        });
        return near;
    }

  private:
    static bool has_end_near(const Edge& a, const Edge& b, double distance) {
        return distance_mm(b, a.start) < distance || distance_mm(b, a.end) < distance;
    }

    template <typename Visit>
    void for_each_cell(const Box& box, Visit&& visit) const {
        const auto cell = [this](double mm) { return static_cast<std::int64_t>(std::floor(mm / cell_mm_)); };
        for (std::int64_t x = cell(box.low.x); x <= cell(box.high.x); ++x) {
            for (std::int64_t y = cell(box.low.y); y <= cell(box.high.y); ++y) {
                visit((static_cast<std::uint64_t>(x) << 32) ^ (static_cast<std::uint64_t>(y) & 0xffffffffU));
            }
        }
    }

    double cell_mm_;
    std::unordered_map<std::uint64_t, std::vector<Edge>> cells_;
};

struct ContourPosition {
    std::size_t edge = 0;
    double share = 0;
};

struct Leads {
    Edge in, out;
};

// Returns quarter circles to the right of the path, in the waste.
Leads quarter_circle_leads(Point entry, Point direction, double radius) {
    static const double kQuarterBulge = std::tan(std::numbers::pi / 8);
    const Point center = entry + radius * right_normal(direction);
    return {{center - radius * direction, entry, -kQuarterBulge},
            {entry, center + radius * direction, -kQuarterBulge}};
}

// Returns the middles and quarters of the longest edges, because most space is far from corners.
std::vector<ContourPosition> entry_candidates(const Contour& loop) {
    constexpr std::size_t kMaxLongestEdges = (kLeadPositions + 2) / 3;
    std::vector<std::size_t> edges(loop.edges());
    std::vector<double> lengths(loop.edges());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        edges[i] = i;
        lengths[i] = length_mm(loop.edge(i));
    }
    const std::size_t count = std::min(kMaxLongestEdges, edges.size());
    std::partial_sort(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(count), edges.end(),
                      [&](std::size_t a, std::size_t b) {
                          return lengths[a] != lengths[b] ? lengths[a] > lengths[b] : a < b;
                      });
    std::vector<ContourPosition> candidates;
    candidates.reserve(3 * count);
    for (const double share : {0.5, 0.25, 0.75}) {
        for (std::size_t i = 0; i < count; ++i) candidates.push_back({edges[i], share});
    }
    return candidates;
}

// Returns the same loop, starting from a position within an edge.
Contour with_start_at(const Contour& loop, ContourPosition position) {
    Contour result;
    result.closed = true;
    result.vertices.reserve(loop.vertices.size() + 1);
    const Edge edge = loop.edge(position.edge);
    const Edge second = sub_edge(edge, position.share, 1);
    const std::uint32_t source = loop.vertices[position.edge].source;
    result.vertices.push_back({second.start, second.bulge, source});
    for (std::size_t i = 1; i <= loop.vertices.size(); ++i) {
        result.vertices.push_back(loop.vertices[(position.edge + i) % loop.vertices.size()]);
    }
    result.vertices.back().bulge = sub_edge(edge, 0, position.share).bulge;
    return result;
}

class LeadFinder {
  public:
    LeadFinder(const Layout& layout, double kerf_mm, double radius_mm)
        : kerf_mm_(kerf_mm),
          min_distance_mm_(kerf_mm / 2 - kClearTolerance_mm),
          leads_(std::max(2 * kerf_mm, radius_mm / 8)) {
        for (const Outline& outline : layout.outlines) parts_.add(outline.contour);
        for (const Loop& loop : layout.loops) loops_.add(loop.contour);
        parts_.build();
        loops_.build();
    }

    /// Returns leads that keep a kerf away from those before, otherwise any; none if the space is too small.
    Cut find(const Loop& loop, double radius_mm) {
        std::optional<Cut> cut = find(loop, radius_mm, true);
        if (!cut) cut = find(loop, radius_mm, false);
        if (!cut)
            return {
                with_start_at(loop.contour, entry_candidates(loop.contour).front()), {}, {}, loop.outline};
        leads_.add(*cut->lead_in);
        leads_.add(*cut->lead_out);
        return *std::move(cut);
    }

  private:
    std::optional<Cut> find(const Loop& loop, double radius_mm, bool separate_leads) const {
        const std::vector<ContourPosition> candidates = entry_candidates(loop.contour);
        double radius = radius_mm;
        for (int size = 0; size < kLeadSizeCount && radius >= kMinLeadRadius_mm; ++size, radius /= 2) {
            for (const ContourPosition& position : candidates) {
                const Edge edge = loop.contour.edge(position.edge);
                const Point entry = point_at(edge, position.share);
                const Leads leads =
                    quarter_circle_leads(entry, end_tangent(sub_edge(edge, 0, position.share)), radius);
                if (!is_clear(leads.in, entry, radius) || !is_clear(leads.out, entry, radius)) continue;
                if (loops_.is_near(leads.in.start, radius / 2))
                    continue;  // the pierce is wider than the kerf
                if (separate_leads &&
                    (leads_.is_near(leads.in, kerf_mm_) || leads_.is_near(leads.out, kerf_mm_))) {
                    continue;  // the jet would run out of its cut into another one
                }
                return Cut{with_start_at(loop.contour, position), leads.in, leads.out, loop.outline};
            }
        }
        return {};
    }

    bool is_clear(const Edge& lead, Point entry, double radius) const {
        for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            if (parts_.is_near(point_at(lead, share), min_distance_mm_)) return false;
        }
        if (parts_.is_met(lead, entry, 0)) return false;
        // Rounding may create other common points near the contact of the lead and the loop.
        return !loops_.is_met(lead, entry, std::max(1e-3, 0.02 * radius));
    }

    double kerf_mm_, min_distance_mm_;
    EdgeIndex parts_, loops_;
    LeadGrid leads_;
};

}  // namespace

std::vector<Cut> add_leads(const Layout& layout, double kerf_mm, double radius_mm) {
    LeadFinder finder(layout, kerf_mm, radius_mm);
    std::vector<Cut> cuts;
    cuts.reserve(layout.loops.size());
    for (const Loop& loop : layout.loops) cuts.push_back(finder.find(loop, radius_mm));
    return cuts;
}

}  // namespace gsim::cutting
