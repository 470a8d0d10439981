#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "engine/api.h"
#include "engine/diagnostic.h"
#include "engine/request.h"

namespace gsim::engine {

/// A frame relative to another one: roll about Z, pitch about Y, yaw about X, R = Rz Ry Rx.
struct FramePose {
    std::array<double, 3> origin_mm = {};
    std::array<double, 3> rpy_deg = {};
};

/// The check results of a machine without a program.
struct MachineCheck {
    bool is_clean = true;
    std::string json;
    std::string text;  ///< For people, in full lines.
};

enum class EnvelopeKind : std::uint8_t {
    volume_stl,    ///< The volume that the TCP can reach, as a surface.
    outlines_csv,  ///< For each pair of joints.
    outlines_svg,
};

/// A machine, and the bodies around it.
class GSIM_API Machine {
  public:
    /// Returns the machine of a request: its values for machine, machine data, cell and collisions.
    static tl::expected<Machine, Error> read(const Request& request);
    /// Reads the bodies that runs check, the meshes of machine and cell.
    tl::expected<void, Error> read_bodies();
    Machine(Machine&&) noexcept;
    Machine& operator=(Machine&&) noexcept;
    ~Machine();

    /// Returns messages about the controller's settings that are not imported.
    const std::vector<std::string>& notes() const;
    /// Returns warnings about the machine file, and notes().
    std::vector<Diagnostic> diagnostics() const;
    /// Returns the machine file that the request or the cell names; empty: the built-in one.
    const std::string& machine_file() const;
    /// Returns the file of machine data that the request or the cell names; empty: none.
    const std::string& machine_data_file() const;
    /// Returns the language that it reads, as the machine file says; empty: not specified.
    const std::string& dialect() const;
    /// Returns the machine as a machine file.
    std::string file() const;
    /// Returns the pose of a frame or an object of the cell in the work frame, after read_bodies(). The
    /// error: none has that name, or it does not move with the work.
    tl::expected<FramePose, Error> frame_in_work(const std::string& name) const;

    /// Checks limits, inverse, singular ranges, and collisions of its bodies for all joint values.
    tl::expected<MachineCheck, Error> check() const;
    /// Returns the reach of the TCP; envelope_summary() returns its accuracy afterwards.
    tl::expected<std::string, Error> envelope(EnvelopeKind kind);
    std::string envelope_summary() const;
    /// Returns a picture (SVG) of the direction in which each axis moves the tool.
    tl::expected<std::string, Error> axes_svg() const;

    /// For internal use.
    struct Parts;
    const Parts& parts() const;

  private:
    class State;
    explicit Machine(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::engine
