#include "cam/solid/occ/edge_choice.h"

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

bool lies_within(const std::vector<TopoDS_Edge>& edges, const std::array<double, 6>& box_mm) {
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

bool EdgeChoice::is_asked_for(const std::string& label) const {
    return std::any_of(numbers_.begin(), numbers_.end(),
                       [&](const std::string& number) { return is_number(label, number); });
}

std::vector<TopoDS_Edge> EdgeChoice::find_in(const TopoDS_Shape& body) {
    std::vector<TopoDS_Edge> edges;
    if (takes_any()) return edges;
    TopTools_IndexedMapOfShape all;
    TopExp::MapShapes(body, TopAbs_EDGE, all);
    for (int i = 1; i <= all.Extent(); ++i) {
        const std::string label = file_.label(all.FindKey(i));
        if (!is_asked_for(label)) continue;
        indices_.Bind(all.FindKey(i), static_cast<int>(found_.size()));
        found_.push_back({.label = label});
        edges.push_back(TopoDS::Edge(all.FindKey(i)));
    }
    return edges;
}

bool EdgeChoice::takes(const std::vector<TopoDS_Edge>& edges) const {
    return takes_any() || std::any_of(edges.begin(), edges.end(),
                                      [this](const TopoDS_Edge& edge) { return indices_.IsBound(edge); });
}

void EdgeChoice::mark_cut(const std::vector<TopoDS_Edge>& edges) {
    for (const TopoDS_Edge& edge : edges) {
        if (const int* index = indices_.Seek(edge)) found_[static_cast<std::size_t>(*index)].is_cut = true;
    }
}

void EdgeChoice::mark_refused(const std::vector<TopoDS_Edge>& edges, const std::string& why) {
    for (const TopoDS_Edge& edge : edges) {
        if (const int* index = indices_.Seek(edge)) found_[static_cast<std::size_t>(*index)].refusal = why;
    }
}

std::optional<std::string> EdgeChoice::find_fault() const {
    for (const std::string& number : numbers_) {
        std::vector<Found> named;
        std::copy_if(found_.begin(), found_.end(), std::back_inserter(named),
                     [&](const Found& each) { return is_number(each.label, number); });
        if (named.empty()) return fmt::format("it has no edge with the number '{}'", number);
        if (std::any_of(named.begin(), named.end(), [](const Found& each) { return each.is_cut; })) continue;
        const std::string none = fmt::format("edge {} is of no contour that is chosen", named.front().label);
        const std::string& why = named.front().refusal;
        return why.empty() ? none : fmt::format("{}: {}", none, why);
    }
    return std::nullopt;
}

}  // namespace gsim::solid
