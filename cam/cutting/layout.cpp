#include "cam/cutting/layout.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text/number.h"
#include "geometry/planar/chain.h"
#include "geometry/planar/crossing.h"
#include "geometry/planar/nesting.h"
#include "geometry/planar/offset.h"

namespace gsim::cutting {

using drawing::Drawing;
using geometry::Contour;
using geometry::Crossing;
using geometry::Point;

namespace {

constexpr std::size_t kMaxListedErrors = 5;
constexpr double kMinArea_mm2 = 1e-6;

std::string location(Point point) {
    return fmt::format("({:.6g}, {:.6g})", text::unsigned_zero(point.x), text::unsigned_zero(point.y));
}

std::string edge_label(const Drawing& drawing, const Contour& contour, std::size_t edge) {
    return display_text(drawing.entities[contour.vertices[edge].source]);
}

std::string open_ends_message(const Drawing& drawing, const std::vector<Contour>& open, double gap_mm) {
    std::string text =
        fmt::format("{} not closed within {} mm:",
                    open.size() == 1 ? "a contour is" : fmt::format("{} contours are", open.size()), gap_mm);
    for (std::size_t i = 0; i < std::min(open.size(), kMaxListedErrors); ++i) {
        const Contour& contour = open[i];
        const std::size_t last = contour.vertices.size() - 2;
        const Point from = contour.vertices.front().position;
        const Point to = contour.vertices.back().position;
        text += fmt::format("\n  from {} ({}) to {} ({}), {:.4g} mm apart", location(from),
                            edge_label(drawing, contour, 0), location(to), edge_label(drawing, contour, last),
                            distance(from, to));
    }
    if (open.size() > kMaxListedErrors) text += "\n  ...";
    return text;
}

class LayoutBuilder {
  public:
    LayoutBuilder(Drawing drawing, const LayoutOptions& options)
        : drawing_(std::move(drawing)), options_(options) {}

    Result<Layout> run() {
        for (const auto step : {&LayoutBuilder::close, &LayoutBuilder::check,
                                &LayoutBuilder::find_outline_nesting, &LayoutBuilder::offset_outlines}) {
            if (auto done = (this->*step)(); !done) return Unexpected(std::move(done.error()));
        }
        layout_.notes = std::move(drawing_.notes);
        layout_.notes.insert(layout_.notes.end(), notes_.begin(), notes_.end());
        return std::move(layout_);
    }

  private:
    Result<void> close() {
        geometry::ChainResult chains = geometry::chain(std::move(drawing_.drawn_contours), options_.gap_mm);
        if (chains.is_ambiguous)
            return Unexpected("too many lines end at one position: no contour can be identified");
        if (!chains.open.empty())
            return Unexpected(open_ends_message(drawing_, chains.open, options_.gap_mm));
        contours_ = std::move(chains.closed);
        if (contours_.empty()) return Unexpected("the drawing contains no contour");
        const auto is_empty = [](const Contour& contour) { return contour.vertices.empty(); };
        if (std::any_of(contours_.begin(), contours_.end(), is_empty)) {
            return Unexpected(fmt::format("a contour is smaller than {} mm", options_.gap_mm));
        }
        return {};
    }

    Result<void> check() {
        const std::optional<Crossing> crossing = geometry::find_crossing(contours_, options_.gap_mm / 10);
        if (crossing) {
            return Unexpected(
                fmt::format("{} and {} meet at {}; a contour must not cross or touch itself or another one",
                            edge_label(drawing_, contours_[crossing->contour_a], crossing->edge_a),
                            edge_label(drawing_, contours_[crossing->contour_b], crossing->edge_b),
                            location(crossing->location)));
        }
        for (const Contour& contour : contours_) {
            if (contour.vertices.size() > 1 && std::abs(area_mm2(contour)) > kMinArea_mm2) continue;
            return Unexpected(fmt::format("the contour at {} ({}) encloses no area",
                                          location(contour.vertices.front().position),
                                          edge_label(drawing_, contour, 0)));
        }
        return {};
    }

    Result<void> find_outline_nesting() {
        const std::vector<geometry::NestingLevel> nestings = geometry::find_nesting(contours_);
        layout_.outlines.reserve(contours_.size());
        for (std::size_t i = 0; i < contours_.size(); ++i) {
            Contour& contour = contours_[i];
            const bool outside = nestings[i].depth % 2 == 0;
            if ((area_mm2(contour) > 0) != outside) reverse(contour);
            layout_.outlines.push_back({std::move(contour), nestings[i].parent, nestings[i].depth});
        }
        return {};
    }

    Result<void> offset_outlines() {
        for (std::size_t i = 0; i < layout_.outlines.size(); ++i) {
            if (auto done = offset_outline(i); !done) return done;
        }
        std::vector<Contour> contours;
        std::vector<std::size_t> groups;
        contours.reserve(layout_.loops.size());
        groups.reserve(layout_.loops.size());
        for (const Loop& loop : layout_.loops) {
            contours.push_back(loop.contour);
            groups.push_back(loop.outline);
        }
        const std::optional<Crossing> crossing = geometry::find_crossing_between(contours, groups);
        if (!crossing) return {};
        return Unexpected(fmt::format("{} and {} are closer to each other than the kerf of {:.4g} mm at {}",
                                      edge_label(drawing_, contours[crossing->contour_a], crossing->edge_a),
                                      edge_label(drawing_, contours[crossing->contour_b], crossing->edge_b),
                                      options_.kerf_mm, location(crossing->location)));
    }

    Result<void> offset_outline(std::size_t outline) {
        const Contour& contour = layout_.outlines[outline].contour;
        auto loops = geometry::offset(contour, options_.kerf_mm / 2);
        const auto where = [&] {
            return fmt::format("the contour at {} ({})", location(contour.vertices.front().position),
                               edge_label(drawing_, contour, 0));
        };
        if (!loops)
            return Unexpected(fmt::format("{}: {} at {}", where(), loops.error().message,
                                          location(loops.error().location)));
        if (loops->empty())
            return Unexpected(
                fmt::format("{} is narrower than the kerf of {:.4g} mm", where(), options_.kerf_mm));
        if (loops->size() > 1) {
            notes_.push_back(
                fmt::format("{} has sections that are narrower than the kerf; it is cut in {} loops", where(),
                            loops->size()));
        }
        std::sort(loops->begin(), loops->end(), [](const Contour& a, const Contour& b) {
            return std::abs(area_mm2(a)) < std::abs(area_mm2(b));
        });
        for (Contour& loop : *loops) layout_.loops.push_back({std::move(loop), outline});
        return {};
    }

    Drawing drawing_;
    LayoutOptions options_;
    std::vector<Contour> contours_;
    std::vector<std::string> notes_;
    Layout layout_;
};

}  // namespace

Result<Layout> make_layout(Drawing drawing, const LayoutOptions& options) {
    return LayoutBuilder(std::move(drawing), options).run();
}

}  // namespace gsim::cutting
