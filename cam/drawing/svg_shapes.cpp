#include "cam/drawing/svg_shapes.h"

#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "cam/drawing/svg_path.h"
#include "cam/drawing/svg_style.h"
#include "cam/drawing/svg_values.h"

namespace gsim::drawing {

using geometry::Point;

namespace {

// Lengths of an element, with the first one that cannot be read.
class LengthReader {
  public:
    explicit LengthReader(const pugi::xml_node& node) : node_(node) {}

    double operator()(const char* name, double fallback = 0) {
        const std::optional<double> value = length_attribute_px(node_, name, fallback);
        if (!value && !error_) {
            error_ = fmt::format("has {}=\"{}\", which is not a length in px, mm, cm, in, pt or pc", name,
                                 node_.attribute(name).value());
        }
        return value.value_or(fallback);
    }
    const std::optional<Error>& error() const { return error_; }

  private:
    const pugi::xml_node& node_;
    std::optional<Error> error_;
};

Result<void> draw_path(const pugi::xml_node& node, Pen& pen) {
    return draw_path_data(node.attribute("d").value(), pen);
}

Result<void> draw_rect(const pugi::xml_node& node, Pen& pen) {
    LengthReader lengths(node);
    const Point low{lengths("x"), lengths("y")};
    const Point size{lengths("width"), lengths("height")};
    const bool has_rx = node.attribute("rx");
    const bool has_ry = node.attribute("ry");
    double rx = lengths(has_rx ? "rx" : "ry");
    double ry = lengths(has_ry ? "ry" : "rx");
    if (lengths.error()) return tl::unexpected(*lengths.error());
    if (!(size.x > 0 && size.y > 0))
        return Unexpected(fmt::format("has the size {} x {}; both must be greater than 0", size.x, size.y));
    rx = std::clamp(rx, 0.0, size.x / 2);
    ry = std::clamp(ry, 0.0, size.y / 2);
    const bool rounded = rx > 0 && ry > 0;
    if (!rounded) rx = ry = 0;
    const Point high = low + size;
    const auto corner = [&](Point center, double from_rad) {
        if (rounded) pen.arc({center, {rx, 0}, {0, ry}, from_rad, std::numbers::pi / 2});
    };
    pen.move_to({low.x + rx, low.y});
    pen.line_to({high.x - rx, low.y});
    corner({high.x - rx, low.y + ry}, -std::numbers::pi / 2);
    pen.line_to({high.x, high.y - ry});
    corner({high.x - rx, high.y - ry}, 0);
    pen.line_to({low.x + rx, high.y});
    corner({low.x + rx, high.y - ry}, std::numbers::pi / 2);
    pen.line_to({low.x, low.y + ry});
    corner({low.x + rx, low.y + ry}, std::numbers::pi);
    pen.close();
    return {};
}

Result<void> draw_ellipse_element(const pugi::xml_node& node, Pen& pen) {
    LengthReader lengths(node);
    const bool circle = local_name(node) == "circle";
    const Point center{lengths("cx"), lengths("cy")};
    const double rx = lengths(circle ? "r" : "rx");
    const double ry = lengths(circle ? "r" : "ry");
    if (lengths.error()) return tl::unexpected(*lengths.error());
    if (!(rx > 0 && ry > 0))
        return Unexpected(fmt::format("has the radii {} and {}; both must be greater than 0", rx, ry));
    pen.arc({center, {rx, 0}, {0, ry}, 0, 2 * std::numbers::pi});
    return {};
}

Result<void> draw_line_element(const pugi::xml_node& node, Pen& pen) {
    LengthReader lengths(node);
    const Point from{lengths("x1"), lengths("y1")};
    const Point to{lengths("x2"), lengths("y2")};
    if (lengths.error()) return tl::unexpected(*lengths.error());
    if (from == to) return Unexpected(fmt::format("at ({}, {}) has no length", from.x, from.y));
    pen.move_to(from);
    pen.line_to(to);
    return {};
}

Result<void> draw_points(const pugi::xml_node& node, Pen& pen) {
    SvgScanner scanner(node.attribute("points").value());
    std::size_t count = 0;
    while (!scanner.at_end()) {
        const std::optional<double> x = scanner.number();
        const std::optional<double> y = scanner.number();
        if (!x || !y)
            return Unexpected(
                fmt::format("has points that cannot be read at character {}", scanner.offset() + 1));
        if (count++ == 0) {
            pen.move_to({*x, *y});
        } else {
            pen.line_to({*x, *y});
        }
    }
    if (count < 2) return Unexpected(fmt::format("has {} points; at least 2 are required", count));
    if (local_name(node) == "polygon") pen.close();
    return {};
}

struct SvgShape {
    std::string_view name;
    Result<void> (*draw)(const pugi::xml_node&, Pen&);
};

constexpr std::array<SvgShape, 7> kSvgShapes{{{"path", draw_path},
                                              {"rect", draw_rect},
                                              {"circle", draw_ellipse_element},
                                              {"ellipse", draw_ellipse_element},
                                              {"line", draw_line_element},
                                              {"polyline", draw_points},
                                              {"polygon", draw_points}}};

const SvgShape* find_svg_shape(std::string_view name) {
    const auto* const found = std::find_if(kSvgShapes.begin(), kSvgShapes.end(),
                                           [&](const SvgShape& shape) { return shape.name == name; });
    return found == kSvgShapes.end() ? nullptr : found;
}

}  // namespace

bool is_svg_shape(std::string_view name) {
    return find_svg_shape(name) != nullptr;
}

Result<void> draw_svg_shape(const pugi::xml_node& node, Pen& pen) {
    Result<void> drawn = find_svg_shape(local_name(node))->draw(node, pen);
    if (drawn && pen.error()) drawn = tl::unexpected(*pen.error());
    pen.lift();
    return drawn;
}

std::optional<double> length_attribute_px(const pugi::xml_node& node, const char* name, double fallback) {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute) return fallback;
    return svg_length_px(attribute.value());
}

}  // namespace gsim::drawing
