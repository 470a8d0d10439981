#include "tests/cam/solid/surface_program.h"

#include <fmt/format.h>

#include "tests/build_files/build_files.h"

namespace gsim::apps {

std::vector<solid::models::Jet> SurfaceProgram::jets(const std::string& step, const Eigen::Vector3d& at,
                                                     const std::vector<std::string>& options,
                                                     const std::string& cell, const std::string& machine) {
    std::vector<std::string> arguments{step,  "-o", "part.path.json", "--kerf", fmt::format("{}", kKerf_mm),
                                       "--at"};
    for (const double value : at) arguments.push_back(fmt::format("{}", value));
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended path = run_program(tests::program_path("autopath"), arguments, folder_);
    EXPECT_EQ(path.status, 0) << path.err;
    told_ = path.err;
    const Ended program =
        run_program(tests::program_path("path2gcode"), {"part.path.json", "-o", "part.nc"}, folder_);
    EXPECT_EQ(program.status, 0) << program.err;
    const std::string own_cell = write("cell.toml", fmt::format(R"(ignore = [["jet", "part"]]
[cell]
name = "a part"
[[object]]
name = "part"
role = "workpiece"
shape = {{ mesh = "{}", tolerance_mm = 0.02 }}
frame = {{ x_mm = {}, y_mm = {}, z_mm = {} }}
)",
                                                                step, at.x(), at.y(), at.z()));
    const Ended run = gsim_run({"part.nc", "--machine", machine, "--cell", cell.empty() ? own_cell : cell,
                                "--trajectory", "way.csv", "--step", "0.001"});
    EXPECT_EQ(run.status, 0) << run.err << run.out;
    report_ = run.out;
    return solid::models::read_jets(read("way.csv"), read("part.nc"), at);
}

Ended SurfaceProgram::autopath(const std::string& step, const std::vector<std::string>& options,
                               const std::string& kerf) const {
    std::vector<std::string> arguments{step, "--kerf", kerf, "--speed", "400", "-o", "part.path.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(tests::program_path("autopath"), arguments, folder_);
}

void SurfaceProgram::expect_cut(const std::string& what, const Points& points,
                                const std::vector<solid::models::Jet>& jets, double gouge_mm) {
    const solid::models::Deviation off = solid::models::deviation(points, jets, kKerf_mm);
    RecordProperty(what, fmt::format("{:.4f} to {:.4f} mm", off.min_mm, off.greatest_mm));
    fmt::print("{}: {:.4f} to {:.4f} mm\n", what, off.min_mm, off.greatest_mm);
    EXPECT_GE(off.min_mm, -gouge_mm) << what;
    EXPECT_LE(off.greatest_mm, kNear_mm) << what;
}

std::string SurfaceProgram::sample(const std::string& name) {
    return tests::source_path("samples/") + name;
}

Points along(const std::function<Eigen::Vector3d(double)>& curve, int count) {
    Points points;
    for (int i = 0; i < count; ++i) points.push_back(curve(static_cast<double>(i) / count));
    return points;
}

}  // namespace gsim::apps
