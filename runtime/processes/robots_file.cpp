#include "runtime/processes/robots_file.h"

#include <algorithm>
#include <array>

#include "base/toml/toml_section.h"
#include "machine/file/frame_section.h"
#include "machine/file/shape_section.h"
#include "machine/model/frame_pose.h"

namespace gsim::process {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;
using std::string_view_literals::operator""sv;

namespace {

constexpr std::array kFileKeys{"robot"sv, "conveyor"sv, "zone"sv,  "cell"sv,
                               "frame"sv, "object"sv,   "shape"sv, "ignore"sv};
constexpr std::array kRobotKeys{"name"sv, "machine"sv, "machine_data"sv, "cell"sv, "dialect"sv, "base"sv};
constexpr std::array kConveyorKeys{"name"sv, "direction"sv, "speed_mm_s"sv};
constexpr std::array kZoneKeys{"name"sv, "shape"sv, "frame"sv};
constexpr std::array kDirectionKeys{"x"sv, "y"sv, "z"sv};

/// Restricts names, because they are parts of names of signals and of files.
bool is_plain(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    });
}

class RobotsReader {
  public:
    RobotsReader(FirstError& error, std::filesystem::path folder, std::span<const std::string_view> dialects)
        : error_(error), folder_(std::move(folder)), dialects_(dialects) {}

    RobotsFile read(const toml::table& root) {
        TomlSection file(error_, root, "a robots file", kFileKeys);
        for (const toml::table* table : file.tables("robot")) read_robot(*table);
        if (file.has("conveyor")) {
            for (const toml::table* table : file.tables("conveyor")) read_conveyor(*table);
        }
        if (file.has("zone")) {
            for (const toml::table* table : file.tables("zone")) read_zone(*table);
        }
        if (!error_.text() && file_.robots.empty())
            file.fail("robot", "a robots file needs at least one [[robot]]");
        return std::move(file_);
    }

  private:
    std::string read_name(TomlSection& section) {
        std::string name = section.text("name");
        if (!is_plain(name))
            section.fail(
                "name",
                "'name' must consist of letters, digits, '_' and '-' (signals and files are named after it)");
        if (std::find(names_.begin(), names_.end(), name) != names_.end())
            section.fail("name", fmt::format("the name '{}' is already used above", name));
        names_.push_back(name);
        return name;
    }

    std::filesystem::path read_path(TomlSection& section, std::string_view key) {
        return section.has(key) ? folder_ / section.text(key) : std::filesystem::path();
    }

    void read_robot(const toml::table& table) {
        TomlSection section(error_, table, "[[robot]]", kRobotKeys);
        RobotEntry robot;
        robot.name = read_name(section);
        robot.machine = read_path(section, "machine");
        robot.machine_data = read_path(section, "machine_data");
        robot.cell = read_path(section, "cell");
        if (section.has("dialect")) robot.dialect = dialects_[section.choice("dialect", 0, dialects_)];
        robot.base = machine::frame_pose(machine::read_frame(error_, section.table("base"), "'base'"));
        file_.robots.push_back(std::move(robot));
    }

    void read_conveyor(const toml::table& table) {
        TomlSection section(error_, table, "[[conveyor]]", kConveyorKeys);
        std::string name = read_name(section);
        const double speed_mm_s = section.number("speed_mm_s", 0, NumberRule::finite);
        section.require("direction");
        Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
        if (const toml::table* axes = section.table("direction")) {
            TomlSection vector(error_, *axes, "'direction'", kDirectionKeys);
            for (Eigen::Index i = 0; i < 3; ++i)
                direction[i] =
                    vector.number(kDirectionKeys[static_cast<std::size_t>(i)], 0, NumberRule::finite);
        }
        const double length = direction.stableNorm();
        if (!(length > 0))
            return section.fail("direction", "'direction' must not be zero: for example { x = 1.0 }");
        file_.conveyors.emplace_back(std::move(name), direction / length, speed_mm_s);
    }

    void read_zone(const toml::table& table) {
        TomlSection section(error_, table, "[[zone]]", kZoneKeys);
        SharedZone zone;
        zone.name = read_name(section);
        const os::CallbackFiles no_files([](const std::string&) -> std::optional<std::string> { return {}; });
        auto form = machine::read_shape(error_, section, table, folder_, no_files);
        if (form && std::holds_alternative<machine::MeshShape>(*form))
            section.fail("shape", "a zone must be a box, a cylinder, a sphere or a capsule");
        if (form) zone.form = *std::move(form);
        zone.frame = machine::frame_pose(machine::read_frame(error_, section.table("frame"), "'frame'"));
        file_.zones.push_back(std::move(zone));
    }

    FirstError& error_;
    std::filesystem::path folder_;
    std::span<const std::string_view> dialects_;
    RobotsFile file_;
    std::vector<std::string> names_;
};

}  // namespace

Result<RobotsFile> read_robots(std::string_view toml_text, std::string_view file_name,
                               std::span<const std::string_view> dialects) {
    FirstError error(file_name);
    const toml::table root = base::parse_toml(error, toml_text);
    if (error.text()) return tl::unexpected(*error.text());
    RobotsFile file =
        RobotsReader(error, std::filesystem::path(file_name).parent_path(), dialects).read(root);
    if (error.text()) return tl::unexpected(*error.text());
    return file;
}

}  // namespace gsim::process
