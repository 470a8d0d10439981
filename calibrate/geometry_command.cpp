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
#include "calibrate/geometry/geometry_outcome.h"
#include "calibrate/geometry/simulate.h"
#include "calibrate/geometry/suggest.h"
#include "cli/print.h"
#include "machine/file/machine_file.h"

namespace gsim::calibrate {

namespace {

struct GeometryArguments {
    std::string tips;
    std::string machine;
    std::string output;
    std::string json;
    std::string picture;
    std::string compensation;
    std::string g10;
    std::optional<double> noise_um;
    std::optional<double> noise_arcsec;
    bool own_frame = false;
    std::vector<std::string> held;
    std::uint64_t suggested = 0;
    bool orientation = false;
    std::string program;
    std::string simulated;
    std::string hidden;
    std::uint64_t seed = 1;
    bool quiet = false;

    DeviationChoice choice() const { return {.own_frame = own_frame, .held = held}; }
};

void add_fit_options(apps::CommandLine& line, GeometryArguments& arguments) {
    line.add("tips", &arguments.tips,
             "list of measured tips: columns by the letters of axes, x_mm, y_mm, z_mm, perhaps roll_deg, "
             "pitch_deg, yaw_deg, sigma_mm, sigma_deg")
        .of_file(apps::FileKind::input, {".csv", ".tsv"});
    line.add("--machine", &arguments.machine, "machine file to begin with")
        .called("FILE")
        .of_file(apps::FileKind::input, {".toml"})
        .must_be_given();
    line.add("-o,--output", &arguments.output,
             "the fitted machine file, or the list of suggested poses; else standard output")
        .called("FILE")
        .of_file(apps::FileKind::output, {".toml", ".csv"})
        .may_be_file_of("--machine");
    line.add("--json", &arguments.json, "what was found, its covariance and all tips as JSON")
        .called("FILE")
        .of_file(apps::FileKind::output, {".json"});
    line.add("--picture", &arguments.picture, "errors of tips before and after, as a picture")
        .called("FILE")
        .of_file(apps::FileKind::output, {".svg"});
    line.add("--compensation", &arguments.compensation,
             "compensation tables of LinuxCNC (COMP_FILE_TYPE = 0) of axes whose scale was found: "
             "PREFIX-X.comp")
        .called("PREFIX");
    line.add("--g10", &arguments.g10, "the work offset as a line of G-code, G10 L2 P1")
        .called("FILE")
        .of_file(apps::FileKind::output, {".ngc", ".nc"});
    line.add("--noise-um", &arguments.noise_um,
             "standard deviation of each measured coordinate; else it is found from what is left")
        .called("UM")
        .above_zero();
    line.add("--noise-arcsec", &arguments.noise_arcsec, "the same of measured turns")
        .called("ARCSEC")
        .above_zero();
    line.add("--own-frame", &arguments.own_frame,
             "tips are in the instrument's own frame, wherever that is; else in the work frame");
    line.add("--hold", &arguments.held,
             "what is not looked for: a name, or words of it, as 'scale', 'base', 'C tilt'")
        .called("NAME");
    line.add("-q,--quiet", &arguments.quiet, "no word on the way");
}

void add_other_options(apps::CommandLine& line, GeometryArguments& arguments) {
    line.begin_group("Poses to measure");
    line.add("--suggest", &arguments.suggested,
             "write this many poses that tell most, within the axes' ranges")
        .called("N")
        .within(1, 1000);
    line.add("--orientation", &arguments.orientation, "the instrument tells how the tool is turned, too");
    line.add("--program", &arguments.program, "a part program that goes there")
        .called("FILE")
        .of_file(apps::FileKind::output, {".nc", ".ngc"});
    line.begin_group("To try it without an instrument");
    line.add("--simulate", &arguments.simulated, "write what an instrument would measure at the list's poses")
        .called("FILE")
        .of_file(apps::FileKind::output, {".csv"});
    line.add("--hidden", &arguments.hidden,
             "with --simulate: on a machine that is off, which is written here")
        .called("FILE")
        .of_file(apps::FileKind::output, {".toml"});
    line.add("--seed", &arguments.seed, "of noise and of what is hidden").called("N").shows_default();
}

tl::expected<TipList, std::string> listed_tips(const GeometryArguments& arguments,
                                               const machine::Machine& machine) {
    if (arguments.tips.empty())
        return tl::unexpected<std::string>(
            "which tips? Name a list of them, or ask for poses with --suggest");
    const auto text = os::read_text_file(arguments.tips);
    if (!text) return tl::unexpected(text.error());
    auto list = read_tips(*text, machine);
    if (!list) return tl::unexpected(fmt::format("{}: {}", arguments.tips, list.error()));
    return list;
}

Done suggest(const GeometryArguments& arguments, const machine::Machine& machine) {
    const auto poses = suggest_poses(machine, arguments.suggested, arguments.orientation, arguments.choice());
    if (!poses) return tl::unexpected(poses.error());
    return write_or_print(arguments.output, print_tips(*poses, machine, arguments.orientation, false))
        .and_then([&] { return write_if(arguments.program, pose_program(*poses, machine)); });
}

std::string hidden_text(const HiddenMachine& hidden) {
    std::string text = "# What is hidden in this machine:\n";
    for (std::size_t i = 0; i < hidden.deviations.size(); ++i)
        text += fmt::format("# {} = {:.6f}\n", hidden.deviations[i].name,
                            hidden.values[static_cast<Eigen::Index>(i)]);
    return text + "\n" + machine::print_machine(hidden.geometry.machine);
}

Done simulate(const GeometryArguments& arguments, const machine::Machine& machine) {
    const auto list = listed_tips(arguments, machine);
    if (!list) return tl::unexpected(list.error());
    std::vector<MeasuredTip> poses = list->tips;
    poses.insert(poses.end(), list->unmeasured.begin(), list->unmeasured.end());
    for (MeasuredTip& pose : poses) pose.has_orientation = arguments.orientation;
    Geometry geometry{.machine = machine, .scales = std::vector<double>(machine.axes.size(), 1)};
    std::string text;
    if (!arguments.hidden.empty()) {
        const HiddenMachine hidden = hidden_machine(machine, poses, arguments.choice(), arguments.seed);
        geometry = hidden.geometry;
        text = hidden_text(hidden);
    }
    const Noise noise{.mm = arguments.noise_um.value_or(0) / kMicrometresPerMm,
                      .deg = arguments.noise_arcsec.value_or(0) / kArcsecPerDeg};
    const auto tips = simulated(geometry, poses, noise, arguments.seed);
    return write_if(arguments.hidden, text).and_then([&] {
        return write_if(arguments.simulated, print_tips(tips, machine, arguments.orientation, true));
    });
}

Done write_compensation(const GeometryArguments& arguments, const GeometryFit& fit, const TipList& list) {
    if (arguments.compensation.empty()) return {};
    const auto tables = compensation_tables(fit, list.tips);
    if (tables.empty()) return tl::unexpected<std::string>("no scale was found for a compensation table");
    for (const CompensationTable& table : tables) {
        const std::string file = fmt::format("{}-{}.comp", arguments.compensation, table.letter);
        if (auto done = os::write_file(file, table.text); !done) return done;
    }
    return {};
}

Done write_g10(const GeometryArguments& arguments, const machine::Machine& machine, const GeometryFit& fit) {
    if (arguments.g10.empty()) return {};
    const auto line = work_offset_line(machine, fit);
    if (!line) return tl::unexpected(line.error());
    return os::write_file(arguments.g10, *line);
}

Done fit_to_tips(const GeometryArguments& arguments, const machine::Machine& machine) {
    const auto list = listed_tips(arguments, machine);
    if (!list) return tl::unexpected(list.error());
    GeometryOptions options{.choice = arguments.choice()};
    if (arguments.noise_um) options.noise_mm = *arguments.noise_um / kMicrometresPerMm;
    if (arguments.noise_arcsec) options.noise_deg = *arguments.noise_arcsec / kArcsecPerDeg;
    const auto fit = fit_geometry(machine, list->tips, options);
    if (!fit) return tl::unexpected(fit.error());
    const auto squareness = squareness_of(machine, *fit);
    if (!arguments.quiet) {
        if (!list->unmeasured.empty())
            apps::tell(fmt::format("{} lines have no tip yet\n", list->unmeasured.size()));
        apps::tell(text::printable(geometry_table(*fit, squareness)));
    }
    const auto text = geometry_text(*fit);
    if (!text) return tl::unexpected("the fitted machine is no machine file: " + text.error());
    return write_or_print(arguments.output, *text)
        .and_then([&] { return write_if(arguments.json, geometry_json(*fit, squareness)); })
        .and_then([&] { return write_if(arguments.picture, tips_svg(*fit)); })
        .and_then([&] { return write_compensation(arguments, *fit, *list); })
        .and_then([&] { return write_g10(arguments, machine, *fit); });
}

Done do_geometry(const GeometryArguments& arguments) {
    const auto machine = machine::load_machine(arguments.machine);
    if (!machine) return tl::unexpected(machine.error());
    if (const auto unknown = unknown_held(*machine, arguments.choice()))
        return tl::unexpected(fmt::format("--hold: nothing that may be off is called '{}'", *unknown));
    if (arguments.suggested > 0) return suggest(arguments, *machine);
    if (!arguments.simulated.empty()) return simulate(arguments, *machine);
    return fit_to_tips(arguments, *machine);
}

}  // namespace

void add_geometry(apps::CommandLine& line, Chosen& chosen) {
    const auto arguments = std::make_shared<GeometryArguments>();
    apps::CommandLine& command =
        add_command(line, chosen, "geometry", "fit a machine's geometry to measured tips, or suggest poses",
                    [arguments] { return do_geometry(*arguments); });
    add_fit_options(command, *arguments);
    add_other_options(command, *arguments);
    line.add_example("gsim-calibrate geometry --machine mine.toml --suggest 40 -o poses.csv",
                     "which poses to measure");
    line.add_example("gsim-calibrate geometry tips.csv --machine mine.toml -o fitted.toml",
                     "where the axes really are, from tips that were measured there");
}

}  // namespace gsim::calibrate
