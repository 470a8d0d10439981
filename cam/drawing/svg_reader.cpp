#include "cam/drawing/svg_reader.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "cam/drawing/pen.h"
#include "cam/drawing/svg_shapes.h"
#include "cam/drawing/svg_style.h"
#include "cam/drawing/svg_values.h"

namespace gsim::drawing {

using geometry::Point;

namespace {

constexpr int kMaxElementDepth = 100;
constexpr std::size_t kMaxElements = 1'000'000;  // counted as often as they are used

struct ViewBox {
    Point low, size;
};

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Throws Error, but only within this file.
class SvgReader {
  public:
    SvgReader(std::string_view text, const ReadOptions& options)
        : text_(text), options_(options), pen_(drawing_.drawn_contours, options.tolerance_mm) {}

    Drawing run() {
        const pugi::xml_parse_result parsed = document_.load_buffer(text_.data(), text_.size());
        if (!parsed)
            throw Error{fmt::format("line {}: this is not valid XML: {}", line_at(parsed.offset),
                                    parsed.description())};
        const pugi::xml_node root = document_.document_element();
        if (local_name(root) != "svg") {
            throw Error{fmt::format("line 1: the document must be an SVG drawing, not <{}>", root.name())};
        }
        collect_ids_and_styles();
        viewport_ = inside(root, {length_or_zero(root, "width"), length_or_zero(root, "height")});
        read_children(root, page(root), 0);
        for (const auto& [name, count] : skipped_) {
            drawing_.notes.push_back(fmt::format("not cut: {} {}", count, name));
        }
        for (const std::string& selector : styles_.unsupported_selectors()) {
            drawing_.notes.push_back(fmt::format(
                "the selector '{}' of the style sheet is not supported: elements that it hides are cut",
                selector));
        }
        return std::move(drawing_);
    }

  private:
    std::size_t line_at(std::ptrdiff_t offset) const {
        const auto end = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, offset));
        // Elements come in order, so no line is counted twice.
        if (end < counted_offset_) counted_offset_ = counted_lines_ = 0;
        const std::string_view part = text_.substr(0, end).substr(std::min(counted_offset_, end));
        counted_lines_ += static_cast<std::size_t>(std::count(part.begin(), part.end(), '\n'));
        counted_offset_ = std::min(end, text_.size());
        return counted_lines_ + 1;
    }

    [[noreturn]] void fail(const pugi::xml_node& node, const std::string& message) const {
        const std::string_view id = node.attribute("id").value();
        throw Error{fmt::format("line {}: {}{}{} {}", line_at(node.offset_debug()), node.name(),
                                id.empty() ? "" : " ", id, message)};
    }

    void collect_ids_and_styles() {
        struct Walker : pugi::xml_tree_walker {
            SvgReader& reader;
            explicit Walker(SvgReader& of) : reader(of) {}
            bool for_each(pugi::xml_node& node) override {
                if (const pugi::xml_attribute id = node.attribute("id")) {
                    reader.ids_.emplace(id.value(), node);
                }
                if (local_name(node) == "style") {
                    for (const pugi::xml_node& text : node.children()) reader.styles_.add(text.value());
                }
                return true;
            }
        };
        Walker walker(*this);
        document_.traverse(walker);
    }

    std::optional<ViewBox> view_box(const pugi::xml_node& node) const {
        const pugi::xml_attribute attribute = node.attribute("viewBox");
        if (!attribute) return {};
        SvgScanner scanner(attribute.value());
        std::array<double, 4> values{};
        for (double& value : values) {
            const std::optional<double> number = scanner.number();
            if (!number)
                fail(node, fmt::format("has viewBox=\"{}\"; it must have four numbers", attribute.value()));
            value = *number;
        }
        if (!(values[2] > 0 && values[3] > 0)) fail(node, "has a viewBox without a size");
        return ViewBox{{values[0], values[1]}, {values[2], values[3]}};
    }

