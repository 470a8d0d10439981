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

/// How a drawing (.dxf, .svg) or a flat part (.step, .stp, .iges, .igs) is read.
struct DrawingChoice {
    double unit_mm = 0;                    ///< What one unit of a drawing is; 0: what the drawing says.
    std::vector<std::string> layers = {};  ///< Only these, if there are any (DXF).
    double curve_tolerance_mm = 0.005;     ///< How far arcs may be off splines and ellipses.
    double gap_mm = 0.02;                  ///< Ends that are nearer than this are joined.
    std::string up = {};                   ///< Of a flat part: PlateChoice::up.
    bool flip = false;                     ///< Of a flat part: the plate is turned over.
};

/// What is cut, by the materials file or by figures of one's own. What is left out is settled by the
/// material; without one speed_mm_min and kerf_mm must be given.
struct CuttingChoice {
    std::string material = {};           ///< As the materials file calls it; empty: none.
    std::string materials = {};          ///< Materials file (TOML); empty: the one built in.
    double thickness_mm = 0;             ///< 0: that of the flat part.
    std::optional<double> quality = {};  ///< 1 (just through) to 5 (finest edge).
    std::optional<double> speed_mm_min = {};
    std::optional<double> kerf_mm = {};   ///< Width of the cut.
    std::optional<double> pierce_s = {};  ///< For each pierce; without a material 0 where it is left out.
    bool moving_pierce = false;  ///< The nozzle goes to and fro on the lead meanwhile, which takes less time.
    bool straighten = false;     ///< The jet leans against the taper of its kerf. Needs a material.
};

/// Where the tool goes.
struct CuttingWays {
    /// Where the drawing's origin, on the material's upper side, lies in the work frame.
    std::array<double, 3> origin_mm = {};
    double lead_mm = 0;          ///< Radius of leads; 0: three kerfs.
    double safe_height_mm = 25;  ///< Of ways between cuts, over the material.
    double cut_height_mm = 3;    ///< Of the nozzle's tip while the jet is on.
    double bevel_deg = 0;  ///< Lean of the jet along edges without a bevel of their own; above 0 the part is
                           ///< smaller below.
};

/// How contours of a part are cut that need not be flat: the jet goes along the walls below their edges, or
/// along the normal of the face that it enters.
struct SurfaceChoice {
    ContourChoice contours = {};  ///< Its tolerance is DrawingChoice::curve_tolerance_mm.
    /// A script that chooses among these: it returns a function that is true of what is cut
    /// (docs/autopath.md). Empty: all are.
    std::string choose = {};
    double lean_deg =
        0;  ///< From the normal to the side; above 0 the part is smaller below. Not along walls.
    double tilt_deg = 0;       ///< Forwards.
    double max_lean_deg = 60;  ///< From the normal; what leans more is refused.
    int bridges = 0;           ///< Of each contour: where it is left uncut.
    double bridge_mm = 0.5;    ///< How wide each stays.
    /// Where the program begins and ends, in the work frame; without it, over the first pierce and the last
    /// one.
    std::optional<std::array<double, 3>> start_mm = {};
};

/// What stands round the machine that is to cut: ways between cuts lead past it, and cuts that it is in the
/// way of are refused. Names are those of files, or what Host::find finds; without a cell the machine's own
/// bodies are looked at alone.
struct CuttingPlace {
    std::string cell = {};
    std::string machine = {};       ///< Empty: that of the cell, or the one built in.
    std::string machine_data = {};  ///< Where G54 lies; empty: what cell or machine name, or at 0.
};

/// A drawing to be cut out. Names are those of files, or what Host::find finds; flat parts come by
/// Host::read_plate.
struct DrawingRequest {
    std::string drawing = {};
    DrawingChoice reading = {};
    CuttingChoice cutting = {};
    CuttingWays ways = {};
    /// Contours of a part (Host::read_contours) in place of a drawing or a flat one.
    std::optional<SurfaceChoice> surface = {};
    /// Left out: nobody looks.
    std::optional<CuttingPlace> place = {};
    Host host = {};
};

/// What a path cuts.
struct CuttingFigures {
    std::size_t outlines = 0;  ///< Contours of the drawing.
    std::size_t pierces = 0;
    std::size_t without_leads = 0;
    double cut_mm = 0;     ///< Way with the jet on: leads and contours.
    double travel_mm = 0;  ///< Between the cuts, over the material.
    double cut_s = 0;  ///< At the feeds of the path, without pierces or the time that a machine speeds up in.
    double slower_s = 0;  ///< Of that, what curves and corners take more than straight lines of their length.
    double turning_s = 0;        ///< Of that, turning in one place.
    double straightening_s = 0;  ///< Of that, what leaning against the taper adds.
    std::size_t moving_pierces = 0;
    /// Of DrawingRequest::place: ways from cut to cut, and those that lead round something.
    std::size_t ways = 0, ways_round = 0;
};

/// What cutting it takes, by the material. Money is in `currency`.
struct JobFigures {
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

/// A drawing on its way to the path of a jet: open(), read(), make(), write(). It has no limit of processor
/// time of its own.
class GSIM_API DrawingPath {
  public:
    /// Finds the drawing, and reads the materials file.
    static tl::expected<DrawingPath, Failure> open(DrawingRequest request);
    DrawingPath(DrawingPath&&) noexcept;
    DrawingPath& operator=(DrawingPath&&) noexcept;
    ~DrawingPath();

    /// The file that the drawing's name means, of all files the only one that is still to be read.
    const std::string& drawing_file() const;
    /// Whether it is a STEP or IGES file, by the ending of its name.
    bool is_solid() const;
    /// Reads the drawing, and settles how it is cut. "usage": options that do not go with the drawing or
    /// with each other.
    tl::expected<void, Failure> read();
    /// Behind read(): the path. `tell` gets what is not cut as it was drawn. What is wrong with the drawing
    /// itself is a failure with `in_program`: ends that stay open, contours that cross.
    tl::expected<void, Failure> make(const Tell& tell = {});

    /// Behind make(): the path file (docs/paths.md), for PathTranslation or a viewer. After a sink's false it
    /// gets no more.
    void write(const TextSink& sink) const;
    const CuttingFigures& figures() const;
    /// The figures in a sentence.
    std::string summary() const;
    /// Nothing without a material.
    std::optional<JobFigures> job() const;
    /// How the values were found and what the job costs, in whole lines; empty without a material.
    std::string job_report() const;

  private:
    class State;
    explicit DrawingPath(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::engine
