#include "machine/file/shape_section.h"

#include <array>
#include <system_error>

#include "base/text/printable.h"
#include "base/toml/toml_writer.h"
#include "geometry/mesh/mesh.h"

namespace gsim::machine {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;

using std::string_view_literals::operator""sv;

namespace {

constexpr std::array kFormKeys{"box_mm"sv, "cylinder_mm"sv, "sphere_mm"sv,   "capsule_mm"sv,
                               "mesh"sv,   "scale"sv,       "tolerance_mm"sv};
constexpr double kMaxLength_mm = 1e6;
constexpr double kMinTolerance_mm = 1e-3;
constexpr double kMaxTolerance_mm = 100;

/// Reads `count` lengths, each greater than 0; returns nothing if they are not.
std::optional<std::array<double, 3>> read_lengths(TomlSection& section, const toml::table& table,
                                                  std::string_view key, std::size_t count,
                                                  std::string_view meaning) {
    std::array<double, 3> lengths{};
    const toml::array* array = table.get_as<toml::array>(key);
    bool read = array != nullptr && array->size() == count;
    for (std::size_t i = 0; read && i < count; ++i) {
        const toml::node* node = array->get(i);
        const auto value = node->is_number() ? node->value<double>() : std::nullopt;
        read = value && *value > 0 && *value <= kMaxLength_mm;
        lengths[i] = value.value_or(0);
    }
    if (read) return lengths;
    section.fail(key, fmt::format("'{}' must be [{}], each greater than 0 and at most 1e6", key, meaning));
    return std::nullopt;
}

std::optional<ShapeForm> read_mesh_shape(TomlSection& section, const std::filesystem::path& folder,
                                         const os::Files& files) {
    const std::string name = section.text("mesh");
    const double scale = section.number("scale", 1, NumberRule::positive);
    if (name.empty() || !text::is_printable(name)) {
        section.fail("mesh", "'mesh' must name a file, without control characters");
        return std::nullopt;
    }
    const double tolerance_mm =
        section.number("tolerance_mm", solid::kMeshTolerance_mm, NumberRule::positive);
    if (section.has("tolerance_mm") && !solid::is_solid_file(name)) {
        section.fail("tolerance_mm",
                     "'tolerance_mm' is for STEP and IGES files; this mesh is made of triangles");
        return std::nullopt;
    }
    if (tolerance_mm < kMinTolerance_mm || tolerance_mm > kMaxTolerance_mm) {
        section.fail("tolerance_mm",
                     fmt::format("'tolerance_mm' must be from {} to {}", kMinTolerance_mm, kMaxTolerance_mm));
        return std::nullopt;
    }
    const std::filesystem::path path = folder / name;
    const std::optional<Error> error = files.find_error(path);
    if (!error) return MeshShape{path, scale, tolerance_mm};
    section.fail("mesh", fmt::format("{}: {}", path.string(), error->message));
    return std::nullopt;
}

std::optional<ShapeForm> read_round_shape(TomlSection& section, const toml::table& table,
                                          std::string_view key) {
    const auto lengths = read_lengths(section, table, key, 2, "diameter, height");
    if (!lengths) return std::nullopt;
    const auto [diameter, height, none] = *lengths;
    if (key == "cylinder_mm") return CylinderShape{diameter, height};
    return CapsuleShape{diameter, height};
}

std::optional<ShapeForm> read_box(TomlSection& section, const toml::table& table) {
    const auto size = read_lengths(section, table, "box_mm", 3, "x, y, z");
    if (!size) return std::nullopt;
    return BoxShape{(*size)[0], (*size)[1], (*size)[2]};
}

std::optional<ShapeForm> read_sphere(TomlSection& section) {
    const double diameter = section.number("sphere_mm", 1, NumberRule::positive);
    if (diameter <= kMaxLength_mm) return SphereShape{diameter};
    section.fail("sphere_mm", "'sphere_mm' must be a diameter of at most 1e6");
    return std::nullopt;
}

}  // namespace

std::optional<ShapeForm> read_shape(FirstError& error, TomlSection& section, const toml::table& table,
                                    const std::filesystem::path& folder, const os::Files& files) {
    section.require("shape");
    if (section.table("shape") == nullptr) return std::nullopt;
    const toml::table& shape_table = *table.get_as<toml::table>("shape");
    TomlSection shape(error, shape_table, "'shape'", kFormKeys);
    const std::size_t more = (shape.has("scale") ? 1U : 0U) + (shape.has("tolerance_mm") ? 1U : 0U);
    if (shape_table.size() != more + 1 || (more > 0 && !shape.has("mesh"))) {
        section.fail("shape",
                     "'shape' must contain one of box_mm, cylinder_mm, sphere_mm, capsule_mm and mesh; with "
                     "mesh it may also contain scale and tolerance_mm");
        return std::nullopt;
    }
    if (shape.has("box_mm")) return read_box(shape, shape_table);
    if (shape.has("sphere_mm")) return read_sphere(shape);
    if (shape.has("cylinder_mm")) return read_round_shape(shape, shape_table, "cylinder_mm");
    if (shape.has("capsule_mm")) return read_round_shape(shape, shape_table, "capsule_mm");
    if (shape.has("mesh")) return read_mesh_shape(shape, folder, files);
    return std::nullopt;
}

std::vector<std::pair<std::size_t, std::size_t>> read_ignored(
    FirstError& error, TomlSection& file, const toml::table& root,
    const std::function<std::optional<std::size_t>(std::string_view)>& find) {
    std::vector<std::pair<std::size_t, std::size_t>> ignored;
    if (!file.has("ignore")) return ignored;
    const toml::array* pairs = root.get_as<toml::array>("ignore");
    if (pairs == nullptr) {
        file.fail("ignore", "'ignore' must be a list of pairs of names");
        return ignored;
    }
    for (const toml::node& node : *pairs) {
        const toml::array* pair = node.as_array();
        const auto name = [&](std::size_t i) { return pair->get(i)->value<std::string_view>(); };
        if (pair == nullptr || pair->size() != 2 || !name(0) || !name(1)) {
            error.report(node.source().begin, "'ignore' must contain pairs of names: [[\"A\", \"B\"]]");
            return ignored;
        }
        const auto first = find(*name(0));
        const auto second = find(*name(1));
        if (!first || !second) {
            error.report(node.source().begin,
                         fmt::format("no object or shape has the name '{}'", first ? *name(1) : *name(0)));
            return ignored;
        }
        ignored.emplace_back(*first, *second);
    }
    return ignored;
}

}  // namespace gsim::machine
