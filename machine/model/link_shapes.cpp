#include "machine/model/link_shapes.h"

#include <array>
#include <string>
#include <vector>

#include "base/text/format.h"
#include "machine/file/frame_section.h"
#include "machine/file/shape_section.h"

namespace gsim::machine {

namespace {

using base::FirstError;
using base::TomlSection;

using std::string_view_literals::operator""sv;

constexpr std::array kLinkShapeKeys{"name"sv, "on"sv, "shape"sv, "frame"sv, "density_kg_m3"sv};
constexpr std::array kMountNames{"base"sv, "tool"sv, "work"sv, "jet"sv};

bool is_axis(const Machine& machine, std::string_view name) {
    return name.size() == 1 && machine.find(name[0]);
}

// True if cells use this name for one of the machine's frames.
bool is_frame(const Machine& machine, std::string_view name) {
    return name == "world" || name == "base" || name == "tool" || name == "work" || is_axis(machine, name);
}

std::optional<std::size_t> find_shape(const Machine& machine, std::string_view name) {
    for (std::size_t i = 0; i < machine.shapes.size(); ++i) {
        if (machine.shapes[i].name == name) return i;
    }
    return std::nullopt;
}

std::string letters(const Machine& machine) {
    std::vector<char> list;
    list.reserve(machine.axes.size());
    for (const Axis& axis : machine.axes) list.push_back(axis.letter);
    return text::joined(list, ", ");
}

class ShapeReader {
  public:
    ShapeReader(FirstError& error, const std::filesystem::path& folder, const os::Files& files,
                Machine& machine)
        : error_(error), folder_(folder), files_(files), machine_(machine) {}

    void read(const toml::table& table) {
        TomlSection section(error_, table, "[[shape]]", kLinkShapeKeys);
        LinkShape shape;
        shape.name = read_name(section);
        shape.on = read_attachment(section);
        const auto form = read_shape(error_, section, table, folder_, files_);
        shape.frame = read_frame(error_, section.table("frame"), "'frame'");
        shape.density_kg_m3 = section.number("density_kg_m3", 0, base::NumberRule::not_negative);
        if (!form) return;
        shape.form = *form;
        machine_.shapes.push_back(std::move(shape));
        lines_.push_back(section.where("name").line);
    }

  private:
    std::string read_name(TomlSection& section) {
        std::string name = section.text("name");
        if (name.empty()) section.fail("name", "'name' must not be empty");
        if (is_frame(machine_, name))
            section.fail("name",
                         fmt::format("the name '{}' is already used by a frame of the machine", name));
        if (const auto other = find_shape(machine_, name)) {
            section.fail("name",
                         fmt::format("the name '{}' is given twice; first in line {}", name, lines_[*other]));
        }
        return name;
    }

    std::string read_attachment(TomlSection& section) {
        std::string on = section.text("on");
        if (is_axis(machine_, on) ||
            std::find(kMountNames.begin(), kMountNames.end(), on) != kMountNames.end())
            return on;
        const auto nearest = text::nearest_name(on, kMountNames);
        section.fail(
            "on",
            fmt::format("'on' must be \"base\", an axis letter ({}), \"tool\", \"work\" or \"jet\"{}",
                        letters(machine_), nearest ? fmt::format("; did you mean \"{}\"?", *nearest) : ""));
        return on;
    }

    FirstError& error_;
    const std::filesystem::path& folder_;
    const os::Files& files_;
    Machine& machine_;
    std::vector<unsigned> lines_;  ///< Lines of the shapes' names.
};

}  // namespace

void read_link_shapes(FirstError& error, TomlSection& file, const toml::table& root,
                      const std::filesystem::path& folder, const os::Files& files, Machine& machine) {
    ShapeReader reader(error, folder, files, machine);
    if (file.has("shape")) {
        for (const toml::table* table : file.tables("shape")) reader.read(*table);
    }
    if (error.text()) return;  // a shape that is not read has a name, too
    machine.ignored =
        read_ignored(error, file, root, [&](std::string_view name) { return find_shape(machine, name); });
}

}  // namespace gsim::machine
