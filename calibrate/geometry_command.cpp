#include "calibrate/geometry_command.h"

#include <cstdint>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <tl/expected.hpp>

#include "base/os/input_file.h"
#include "base/os/output_file.h"
#include "base/text/printable.h"
#include "calibrate/command.h"
#include "calibrate/geometry/compensation.h"
#include "calibrate/geometry/geometry_output.h"
#include "calibrate/geometry/pose_selection.h"
#include "calibrate/geometry/simulated_tcps.h"
#include "cli/print.h"
#include "machine/file/machine_file.h"

namespace gsim::calibrate {

namespace {

struct GeometryArguments {
    std::string tcps;
    std::string machine;
    std::string output;
    std::string json;
    std::string picture;
    std::string compensation;
    std::string g10;
    std::optional<double> noise_um;
    std::optional<double> noise_arcsec;
    bool instrument_frame = false;
    std::vector<std::string> fixed;
    std::uint64_t suggested_count = 0;
    bool orientation = false;
    std::string program;
    std::string simulated_tcps;
    std::string ground_truth;
    std::uint64_t seed = 1;
    bool quiet = false;

    DeviationOptions deviation_options() const {
        return {.instrument_frame = instrument_frame, .fixed = fixed};
    }
};

void add_fit_options(apps::CommandLine& line, GeometryArguments& arguments) {
    line.add("tcps", &arguments.tcps,
             "list of measured TCP positions: columns with the letters of axes, x_mm, y_mm, z_mm, optionally "
             "roll_deg, pitch_deg, yaw_deg, sigma_mm, sigma_deg")
        .takes_file(apps::FileKind::input, {".csv", ".tsv"});
    line.add("--machine", &arguments.machine, "machine file to start with")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::input, {".toml"})
        .make_required();
    line.add("-o,--output", &arguments.output,
             "the fitted machine file, or the list of suggested poses; default: standard output")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".toml", ".csv"})
        .may_share_file_with("--machine");
    line.add("--json", &arguments.json, "results, covariance and all TCP positions as JSON")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".json"});
    line.add("--picture", &arguments.picture, "picture of the TCP errors before and after the fit")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".svg"});
    line.add("--compensation", &arguments.compensation,
             "compensation tables of LinuxCNC (COMP_FILE_TYPE = 0) of axes whose scale was fitted: "
             "PREFIX-X.comp")
        .with_value_name("PREFIX");
    line.add("--g10", &arguments.g10, "the work offset as a line of G-code, G10 L2 P1")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".ngc", ".nc"});
    line.add("--noise-um", &arguments.noise_um,
             "standard deviation of each measured coordinate; default: estimated from the residuals")
        .with_value_name("UM")
        .make_positive();
    line.add("--noise-arcsec", &arguments.noise_arcsec, "standard deviation of measured orientations")
        .with_value_name("ARCSEC")
        .make_positive();
    line.add(
            "--instrument-frame", &arguments.instrument_frame,
            "TCP positions are in the instrument's frame, whose pose is unknown; otherwise in the work frame")
        .formerly("--own-frame");
    line.add("--fix", &arguments.fixed,
             "deviations that are not fitted: a name, or words of it, such as 'scale', 'base', 'C tilt'")
        .with_value_name("NAME")
        .formerly("--hold");
    line.add("-q,--quiet", &arguments.quiet, "no progress");
}

void add_simulation_options(apps::CommandLine& line, GeometryArguments& arguments) {
    line.begin_group("Poses to measure");
    line.add("--suggest", &arguments.suggested_count,
             "write this many poses that determine the deviations best, within the axes' ranges")
        .with_value_name("N")
        .within(1, 1000);
    line.add("--orientation", &arguments.orientation,
             "the instrument also measures the orientation of the tool");
    line.add("--program", &arguments.program, "part program that moves to these poses")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".nc", ".ngc"});
    line.begin_group("Simulation without an instrument");
    line.add("--simulate", &arguments.simulated_tcps, "write simulated measurements at the list's poses")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".csv"});
    line.add("--ground-truth", &arguments.ground_truth,
             "with --simulate: use a machine with random deviations, and write it to this file")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".toml"})
        .formerly("--hidden");
    line.add("--seed", &arguments.seed, "seed of the noise and the random deviations")
        .with_value_name("N")
        .show_default();
}

Result<TcpList> load_tcps(const GeometryArguments& arguments, const machine::Machine& machine) {
    if (arguments.tcps.empty())
        return Unexpected("no TCP positions given; name a list of them, or request poses with --suggest");
    const auto text = os::read_text_file(arguments.tcps);
    if (!text) return tl::unexpected(text.error());
    auto list = read_tcps(*text, machine);
    if (!list) return Unexpected(fmt::format("{}: {}", arguments.tcps, list.error().message));
    return list;
}

Result<void> suggest(const GeometryArguments& arguments, const machine::Machine& machine) {
    const auto poses = suggest_poses(machine, arguments.suggested_count, arguments.orientation,
                                     arguments.deviation_options());
    if (!poses) return tl::unexpected(poses.error());
    return write_or_print(arguments.output, print_tcps(*poses, machine, arguments.orientation, false))
        .and_then([&] { return write_if_named(arguments.program, pose_program(*poses, machine)); });
}

