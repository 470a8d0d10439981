#include "cam/surface/bridges.h"

#include <algorithm>

#include "cam/surface/jet_path.h"

namespace gsim::surface {

namespace {

// A path by the distance along the edge.
class ArcLengthPath {
  public:
    explicit ArcLengthPath(const std::vector<JetPoint>& jet_path) : path_(jet_path), arc_lengths_mm_{0} {
        for (std::size_t i = 1; i < jet_path.size(); ++i)
            arc_lengths_mm_.push_back(arc_lengths_mm_.back() +
                                      (jet_path[i].edge_mm - jet_path[i - 1].edge_mm).norm());
    }

    double length_mm() const { return arc_lengths_mm_.back(); }

    std::vector<JetPoint> part(double from_mm, double to_mm) const {
        std::vector<JetPoint> points{at(from_mm)};
        for (std::size_t i = 0; i < path_.size(); ++i) {
            if (arc_lengths_mm_[i] > from_mm && arc_lengths_mm_[i] < to_mm) points.push_back(path_[i]);
        }
        points.push_back(at(to_mm));
        return points;
    }

  private:
    JetPoint at(double mm) const {
        if (mm <= 0) return path_.front();
        if (mm >= length_mm()) return path_.back();
        const auto next = std::upper_bound(arc_lengths_mm_.begin(), arc_lengths_mm_.end(), mm);
        const auto i = static_cast<std::size_t>(next - arc_lengths_mm_.begin());
        return between(path_[i - 1], path_[i],
                       (mm - arc_lengths_mm_[i - 1]) / (arc_lengths_mm_[i] - arc_lengths_mm_[i - 1]));
    }

    const std::vector<JetPoint>& path_;
    std::vector<double> arc_lengths_mm_;
};

}  // namespace

std::vector<std::vector<JetPoint>> split_at_bridges(const std::vector<JetPoint>& jet_path,
                                                    const Bridges& bridges, double kerf_mm) {
    if (bridges.count <= 0) return {jet_path};
    const ArcLengthPath measured(jet_path);
    const double gap_mm = bridges.width_mm + kerf_mm;
    const double step_mm = measured.length_mm() / bridges.count;
    if (step_mm < 2 * gap_mm) return {};
    std::vector<std::vector<JetPoint>> parts;
    double from_mm = 0;
    for (int i = 0; i < bridges.count; ++i) {
        const double middle_mm = (i + 0.5) * step_mm;
        parts.push_back(measured.part(from_mm, middle_mm - gap_mm / 2));
        from_mm = middle_mm + gap_mm / 2;
    }
    parts.push_back(measured.part(from_mm, measured.length_mm()));
    return parts;
}

}  // namespace gsim::surface