    // Returns the map from the units of the outermost element to mm, y upwards.
    Affine page(const pugi::xml_node& root) const {
        const std::optional<ViewBox> box = view_box(root);
        const double unit = options_.unit_mm > 0 ? options_.unit_mm : kMmPerPx;
        const std::optional<double> width = svg_length_px(root.attribute("width").value());
        const std::optional<double> height = svg_length_px(root.attribute("height").value());
        if (!box) return Affine{{unit, 0}, {0, -unit}, {0, height.value_or(0) * unit}};
        Affine map = moved(-1.0 * box->low);
        Point scale{unit, unit};
        if (options_.unit_mm <= 0 && (width || height)) {
            const double x = width.value_or(HUGE_VAL) / box->size.x;
            const double y = height.value_or(HUGE_VAL) / box->size.y;
            scale = kMmPerPx * aspect_scale(root, std::min(x, width ? x : y), std::min(y, height ? y : x));
        }
        if (!(scale.x > 0 && scale.y > 0)) fail(root, "has a page without a size");
        return moved({0, box->size.y * scale.y}) * scaled(scale.x, -scale.y) * map;
    }

    // A drawing keeps its aspect ratio on a page of another shape unless the file says otherwise.
    static Point aspect_scale(const pugi::xml_node& node, double x, double y) {
        const std::string_view how = node.attribute("preserveAspectRatio").value();
        if (how.starts_with("none")) return {x, y};
        const double uniform_scale = std::min(x, y);
        return {uniform_scale, uniform_scale};
    }

    void read_children(const pugi::xml_node& node, const Affine& map, int depth) {
        if (depth > kMaxElementDepth)
            fail(node, fmt::format("is nested deeper than {} elements", kMaxElementDepth));
        for (const pugi::xml_node& child : node.children()) {
            if (child.type() == pugi::node_element) read_node(child, map, depth);
        }
    }

    void read_node(const pugi::xml_node& node, const Affine& map, int depth) {
        if (++elements_ > kMaxElements)
            fail(node, fmt::format("exceeds the limit of {} elements", kMaxElements));
        const std::string_view name = local_name(node);
        if (styles_.property(node, "display") == "none") return;
        const bool was_hidden = is_hidden_;
        const std::string_view visibility = styles_.property(node, "visibility");
        if (!visibility.empty() && visibility != "inherit") is_hidden_ = visibility != "visible";
        read_visible(node, name, map * local_transform(node), depth);
        is_hidden_ = was_hidden;
    }

    // A hidden element may contain visible ones.
    void read_visible(const pugi::xml_node& node, std::string_view name, const Affine& local, int depth) {
        if (is_one_of(name, {"g", "a", "switch"})) {
            read_children(node, local, depth + 1);
        } else if (name == "svg") {
            read_viewport(node, node, local * moved({length(node, "x"), length(node, "y")}), depth);
        } else if (name == "use") {
            read_use(node, local, depth);
        } else if (is_hidden_) {
            return;
        } else if (is_svg_shape(name)) {
            draw(node, local);
        } else if (is_one_of(name, {"text", "image", "flowRoot", "foreignObject"})) {
            ++skipped_[std::string(name)];
        }
    }

    Affine local_transform(const pugi::xml_node& node) const {
        const pugi::xml_attribute attribute = node.attribute("transform");
        if (!attribute) return {};
        const std::optional<Affine> map = svg_transform(attribute.value());
        if (!map)
            fail(node, fmt::format("has transform=\"{:.60}\", which cannot be read", attribute.value()));
        return *map;
    }

    double length(const pugi::xml_node& node, const char* name) const {
        const std::optional<double> value = length_attribute_px(node, name, 0);
        if (!value)
            fail(node,
                 fmt::format("has {}=\"{:.60}\", which is not a length", name, node.attribute(name).value()));
        return *value;
    }

    static double length_or_zero(const pugi::xml_node& node, const char* name) {
        return svg_length_px(node.attribute(name).value()).value_or(0);
    }

    // Returns a side of an element within the drawing: that of the `use` element, else its own, else the full
    // side of the surrounding element.
    double side(const pugi::xml_node& referencing_node, const pugi::xml_node& node, const char* name,
                double parent_size) const {
        for (const pugi::xml_node* says : {&referencing_node, &node}) {
            const std::string_view text = says->attribute(name).value();
            if (!text.empty() && text != "auto") return text == "100%" ? parent_size : length(*says, name);
        }
        return parent_size;
    }