std::string ground_truth_text(const GroundTruth& ground_truth) {
    std::string text = "# Random deviations of this machine:\n";
    for (std::size_t i = 0; i < ground_truth.deviations.size(); ++i)
        text += fmt::format("# {} = {:.6f}\n", ground_truth.deviations[i].name,
                            ground_truth.values[static_cast<Eigen::Index>(i)]);
    return text + "\n" + machine::print_machine(ground_truth.geometry.machine);
}

Result<void> simulate(const GeometryArguments& arguments, const machine::Machine& machine) {
    const auto list = load_tcps(arguments, machine);
    if (!list) return tl::unexpected(list.error());
    std::vector<MeasuredTcp> poses = list->tcps;
    poses.insert(poses.end(), list->unmeasured.begin(), list->unmeasured.end());
    for (MeasuredTcp& pose : poses) pose.has_orientation = arguments.orientation;
    Geometry geometry{.machine = machine, .scales = std::vector<double>(machine.axes.size(), 1)};
    std::string text;
    if (!arguments.ground_truth.empty()) {
        const GroundTruth ground_truth =
            make_ground_truth(machine, poses, arguments.deviation_options(), arguments.seed);
        geometry = ground_truth.geometry;
        text = ground_truth_text(ground_truth);
    }
    const Noise noise{.mm = arguments.noise_um.value_or(0) / kMicrometresPerMm,
                      .deg = arguments.noise_arcsec.value_or(0) / kArcsecPerDeg};
    const auto tcps = simulated_tcps(geometry, poses, noise, arguments.seed);
    return write_if_named(arguments.ground_truth, text).and_then([&] {
        return write_if_named(arguments.simulated_tcps,
                              print_tcps(tcps, machine, arguments.orientation, true));
    });
}

Result<void> write_compensation(const GeometryArguments& arguments, const GeometryFit& fit,
                                const TcpList& list) {
    if (arguments.compensation.empty()) return {};
    const auto tables = compensation_tables(fit, list.tcps);
    if (tables.empty()) return Unexpected("no scale was fitted for a compensation table");
    for (const CompensationTable& table : tables) {
        const std::string file = fmt::format("{}-{}.comp", arguments.compensation, table.letter);
        if (auto done = os::write_file(file, table.text); !done) return done;
    }
    return {};
}

Result<void> write_g10(const GeometryArguments& arguments, const machine::Machine& machine,
                       const GeometryFit& fit) {
    if (arguments.g10.empty()) return {};
    const auto line = work_offset_line(machine, fit);
    if (!line) return tl::unexpected(line.error());
    return os::write_file(arguments.g10, *line);
}

Result<void> fit_to_tcps(const GeometryArguments& arguments, const machine::Machine& machine) {
    const auto list = load_tcps(arguments, machine);
    if (!list) return tl::unexpected(list.error());
    GeometryOptions options{.deviation_options = arguments.deviation_options()};
    if (arguments.noise_um) options.noise_mm = *arguments.noise_um / kMicrometresPerMm;
    if (arguments.noise_arcsec) options.noise_deg = *arguments.noise_arcsec / kArcsecPerDeg;
    const auto fit = fit_geometry(machine, list->tcps, options);
    if (!fit) return tl::unexpected(fit.error());
    const auto squareness = compute_squareness(machine, *fit);
    if (!arguments.quiet) {
        if (!list->unmeasured.empty())
            apps::print_to_standard_error(
                fmt::format("{} lines have no TCP position yet\n", list->unmeasured.size()));
        apps::print_to_standard_error(text::printable(geometry_table(*fit, squareness)));
    }
    const auto text = geometry_text(*fit);
    if (!text) return Unexpected("the fitted machine is not a valid machine file: " + text.error().message);
    return write_or_print(arguments.output, *text)
        .and_then([&] { return write_if_named(arguments.json, geometry_json(*fit, squareness)); })
        .and_then([&] { return write_if_named(arguments.picture, tcps_svg(*fit)); })
        .and_then([&] { return write_compensation(arguments, *fit, *list); })
        .and_then([&] { return write_g10(arguments, machine, *fit); });
}

Result<void> run_geometry(const GeometryArguments& arguments) {
    const auto machine = read_machine_argument(arguments.machine);
    if (!machine) return tl::unexpected(machine.error());
    if (const auto unknown = find_unknown_fixed(*machine, arguments.deviation_options()))
        return Unexpected(fmt::format("--fix: unknown deviation '{}'", *unknown));
    if (arguments.suggested_count > 0) return suggest(arguments, *machine);
    if (!arguments.simulated_tcps.empty()) return simulate(arguments, *machine);
    return fit_to_tcps(arguments, *machine);
}

}  // namespace

void add_geometry_command(apps::CommandLine& line, SelectedCommand& selected) {
    const auto arguments = std::make_shared<GeometryArguments>();
    apps::CommandLine& command = add_command(
        line, selected, "geometry", "fit a machine's geometry to measured TCP positions, or suggest poses",
        [arguments] { return run_geometry(*arguments); });
    add_fit_options(command, *arguments);
    add_simulation_options(command, *arguments);
    line.add_example("gsim-calibrate geometry --machine mine.toml --suggest 40 -o poses.csv",
                     "poses to measure");
    line.add_example("gsim-calibrate geometry tips.csv --machine mine.toml -o fitted.toml",
                     "geometry of the axes from measured TCP positions");
}

}  // namespace gsim::calibrate
