#include "collision/cell/machine_shapes.h"

#include <variant>

#include <fmt/format.h>

#include "machine/model/frame_pose.h"

namespace gsim::cell {

namespace {

using ExpectedShape = Result<Shape>;

ExpectedShape make(const machine::BoxShape& box, const MeshFiles& /*files*/) {
    return Shape::box({box.x_mm, box.y_mm, box.z_mm});
}
ExpectedShape make(const machine::CylinderShape& cylinder, const MeshFiles& /*files*/) {
    return Shape::cylinder(cylinder.diameter_mm, cylinder.height_mm);
}
ExpectedShape make(const machine::CapsuleShape& capsule, const MeshFiles& /*files*/) {
    return Shape::capsule(capsule.diameter_mm, capsule.height_mm);
}
ExpectedShape make(const machine::SphereShape& sphere, const MeshFiles& /*files*/) {
    return Shape::sphere(sphere.diameter_mm);
}
ExpectedShape make(const machine::MeshShape& mesh, const MeshFiles& files) {
    return load_mesh(mesh.file, mesh.scale, mesh.tolerance_mm, files).map(&Shape::mesh);
}

}  // namespace

Result<Shape> make_shape(const machine::ShapeForm& form, const MeshFiles& files) {
    return std::visit([&files](const auto& of) { return make(of, files); }, form);
}

Result<Cell> make_machine_cell(const machine::Machine& machine, const MeshFiles& files) {
    Cell cell{.name = machine.name, .frames = FrameTree(machine)};
    for (const machine::LinkShape& link_shape : machine.shapes) {
        auto shape = make_shape(link_shape.form, files);
        if (!shape) {
            return Unexpected(fmt::format("the shape '{}' of the machine cannot be read: {}", link_shape.name,
                                          shape.error().message));
        }
        const bool jet = link_shape.on == "jet";
        // The reader of machine files rejects other names.
        const std::size_t parent = cell.frames.find(jet ? "tool" : link_shape.on).value();
        const std::size_t frame =
            cell.frames.add(link_shape.name, parent, machine::frame_pose(link_shape.frame));
        cell.items.push_back({link_shape.name, jet ? Role::jet : Role::machine, *std::move(shape), frame});
    }
    cell.ignored = machine.ignored;
    return cell;
}

}  // namespace gsim::cell
