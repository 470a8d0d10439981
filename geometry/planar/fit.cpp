#include "geometry/planar/fit.h"

namespace gsim::geometry {

namespace {

constexpr int kMaxDepth = 16;
constexpr int kProbeCount = 8;
constexpr int kInitialParts = 2;      // so that a curve that returns to itself is not taken for a line
constexpr double kMaxBulge = 0.4143;  // a little more than a quarter turn

struct Biarc {
    Edge first, second;
};

// Both arcs begin and end as far from the joint as the control polygon with equal legs allows.
Biarc biarc(const CurvePoint& a, const CurvePoint& b) {
    const Point v = b.position - a.position;
    const Point ta = unit(a.direction);
    const Point tb = unit(b.direction);
    const Point t = ta + tb;
    const double quadratic_term = 2 * (1 - dot(ta, tb));
    double leg = 0;
    if (quadratic_term > 1e-12) {
        leg = (-dot(v, t) + std::sqrt(dot(v, t) * dot(v, t) + quadratic_term * dot(v, v))) / quadratic_term;
    } else {
        const double projection = dot(v, tb);
        leg = projection > 0 ? dot(v, v) / (4 * projection) : length(v) / 2;
    }
    const Point joint = 0.5 * (a.position + b.position + leg * (ta - tb));
    const Edge back = arc_from_tangent(b.position, -1.0 * tb, joint);
    return {arc_from_tangent(a.position, ta, joint), reversed(back)};
}

class Fitter {
  public:
    Fitter(const Curve& curve, double tolerance_mm, std::uint32_t source, Contour& contour)
        : curve_(curve), tolerance_mm_(tolerance_mm), source_(source), contour_(contour) {}

    void fit(double from, double to, int depth) {
        const CurvePoint a = curve_(from);
        const CurvePoint b = curve_(to);
        if (distance(a.position, b.position) <= kPointTolerance_mm && depth > 2) return;
        const Biarc pair = biarc(a, b);
        if (depth < kMaxDepth && !is_close_enough(pair, from, to)) {
            const double middle = (from + to) / 2;
            fit(from, middle, depth + 1);
            fit(middle, to, depth + 1);
            return;
        }
        const bool straight = !is_arc(pair.first) && !is_arc(pair.second);
        if (depth == kMaxDepth || straight) {
            add({a.position, b.position, 0});
            return;
        }
        add(pair.first);
        add(pair.second);
    }

  private:
    bool is_close_enough(const Biarc& pair, double from, double to) const {
        if (std::abs(pair.first.bulge) > kMaxBulge || std::abs(pair.second.bulge) > kMaxBulge) return false;
        for (int i = 1; i < kProbeCount; ++i) {
            const Point probe = curve_(from + (to - from) * i / kProbeCount).position;
            const double deviation =
                std::min(distance_mm(pair.first, probe), distance_mm(pair.second, probe));
            if (!(deviation <= tolerance_mm_)) return false;
        }
        return true;
    }

    void add(Edge edge) {
        if (!contour_.vertices.empty()) edge.start = contour_.vertices.back().position;
        if (distance(edge.start, edge.end) > kPointTolerance_mm) append_edge(contour_, edge, source_);
    }

    const Curve& curve_;
    double tolerance_mm_;
    std::uint32_t source_;
    Contour& contour_;
};

}  // namespace

void fit_arcs(const Curve& curve, double from, double to, double tolerance_mm, std::uint32_t source,
              Contour& contour) {
    Fitter fitter(curve, tolerance_mm, source, contour);
    for (int i = 0; i < kInitialParts; ++i) {
        fitter.fit(from + (to - from) * i / kInitialParts, from + (to - from) * (i + 1) / kInitialParts, 0);
    }
}

}  // namespace gsim::geometry
