#include "analysis/envelope/outline_files.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "analysis/envelope/region.h"
#include "base/text/format.h"
#include "base/text/number.h"

namespace gsim::envelope {

namespace {

constexpr double kPanelSize = 300;   // of the picture, in its units
constexpr double kPanelMargin = 40;  // about each panel, for its texts
constexpr int kColumns = 3;

std::string axes(const machine::Machine& machine, const PairOutline& outline) {
    return fmt::format("{} {}", machine.axes[static_cast<std::size_t>(outline.first)].letter,
                       machine.axes[static_cast<std::size_t>(outline.second)].letter);
}

// Rounds to 1e-6 mm, and never returns -0.
double rounded(double value) {
    return std::round(value * 1e6) / 1e6 + 0.0;
}

std::string direction_text(const Vector3d& direction) {
    Eigen::Index largest = 0;
    const double max = direction.cwiseAbs().maxCoeff(&largest);
    if (max < 1 - 1e-9) {
        return fmt::format("({} {} {})", text::fixed(direction.x(), 2), text::fixed(direction.y(), 2),
                           text::fixed(direction.z(), 2));
    }
    return {"XYZ"[largest]};
}

Eigen::AlignedBox2d bounds(const PairOutline& outline, const PlaneView& view) {
    Eigen::AlignedBox2d box;
    for (const Curve& curve : outline.curves) {
        for (const Vector3d& point : curve.points_mm)
            box.extend(Eigen::Vector2d(point.dot(view.right), point.dot(view.up)));
    }
    return box;
}

PlaneView best_view(const PairOutline& outline) {
    if (outline.flat) return plane_view(outline.normal);
    PlaneView widest = plane_view(Vector3d::UnitZ());
    for (const Vector3d& normal : {Vector3d(Vector3d::UnitY()), Vector3d(Vector3d::UnitX())}) {
        const PlaneView view = plane_view(normal);
        if (bounds(outline, view).volume() > bounds(outline, widest).volume()) widest = view;
    }
    return widest;
}

void append_panel(std::string& svg, const std::string& title, const PairOutline& outline, double left,
                  double top) {
    const PlaneView view = best_view(outline);
    const Eigen::AlignedBox2d box = bounds(outline, view);
    text::append_format(svg, "<text x=\"{}\" y=\"{}\">{}: {} to the right, {} up{}</text>\n", left, top - 8,
                        title, direction_text(view.right), direction_text(view.up),
                        outline.flat ? "" : ", a curved surface");
    if (outline.curves.empty()) {
        text::append_format(svg, "<text x=\"{}\" y=\"{}\">closed surface, without a border</text>\n", left,
                            top + 12);
        return;
    }
    const double size_mm = std::max(box.sizes().maxCoeff(), 1e-6);
    const double scale = kPanelSize / size_mm;
    // Writes all in one path, so that holes are not filled.
    svg += outline.flat ? "<path d=\"" : "<path class=\"open\" d=\"";
    for (const Curve& curve : outline.curves) {
        char command = 'M';
        for (const Vector3d& point : curve.points_mm) {
            text::append_format(svg, "{}{} {}", command,
                                text::fixed(left + (point.dot(view.right) - box.min().x()) * scale, 2),
                                text::fixed(top + (box.max().y() - point.dot(view.up)) * scale, 2));
            command = 'L';
        }
        if (curve.closed) svg += 'Z';
    }
    svg += "\"/>\n";
    text::append_format(svg, "<text x=\"{}\" y=\"{}\">{} .. {} mm, {} .. {} mm</text>\n", left,
                        top + kPanelSize + 16, text::fixed(box.min().x(), 1), text::fixed(box.max().x(), 1),
                        text::fixed(box.min().y(), 1), text::fixed(box.max().y(), 1));
}

}  // namespace

std::string to_csv(const machine::Machine& machine, const std::vector<PairOutline>& outlines) {
    std::string csv = "axes,kind,curve,closed,x_mm,y_mm,z_mm\n";
    for (const PairOutline& outline : outlines) {
        int number = 0;
        for (const Curve& curve : outline.curves) {
            ++number;
            for (const Vector3d& point : curve.points_mm) {
                text::append_format(csv, "{},{},{},{},{},{},{}\n", axes(machine, outline),
                                    outline.flat ? "plane" : "surface", number, curve.closed ? 1 : 0,
                                    rounded(point.x()), rounded(point.y()), rounded(point.z()));
            }
        }
    }
    return csv;
}

std::string to_svg(const machine::Machine& machine, const std::vector<PairOutline>& outlines) {
    const auto count = static_cast<int>(outlines.size());
    const int columns = std::clamp(count, 1, kColumns);
    const int rows = std::max(1, (count + kColumns - 1) / kColumns);
    constexpr double kPanelPitch = kPanelSize + 2 * kPanelMargin;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
        "<style>path{{fill:#cfe3f5;fill-rule:evenodd;stroke:#1f4e79;stroke-width:1.2}}.open{{fill:none}}"
        "text{{font:12px sans-serif}}</style>\n",
        columns * kPanelPitch, rows * kPanelPitch);
    int panel = 0;
    for (const PairOutline& outline : outlines) {
        const int column = panel % kColumns;
        const int row = panel / kColumns;
        append_panel(svg, axes(machine, outline), outline, kPanelMargin + column * kPanelPitch,
                     kPanelMargin + row * kPanelPitch);
        ++panel;
    }
    return svg + "</svg>\n";
}

}  // namespace gsim::envelope
