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

/// A frame in another one: roll about Z, pitch about Y, yaw about X, R = Rz Ry Rx.
struct FramePose {
    std::array<double, 3> origin_mm = {};
    std::array<double, 3> rpy_deg = {};
};

/// What was found of a machine without a program.
struct MachineCheck {
    bool clean = true;
    std::string json;
    std::string text;  ///< For people, in whole lines.
};

enum class EnvelopeKind : std::uint8_t {
    volume_stl,    ///< What the tool's tip can reach, as a surface.
    outlines_csv,  ///< For each pair of joints.
    outlines_svg,
};

/// A machine, and the bodies around it.
class GSIM_API Machine {
  public:
    /// The machine of a request: what it says of machine, machine data, cell and collisions.
    static tl::expected<Machine, Failure> read(const Request& request);
    /// Reads the bodies that runs look at, the meshes of machine and cell.
    tl::expected<void, Failure> read_bodies();
    Machine(Machine&&) noexcept;
    Machine& operator=(Machine&&) noexcept;
    ~Machine();

    /// What of a control's settings is not taken over, in sentences.
    const std::vector<std::string>& notes() const;
    /// The machine file, which the request or the cell names; empty: the one built in.
    const std::string& machine_file() const;
    /// Of machine data, which the request or the cell names; empty: none.
    const std::string& machine_data_file() const;
    /// The language that it reads, as the machine file says; empty: it does not.
    const std::string& dialect() const;
    /// As a machine file.
    std::string file() const;
    /// Where a frame or an object of the cell stands in the work frame, behind read_bodies(). The error:
    /// there is none of that name, or it does not go along with the work.
    tl::expected<FramePose, Failure> frame_in_work(const std::string& name) const;

    /// Limits, inverse, singular ranges, collisions of its bodies whatever the joints do.
    tl::expected<MachineCheck, Failure> check() const;
    /// What the tip reaches; how exact it is, envelope_summary() tells behind it.
    tl::expected<std::string, Failure> envelope(EnvelopeKind kind);
    std::string envelope_summary() const;
    /// A picture (SVG) of which way each axis moves the tool.
    tl::expected<std::string, Failure> axes_svg() const;

    /// For the library itself.
    struct Parts;
    const Parts& parts() const;

  private:
    class State;
    explicit Machine(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::engine
