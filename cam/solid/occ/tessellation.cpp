#include "cam/solid/occ/tessellation.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace gsim::solid {

namespace {

constexpr double kMaxAngularDeflection_rad = 0.5;  // between neighbours: small round faces keep their form

// A builder that joins the triangles of faces; vertices of an edge are the same in both adjacent faces.
class MeshBuilder {
  public:
    Result<void> add(const TopoDS_Face& face) {
        TopLoc_Location position;
        const Handle(Poly_Triangulation) part = BRep_Tool::Triangulation(face, position);
        if (part.IsNull()) return Unexpected("one of its faces could not be triangulated");
        if (mesh_.triangles.size() + static_cast<std::size_t>(part->NbTriangles()) > kMaxTriangles)
            return Unexpected(fmt::format("more than {} triangles; a larger tolerance reduces their number",
                                          kMaxTriangles));
        const gp_Trsf& placed = position.Transformation();
        std::vector<std::uint32_t> numbers(static_cast<std::size_t>(part->NbNodes()));
        for (int i = 1; i <= part->NbNodes(); ++i)
            numbers[static_cast<std::size_t>(i - 1)] = vertex_index(part->Node(i).Transformed(placed));
        const bool reversed = (face.Orientation() == TopAbs_REVERSED) != placed.IsNegative();
        for (int i = 1; i <= part->NbTriangles(); ++i) {
            int a = 0, b = 0, c = 0;
            part->Triangle(i).Get(a, b, c);
            if (reversed) std::swap(b, c);
            const auto at = [&](int node) { return numbers[static_cast<std::size_t>(node - 1)]; };
            // An edge without a length, as at the apex of a cone, makes triangles without an area.
            if (at(a) != at(b) && at(b) != at(c) && at(c) != at(a))
                mesh_.triangles.push_back({at(a), at(b), at(c)});
        }
        return {};
    }

    Mesh mesh() && { return std::move(mesh_); }

  private:
    std::uint32_t vertex_index(const gp_Pnt& point) {
        const std::array<double, 3> at{point.X(), point.Y(), point.Z()};
        const auto [found, is_new] =
            numbers_.try_emplace(at, static_cast<std::uint32_t>(mesh_.vertices_mm.size()));
        if (is_new) mesh_.vertices_mm.push_back(at);
        return found->second;
    }

    Mesh mesh_;
    std::map<std::array<double, 3>, std::uint32_t> numbers_;
};

}  // namespace

Result<Mesh> tessellate(const TopoDS_Shape& shape, double tolerance_mm) {
    const BRepMesh_IncrementalMesh mesher(shape, tolerance_mm, false, kMaxAngularDeflection_rad, false);
    MeshBuilder builder;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        if (auto result = builder.add(TopoDS::Face(faces.Current())); !result)
            return Unexpected(result.error());
    }
    Mesh mesh = std::move(builder).mesh();
    for (const auto& vertex : mesh.vertices_mm) {
        if (!std::all_of(vertex.begin(), vertex.end(), [](double x) { return std::isfinite(x); }))
            return Unexpected("it has points at infinity");
    }
    if (mesh.triangles.empty()) return Unexpected("it contains no surface");
    return mesh;
}

}  // namespace gsim::solid
