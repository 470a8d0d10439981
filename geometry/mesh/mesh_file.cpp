#include "geometry/mesh/mesh_file.h"

#include <fmt/format.h>

#include "base/os/input_file.h"
#include "base/text/letter_case.h"
#include "geometry/mesh/mesh.h"
#include "geometry/mesh/mesh_text.h"

namespace gsim::cell {

namespace {

constexpr std::size_t kMaxBytes = std::size_t{512} << 20U;

bool is_obj(std::string_view file_name) {
    return text::lower(file_name).ends_with(".obj");
}

Result<TriangleSoup> read_triangles(std::string_view bytes, std::string_view file_name) {
    if (is_obj(file_name)) return read_obj(bytes);
    // Some binary files begin with "solid", too, so the size distinguishes them from text.
    if (is_stl_binary(bytes) || !bytes.starts_with("solid")) return read_stl_binary(bytes);
    return read_stl_text(bytes);
}

std::optional<Error> find_error(const TriangleSoup& soup) {
    if (soup.triangles.empty()) return "it contains no triangle";
    for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
        const double largest = soup.vertices[i].cwiseAbs().maxCoeff();
        if (largest <= kMaxLength_mm) continue;
        return fmt::format("vertex {} is at {:.6g} mm; coordinates must be within {:.0f} mm", i + 1, largest,
                           kMaxLength_mm);
    }
    return std::nullopt;
}

Result<std::shared_ptr<const TriangleMesh>> make_mesh(TriangleSoup soup, std::string_view file_name,
                                                      double scale) {
    for (Eigen::Vector3d& vertex : soup.vertices) vertex *= scale;
    if (const auto error = find_error(soup))
        return Unexpected(fmt::format("{}: {}", file_name, error->message));
    return std::make_shared<const TriangleMesh>(std::move(soup.vertices), soup.triangles);
}

TriangleSoup to_triangle_soup(const solid::Mesh& mesh) {
    TriangleSoup soup;
    soup.vertices.reserve(mesh.vertices_mm.size());
    for (const auto& [x, y, z] : mesh.vertices_mm) soup.vertices.emplace_back(x, y, z);
    soup.triangles = mesh.triangles;
    return soup;
}

}  // namespace

Result<std::shared_ptr<const TriangleMesh>> read_mesh(std::string_view bytes, std::string_view file_name,
                                                      double scale) {
    auto soup = read_triangles(bytes, file_name);
    if (!soup) return Unexpected(fmt::format("{}{}", file_name, soup.error().message));
    return make_mesh(*std::move(soup), file_name, scale);
}

Result<std::shared_ptr<const TriangleMesh>> load_mesh(const std::filesystem::path& path, double scale,
                                                      double tolerance_mm, const MeshFiles& files) {
    const std::string name = path.string();
    if (solid::is_solid_file(path)) {
        const auto mesh = files.read_solid(path, tolerance_mm);
        if (!mesh) return tl::unexpected(mesh.error());
        return make_mesh(to_triangle_soup(*mesh), name, scale);
    }
    const auto bytes = files.files.read(path, os::NameSource::in_file, kMaxBytes);
    if (!bytes) return tl::unexpected(bytes.error());
    return read_mesh(*bytes, name, scale);
}

}  // namespace gsim::cell
