#include "cam/solid/occ/edge_selection.h"

#include <BRepAdaptor_Curve.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>

#include <fmt/format.h>

namespace gsim::solid {

namespace {

// Returns true for "#95" as in messages, or 95.
bool is_number(const std::string& label, const std::string& number) {
    return !label.empty() && (label == number || label.substr(1) == number);
}

}  // namespace

bool is_within_box(const std::vector<TopoDS_Edge>& edges, const std::array<double, 6>& box_mm) {
    for (const TopoDS_Edge& edge : edges) {
        const BRepAdaptor_Curve curve(edge);
        const double from = curve.FirstParameter();
        const double to = curve.LastParameter();
        for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const gp_Pnt at = curve.Value(from + share * (to - from));
            for (int axis = 1; axis <= 3; ++axis) {
                const auto i = static_cast<std::size_t>(axis - 1);
                if (at.Coord(axis) < box_mm[i] || at.Coord(axis) > box_mm[i + 3]) return false;
            }
        }
    }
    return true;
}

bool EdgeSelection::is_requested(const std::string& label) const {
    return std::any_of(numbers_.begin(), numbers_.end(),
                       [&](const std::string& number) { return is_number(label, number); });
}

std::vector<TopoDS_Edge> EdgeSelection::find_edges_in(const TopoDS_Shape& body) {
    std::vector<TopoDS_Edge> edges;
    if (accepts_any()) return edges;
    TopTools_IndexedMapOfShape all;
    TopExp::MapShapes(body, TopAbs_EDGE, all);
    for (int i = 1; i <= all.Extent(); ++i) {
        const std::string label = file_.label(all.FindKey(i));
        if (!is_requested(label)) continue;
        indices_.Bind(all.FindKey(i), static_cast<int>(found_.size()));
        found_.push_back({.label = label});
        edges.push_back(TopoDS::Edge(all.FindKey(i)));
    }
    return edges;
}

bool EdgeSelection::accepts(const std::vector<TopoDS_Edge>& edges) const {
    return accepts_any() || std::any_of(edges.begin(), edges.end(),
                                        [this](const TopoDS_Edge& edge) { return indices_.IsBound(edge); });
}

void EdgeSelection::mark_cut(const std::vector<TopoDS_Edge>& edges) {
    for (const TopoDS_Edge& edge : edges) {
        if (const int* index = indices_.Seek(edge)) found_[static_cast<std::size_t>(*index)].is_cut = true;
    }
}

void EdgeSelection::mark_rejected(const std::vector<TopoDS_Edge>& edges, const std::string& reason) {
    for (const TopoDS_Edge& edge : edges) {
        if (const int* index = indices_.Seek(edge)) found_[static_cast<std::size_t>(*index)].error = reason;
    }
}

std::optional<Error> EdgeSelection::find_error() const {
    for (const std::string& number : numbers_) {
        std::vector<EdgeMatch> named;
        std::copy_if(found_.begin(), found_.end(), std::back_inserter(named),
                     [&](const EdgeMatch& each) { return is_number(each.label, number); });
        if (named.empty()) return fmt::format("it has no edge with the number '{}'", number);
        if (std::any_of(named.begin(), named.end(), [](const EdgeMatch& each) { return each.is_cut; }))
            continue;
        const std::string none =
            fmt::format("edge {} does not belong to a selected contour", named.front().label);
        const std::string& reason = named.front().error;
        return reason.empty() ? none : fmt::format("{}: {}", none, reason);
    }
    return std::nullopt;
}

}  // namespace gsim::solid
