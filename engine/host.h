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

/// What names stand for that are no files: samples, machines, libraries that a program brings along.
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

/// What the engine is given from outside. It needs none of it: without processes, shared libraries or an
/// installation around it, what would need them is refused by name.
struct Host {
    Files files = {};
    /// The file that a name means; a name that is a file's stays. The error is a sentence. Null: names are
    /// those of files.
    std::function<tl::expected<std::string, std::string>(NameKind kind, const std::string& name)> find = {};
    /// The surfaces of a STEP or IGES file, off them by `tolerance_mm` at most. The error is a sentence.
    /// Null: such files are refused.
    std::function<tl::expected<Triangles, std::string>(const std::string& file, double tolerance_mm)>
        read_solid = {};
    /// The outlines of a flat part in a STEP or IGES file. The error is a sentence. Null: such files are
    /// refused.
    std::function<tl::expected<Plate, std::string>(const std::string& file, const PlateChoice& choice)>
        read_plate = {};
    /// Contours of a part in a STEP or IGES file that need not be flat. The error is a sentence. Null: such
    /// files are refused.
    std::function<tl::expected<Contours, std::string>(const std::string& file, const ContourChoice& choice)>
        read_contours = {};
    /// A controller module that plans for the machine. The error is a sentence. Null: none is taken.
    std::function<tl::expected<std::shared_ptr<rrs::RcsModule>, std::string>(const std::string& file,
                                                                             const machine::Machine& machine)>
        load_module = {};
};

}  // namespace gsim::engine