    // Returns the size that counts as 100 % of width and height inside a node.
    Point inside(const pugi::xml_node& node, Point size) const {
        const std::optional<ViewBox> box = view_box(node);
        return box ? box->size : size;
    }

    // Reads an svg or symbol within the drawing. It keeps its size if the size of the page is not given.
    void read_viewport(const pugi::xml_node& node, const pugi::xml_node& referencing_node, const Affine& map,
                       int depth) {
        const std::optional<ViewBox> box = view_box(node);
        const Point parent_size = viewport_;
        const Point local = box ? box->size : Point{};
        const Point size{side(referencing_node, node, "width", parent_size.x > 0 ? parent_size.x : local.x),
                         side(referencing_node, node, "height", parent_size.y > 0 ? parent_size.y : local.y)};
        viewport_ = inside(node, size);
        read_children(node, box ? map * viewport_transform(node, *box, size) : map, depth + 1);
        viewport_ = parent_size;
    }

    // Returns the map from a view box to its size on the page.
    static Affine viewport_transform(const pugi::xml_node& node, const ViewBox& box, Point size) {
        const Point scale = aspect_scale(node, size.x / box.size.x, size.y / box.size.y);
        const Point margin{(size.x - scale.x * box.size.x) / 2, (size.y - scale.y * box.size.y) / 2};
        return moved(margin) * scaled(scale.x, scale.y) * moved(-1.0 * box.low);
    }

    void read_use(const pugi::xml_node& node, const Affine& map, int depth) {
        if (depth > kMaxElementDepth)
            fail(node, fmt::format("is nested deeper than {} elements", kMaxElementDepth));
        std::string_view target = node.attribute("href").value();
        if (target.empty()) target = node.attribute("xlink:href").value();
        const auto found = target.starts_with('#') ? ids_.find(target.substr(1)) : ids_.end();
        if (found == ids_.end()) fail(node, fmt::format("uses '{:.60}', which is not in the file", target));
        const Affine use_map = map * moved({length(node, "x"), length(node, "y")});
        if (local_name(found->second) == "symbol")
            return read_viewport(found->second, node, use_map, depth + 1);
        read_referenced_node(found->second, use_map, depth + 1);
    }

    void read_referenced_node(const pugi::xml_node& node, const Affine& map, int depth) {
        if (depth > kMaxElementDepth)
            fail(node, fmt::format("is nested deeper than {} elements", kMaxElementDepth));
        read_node(node, map, depth);
    }

    void draw(const pugi::xml_node& node, const Affine& map) {
        drawing_.entities.push_back(
            {std::string(local_name(node)), node.attribute("id").value(), line_at(node.offset_debug())});
        pen_.set_map(map, static_cast<std::uint32_t>(drawing_.entities.size() - 1));
        const std::size_t before = drawing_.drawn_contours.size();
        if (const auto drawn = draw_svg_shape(node, pen_); !drawn) fail(node, drawn.error().message);
        if (drawing_.drawn_contours.size() == before) fail(node, "has no length");
    }

    std::string_view text_;
    const ReadOptions& options_;
    Drawing drawing_;
    Pen pen_;
    pugi::xml_document document_;
    std::map<std::string, pugi::xml_node, std::less<>> ids_;
    std::map<std::string, std::size_t> skipped_;
    SvgStyles styles_;
    Point viewport_;  // in units at the position of an element; 0: unknown
    bool is_hidden_ = false;
    std::size_t elements_ = 0;
    mutable std::size_t counted_offset_ = 0;
    mutable std::size_t counted_lines_ = 0;
};

}  // namespace

Result<Drawing> read_svg(std::string_view text, const ReadOptions& options) {
    try {
        return SvgReader(text, options).run();
    } catch (const Error& error) {
        return tl::unexpected(error.message);
    }
}

}  // namespace gsim::drawing
