#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "engine/contours.h"
#include "engine/files.h"
#include "engine/plate.h"

namespace gsim::rrs {
class RcsModule;
}
namespace gsim::machine {
struct Machine;
}

namespace gsim::engine {

/// Kinds of names that are not files: samples, machines, libraries that a program brings along.
enum class NameKind : std::uint8_t {
    sample,   ///< A program, machine data, a cell, a setup, a file of robots or overrides, a drawing.
    machine,  ///< A machine file, or the name of a machine ("router3").
    library,  ///< The folder of the library in Lua.
    module,   ///< A controller module.
};

/// A surface of triangles.
struct Triangles {
    std::vector<std::array<double, 3>> points_mm;
    std::vector<std::array<std::uint32_t, 3>> corners;  ///< Indices of points, three for each triangle.
};

/// The external services of the engine. It needs none of them: without processes, shared libraries or an
/// installation around it, it rejects each feature that needs them by name.
struct Host {
    Files files = {};
    /// Returns the file of a name; the name of a file does not change. The error is a message. Null: names
    /// are those of files.
    std::function<tl::expected<std::string, std::string>(NameKind kind, const std::string& name)> find = {};
    /// Returns the surfaces of a STEP or IGES file with a deviation of at most `tolerance_mm`. The error is a
    /// message. Null: such files are rejected.
    std::function<tl::expected<Triangles, std::string>(const std::string& file, double tolerance_mm)>
        read_solid = {};
    /// Returns the outlines of a flat part in a STEP or IGES file. The error is a message. Null: such files
    /// are rejected.
    std::function<tl::expected<Plate, std::string>(const std::string& file, const PlateReadOptions& options)>
        read_plate = {};
    /// Returns contours of a part in a STEP or IGES file that may be curved. The error is a message. Null:
    /// such files are rejected.
    std::function<tl::expected<Contours, std::string>(const std::string& file,
                                                      const ContourSelection& options)>
        read_contours = {};
    /// Returns a controller module that plans for the machine. The error is a message. Null: none is
    /// accepted.
    std::function<tl::expected<std::shared_ptr<rrs::RcsModule>, std::string>(const std::string& file,
                                                                             const machine::Machine& machine)>
        load_module = {};
};

}  // namespace gsim::engine
