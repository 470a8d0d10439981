#include "cam/surface/bridges.h"

#include <algorithm>

#include "cam/surface/jet_way.h"

namespace gsim::surface {

namespace {

// A path by the distance along the edge.
class Measured {
  public:
    explicit Measured(const std::vector<JetPoint>& way) : way_(way), at_mm_{0} {
        for (std::size_t i = 1; i < way.size(); ++i)
            at_mm_.push_back(at_mm_.back() + (way[i].edge_mm - way[i - 1].edge_mm).norm());
    }

    double length_mm() const { return at_mm_.back(); }

    std::vector<JetPoint> part(double from_mm, double to_mm) const {
        std::vector<JetPoint> points{at(from_mm)};
        for (std::size_t i = 0; i < way_.size(); ++i) {
            if (at_mm_[i] > from_mm && at_mm_[i] < to_mm) points.push_back(way_[i]);
        }
        points.push_back(at(to_mm));
        return points;
    }

  private:
    JetPoint at(double mm) const {
        if (mm <= 0) return way_.front();
        if (mm >= length_mm()) return way_.back();
        const auto next = std::upper_bound(at_mm_.begin(), at_mm_.end(), mm);
        const auto i = static_cast<std::size_t>(next - at_mm_.begin());
        return between(way_[i - 1], way_[i], (mm - at_mm_[i - 1]) / (at_mm_[i] - at_mm_[i - 1]));
    }

    const std::vector<JetPoint>& way_;
    std::vector<double> at_mm_;
};

}  // namespace

std::vector<std::vector<JetPoint>> pieces_between(const std::vector<JetPoint>& way, const Bridges& bridges,
                                                  double kerf_mm) {
    if (bridges.count <= 0) return {way};
    const Measured measured(way);
    const double gap_mm = bridges.width_mm + kerf_mm;
    const double step_mm = measured.length_mm() / bridges.count;
    if (step_mm < 2 * gap_mm) return {};
    std::vector<std::vector<JetPoint>> pieces;
    double from_mm = 0;
    for (int i = 0; i < bridges.count; ++i) {
        const double middle_mm = (i + 0.5) * step_mm;
        pieces.push_back(measured.part(from_mm, middle_mm - gap_mm / 2));
        from_mm = middle_mm + gap_mm / 2;
    }
    pieces.push_back(measured.part(from_mm, measured.length_mm()));
    return pieces;
}

}  // namespace gsim::surface
