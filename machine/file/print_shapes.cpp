#include "machine/file/print_shapes.h"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "base/text/format.h"
#include "geometry/mesh/mesh.h"
#include "machine/file/frame_section.h"

namespace gsim::machine {

namespace {

using base::TomlWriter;

std::string inline_form(const BoxShape& box) {
    return fmt::format("box_mm = [{}, {}, {}]", base::toml_number(box.x_mm), base::toml_number(box.y_mm),
                       base::toml_number(box.z_mm));
}

std::string inline_form(const CylinderShape& cylinder) {
    return fmt::format("cylinder_mm = [{}, {}]", base::toml_number(cylinder.diameter_mm),
                       base::toml_number(cylinder.height_mm));
}

std::string inline_form(const CapsuleShape& capsule) {
    return fmt::format("capsule_mm = [{}, {}]", base::toml_number(capsule.diameter_mm),
                       base::toml_number(capsule.height_mm));
}

std::string inline_form(const SphereShape& sphere) {
    return fmt::format("sphere_mm = {}", base::toml_number(sphere.diameter_mm));
}

std::string inline_form(const MeshShape& mesh) {
    std::string text =
        fmt::format("mesh = {}, scale = {}", base::toml_string(std::filesystem::absolute(mesh.file).string()),
                    base::toml_number(mesh.scale));
    if (solid::is_solid_file(mesh.file))
        text += fmt::format(", tolerance_mm = {}", base::toml_number(mesh.tolerance_mm));
    return text;
}

std::string inline_shape(const ShapeForm& form) {
    return fmt::format("{{ {} }}", std::visit([](const auto& of) { return inline_form(of); }, form));
}

}  // namespace

void print_ignored(TomlWriter& out, const Machine& machine) {
    if (machine.ignored.empty()) return;
    std::vector<std::string> pairs;
    pairs.reserve(machine.ignored.size());
    for (const auto& [first, second] : machine.ignored) {
        pairs.push_back(fmt::format("[{}, {}]", base::toml_string(machine.shapes[first].name),
                                    base::toml_string(machine.shapes[second].name)));
    }
    out.line("ignore", fmt::format("[{}]", text::joined(pairs, ", ")));
}

void print_link_shapes(TomlWriter& out, const Machine& machine) {
    for (const LinkShape& shape : machine.shapes) {
        out.section("[[shape]]");
        out.line("name", base::toml_string(shape.name));
        out.line("on", base::toml_string(shape.on));
        out.line("shape", inline_shape(shape.form));
        if (shape.frame != Frame{}) out.line("frame", inline_frame(shape.frame));
        if (shape.density_kg_m3 != 0) out.number("density_kg_m3", shape.density_kg_m3);
    }
}

}  // namespace gsim::machine
