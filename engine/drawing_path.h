#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "engine/api.h"
#include "engine/contours.h"
#include "engine/diagnostic.h"
#include "engine/host.h"
#include "engine/run.h"

namespace gsim::engine {

/// Options for reading a drawing (.dxf, .svg) or a flat part (.step, .stp, .iges, .igs).
struct DrawingOptions {
    double unit_mm = 0;                    ///< Size of one unit of a drawing; 0: as the drawing says.
    std::vector<std::string> layers = {};  ///< Only these, if there are any (DXF).
    double curve_tolerance_mm = 0.005;     ///< Max deviation of arcs from splines and ellipses.
    double gap_mm = 0.02;                  ///< Ends that are nearer than this are joined.
    std::string up = {};                   ///< For a flat part: PlateReadOptions::up.
    bool flip = false;                     ///< For a flat part: the plate is turned over.
};

/// The cutting parameters, by the materials file or by own values. The material settles missing values;
/// without one, speed_mm_min and kerf_mm must be given.
struct CuttingOptions {
    std::string material = {};           ///< Name in the materials file; empty: none.
    std::string materials = {};          ///< Materials file (TOML); empty: the one built in.
    double thickness_mm = 0;             ///< 0: that of the flat part.
    std::optional<double> quality = {};  ///< 1 (just through) to 5 (finest edge).
    std::optional<double> speed_mm_min = {};
    std::optional<double> kerf_mm = {};   ///< Width of the cut.
    std::optional<double> pierce_s = {};  ///< For each pierce; 0 if missing without a material.
    bool dynamic_pierce =
        false;  ///< The nozzle moves back and forth on the lead meanwhile, which takes less time.
    bool taper_compensation = false;  ///< The jet leans against the taper of its kerf. Needs a material.
};

/// Positions of the tool.
struct CuttingPathOptions {
    /// Position of the drawing's origin, on the material's upper side, in the work frame.
    std::array<double, 3> origin_mm = {};
    double lead_mm = 0;          ///< Radius of leads; 0: three kerfs.
    double safe_height_mm = 25;  ///< For moves between cuts, over the material.
    double cut_height_mm = 3;    ///< Height of the nozzle's TCP, jet on.
    double bevel_deg =
        0;  ///< Tilt of the jet along edges without their own bevel; above 0 the part is smaller below.
};

/// Options for cutting contours of a part that may be curved: the jet runs along the walls below their edges,
/// or along the normal of the face that it enters.
struct SurfaceCuttingOptions {
    ContourSelection contours = {};  ///< Its tolerance is DrawingOptions::curve_tolerance_mm.
    /// A script that selects among these: it returns a function that is true for the contours to cut
    /// (docs/autopath.md). Empty: all.
    std::string choose = {};
    double tilt_deg =
        0;  ///< From the normal to the side; above 0 the part is smaller below. Not along walls.
    double lead_angle_deg = 0;  ///< Forwards.
    double max_tilt_deg = 60;   ///< From the normal; what leans more is refused.
    int bridges = 0;            ///< Uncut bridges of each contour.
    double bridge_mm = 0.5;     ///< Width of each bridge.
    /// Start and end of the program, in the work frame; if missing, over the first pierce and the last one.
    std::optional<std::array<double, 3>> start_mm = {};
};

/// The surroundings of the cutting machine: moves between cuts avoid them, and cuts that collide with them
/// are errors. Names are those of files, or as Host::find finds them. Without a cell only the machine's own
/// bodies are checked.
struct CuttingCellOptions {
    std::string cell = {};
    std::string machine = {};       ///< Empty: that of the cell, or the one built in.
    std::string machine_data = {};  ///< Position of G54; empty: as cell or machine name it, or at 0.
};

/// A drawing to be cut out. Names are those of files, or as Host::find finds them; Host::read_plate reads
/// flat parts.
struct DrawingRequest {
    std::string drawing = {};
    DrawingOptions reading = {};
    CuttingOptions cutting = {};
    CuttingPathOptions cutting_path = {};
    /// Contours of a part (Host::read_contours) instead of a drawing or a flat part.
    std::optional<SurfaceCuttingOptions> surface = {};
    /// If missing, no check is made.
    std::optional<CuttingCellOptions> work_cell = {};
    Host host = {};
};

/// The amount of cutting in a path.
struct CuttingMetrics {
    std::size_t outlines = 0;  ///< Contours of the drawing.
    std::size_t pierces = 0;
    std::size_t without_leads = 0;
    double cut_mm = 0;     ///< Path length with the jet on: leads and contours.
    double travel_mm = 0;  ///< Between the cuts, over the material.
    double cut_s = 0;  ///< At the feeds of the path, without pierces or the time that a machine speeds up in.
    double slowdown_s =
        0;  ///< Part of it: extra time of curves and corners over straight lines of their length.
    double reorientation_s = 0;       ///< Part of it: turning at a fixed position.
    double taper_compensation_s = 0;  ///< Part of it: extra time for taper compensation.
    std::size_t dynamic_pierces = 0;
    /// For DrawingRequest::work_cell: paths from cut to cut, and those that were rerouted.
    std::size_t linking_paths = 0, rerouted_moves = 0;
};

/// The consumption for cutting it, by the material. Money is in `currency`.
struct JobMetrics {
    double thickness_mm = 0;
    double quality = 0;
    double speed_mm_min = 0;  ///< On straight lines.
    double kerf_mm = 0;
    double pierce_s = 0;  ///< For each pierce.
    double jet_s = 0;     ///< Cutting and piercing: water and abrasive flow.
    double machine_s = 0;
    double water_l = 0;
    double abrasive_kg = 0;
    double price = 0;
    std::string currency = {};
};

/// A drawing that becomes the path of a jet: open(), read(), make(), write(). It has no separate limit of
/// processor time.
class GSIM_API DrawingPath {
  public:
    /// Finds the drawing, and reads the materials file.
    static tl::expected<DrawingPath, Error> open(DrawingRequest request);
    DrawingPath(DrawingPath&&) noexcept;
    DrawingPath& operator=(DrawingPath&&) noexcept;
    ~DrawingPath();

    /// Returns the file of the drawing's name, the only one that is not yet read.
    const std::string& drawing_file() const;
    /// Returns true if it is a STEP or IGES file, by the extension of its name.
    bool is_solid() const;
    /// Reads the drawing, and settles the cutting parameters. "usage": options that do not fit the drawing or
    /// each other.
    tl::expected<void, Error> read();
    /// Makes the path, once read() has succeeded. `on_diagnostic` receives the deviations from the drawing.
    /// An error of the drawing itself is returned with `in_program`: ends that stay open, contours that
    /// cross.
    tl::expected<void, Error> make(const DiagnosticHandler& on_diagnostic = {});

    /// Writes the path file (docs/paths.md) after make(), for PathTranslation or a viewer. It stops when a
    /// sink returns false.
    void write(const TextSink& sink) const;
    const CuttingMetrics& metrics() const;
    /// Returns the metrics in one message.
    std::string summary() const;
    /// Returns nothing without a material.
    std::optional<JobMetrics> job() const;
    /// Returns the sources of the values and the price of the job, in full lines; empty without a material.
    std::string job_report() const;

  private:
    class State;
    explicit DrawingPath(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::engine
