#include "collision/cell/cell_file.h"

#include <array>
#include <functional>
#include <map>
#include <set>

#include "base/text/format.h"
#include "base/toml/toml_section.h"
#include "collision/cell/machine_shapes.h"
#include "collision/pairs/candidate_pairs.h"
#include "machine/file/frame_section.h"
#include "machine/file/shape_section.h"
#include "machine/model/frame_pose.h"

namespace gsim::cell {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;
using std::string_view_literals::operator""sv;

namespace {

constexpr std::array kFileKeys{"cell"sv, "frame"sv, "object"sv, "shape"sv, "ignore"sv,
                               // of the file of robots, which may be the same
                               "robot"sv, "conveyor"sv};
constexpr std::array kCellTableKeys{"name"sv, "machine"sv, "machine_data"sv, "clearance_mm"sv};
constexpr std::array kFrameKeys{"name"sv, "attached_to"sv, "frame"sv};
constexpr std::array kObjectKeys{"name"sv, "shape"sv, "frame"sv, "attached_to"sv, "role"sv};
constexpr std::array kShapeKeys{"name"sv, "shape"sv, "frame"sv, "on"sv};
constexpr std::array kRoles{"workpiece"sv, "fixture"sv};

rrs::CartPos read_pose(FirstError& error, const toml::table* table) {
    return machine::frame_pose(machine::read_frame(error, table, "'frame'"));
}

/// Reader of the tables of a cell file into a cell that has the machine's shapes already.
class CellReader {
  public:
    CellReader(FirstError& error, std::filesystem::path folder, const MeshFiles& files, Cell cell)
        : error_(error),
          folder_(std::move(folder)),
          files_(files),
          machine_items_(cell.items.size()),
          cell_(std::move(cell)) {
        for (std::size_t i = 0; i < cell_.items.size(); ++i) items_by_name_.emplace(cell_.items[i].name, i);
    }

    void add_conveyor(const std::string& name, const toml::table& root) {
        if (cell_.frames.find(name)) {
            return error_.report(
                root.source().begin,
                fmt::format("the conveyor '{}' has the same name as a frame of the machine", name));
        }
        cell_.make_movable(cell_.frames.add(name, 0, rrs::CartPos::Identity()), true);
    }

    Cell read(const toml::table& root) {
        TomlSection file(error_, root, "a cell file", kFileKeys);
        file.require("cell");
        if (const toml::table* head = file.table("cell")) read_cell_table(*head);
        for (const toml::table* table : tables(file, "frame")) read_frame(*table);
        for (const toml::table* table : tables(file, "object")) read_object(*table);
        for (const toml::table* table : tables(file, "shape")) read_link_shape(*table);
        if (error_.text()) return std::move(cell_);  // an object that is not read has a name, too
        const auto ignored = machine::read_ignored(error_, file, root,
                                                   [this](std::string_view name) { return find_item(name); });
        cell_.ignored.insert(cell_.ignored.end(), ignored.begin(), ignored.end());
        if (const auto error = find_pair_count_error(cell_.items, cell_.frames))
            file.fail("object", error->message);
        return std::move(cell_);
    }

  private:
    static std::vector<const toml::table*> tables(TomlSection& file, std::string_view key) {
        return file.has(key) ? file.tables(key) : std::vector<const toml::table*>{};
    }

    void read_cell_table(const toml::table& table) {
        TomlSection section(error_, table, "[cell]", kCellTableKeys);
        cell_.name = section.text("name");
        cell_.clearance_mm = section.number("clearance_mm", 0, NumberRule::not_negative);
    }

    std::string read_name(TomlSection& section) {
        std::string name = section.text("name");
        if (name.empty()) section.fail("name", "'name' must not be empty");
        const auto item = find_item(name);
        if (item && *item < machine_items_) {
            section.fail(
                "name",
                fmt::format("the name '{}' is already used by a [[shape]] of the machine file", name));
        } else if (cell_.frames.find(name)) {
            section.fail("name", fmt::format("the name '{}' is already used, by the machine or above", name));
        }
        return name;
    }

    std::size_t find_frame(TomlSection& section, std::string_view key, std::string_view name) {
        if (const auto frame = cell_.frames.find(name)) return *frame;
        const std::vector<std::string_view> names = cell_.frames.names();
        const auto nearest = text::nearest_name(name, names);
        const std::string hint = nearest ? fmt::format("did you mean '{}'?", *nearest)
                                         : fmt::format("known names: {}", text::joined(names, ", "));
        section.fail(key, fmt::format("'{}' is not defined above; {}", name, hint));
        return 0;
    }

    std::size_t add_frame(TomlSection& section, std::string name, std::size_t parent) {
        const rrs::CartPos pose = read_pose(error_, section.table("frame"));
        return cell_.frames.add(std::move(name), parent, pose);
    }

    std::size_t read_parent(TomlSection& section) {
        if (!section.has("attached_to")) return 0;
        return find_frame(section, "attached_to", section.text("attached_to"));
    }

    void read_frame(const toml::table& table) {
        TomlSection section(error_, table, "[[frame]]", kFrameKeys);
        std::string name = read_name(section);
        add_frame(section, std::move(name), read_parent(section));
    }

    void read_object(const toml::table& table) {
        TomlSection section(error_, table, "[[object]]", kObjectKeys);
        std::string name = read_name(section);
        const Role role = section.choice("role", 1, kRoles) == 0 ? Role::workpiece : Role::fixture;
        add_item(section, table, std::move(name), role, read_parent(section));
    }

    void read_link_shape(const toml::table& table) {
        TomlSection section(error_, table, "[[shape]]", kShapeKeys);
        std::string name = read_name(section);
        const std::string on = section.text("on");
        const bool jet = on == "jet";
        const std::size_t parent = find_frame(section, "on", jet ? "tool" : on);
        if (!cell_.frames.is_machine_frame(parent) || on == "world") {
            section.fail("on",
                         "'on' must be \"base\", a letter of an axis, \"tool\", \"work\" or \"jet\"; a body "
                         "in the world must be an [[object]]");
        }
        add_item(section, table, std::move(name), jet ? Role::jet : Role::machine, parent);
    }

    void add_item(TomlSection& section, const toml::table& table, std::string name, Role role,
                  std::size_t parent) {
        const auto form = machine::read_shape(error_, section, table, folder_, files_.files);
        const std::size_t frame = add_frame(section, name, parent);
        if (!form) return;
        auto shape = make_shape(*form, files_);
        if (!shape) return section.fail("shape", shape.error().message);
        items_by_name_.emplace(name, cell_.items.size());
        cell_.items.push_back({std::move(name), role, *std::move(shape), frame});
    }

    std::optional<std::size_t> find_item(std::string_view name) const {
        const auto found = items_by_name_.find(name);
        if (found == items_by_name_.end()) return std::nullopt;
        return found->second;
    }

    FirstError& error_;
    std::filesystem::path folder_;
    const MeshFiles& files_;
    std::size_t machine_items_;  ///< The first so many items are the machine's.
    Cell cell_;
    std::map<std::string, std::size_t, std::less<>> items_by_name_;  ///< The first of a name.
};

/// Returns the `on` values of a cell's [[shape]]s, even if the tables are not right.
std::set<std::string, std::less<>> replaced_attachments(const toml::table& root) {
    std::set<std::string, std::less<>> attachments;
    const toml::array* shapes = root.get_as<toml::array>("shape");
    if (shapes == nullptr) return attachments;
    for (const toml::node& node : *shapes) {
        const toml::table* table = node.as_table();
        if (table == nullptr) continue;
        if (const auto on = table->get_as<std::string>("on")) attachments.insert(on->get());
    }
    return attachments;
}

/// The tool of a cell replaces that of the machine file, and the same applies to the jet.
machine::Machine remove_replaced_shapes(const machine::Machine& machine, const toml::table& root) {
    const auto attachments = replaced_attachments(root);
    machine::Machine left = machine;
    left.shapes.clear();
    std::map<std::size_t, std::size_t> numbers;
    for (std::size_t i = 0; i < machine.shapes.size(); ++i) {
        const std::string& on = machine.shapes[i].on;
        if ((on == "tool" || on == "jet") && attachments.contains(on)) continue;
        numbers.emplace(i, left.shapes.size());
        left.shapes.push_back(machine.shapes[i]);
    }
    left.ignored.clear();
    for (const auto& [a, b] : machine.ignored) {
        if (numbers.contains(a) && numbers.contains(b))
            left.ignored.emplace_back(numbers.at(a), numbers.at(b));
    }
    return left;
}

}  // namespace

Result<CellFiles> read_cell_files(std::string_view toml_text, std::string_view file_name) {
    FirstError error(file_name);
    const toml::table root = base::parse_toml(error, toml_text);
    const std::filesystem::path folder = std::filesystem::path(file_name).parent_path();
    CellFiles files;
    const toml::table* head = root.get_as<toml::table>("cell");
    if (head != nullptr) {
        TomlSection section(error, *head, "[cell]", kCellTableKeys);
        if (section.has("machine")) files.machine = folder / section.text("machine");
        if (section.has("machine_data")) files.machine_data = folder / section.text("machine_data");
    }
    if (error.text()) return tl::unexpected(*error.text());
    return files;
}

Result<Cell> read_cell(std::string_view toml_text, std::string_view file_name,
                       const machine::Machine& machine, std::span<const std::string> conveyors,
                       const MeshFiles& files, std::vector<std::string>* errors) {
    FirstError error(file_name);
    const toml::table root = base::parse_toml(error, toml_text);
    const machine::Machine remaining_machine = remove_replaced_shapes(machine, root);
    auto bare_cell = make_machine_cell(remaining_machine, files);
    if (!bare_cell) return bare_cell;
    bare_cell->replaced = machine.shapes.size() - remaining_machine.shapes.size();
    CellReader reader(error, std::filesystem::path(file_name).parent_path(), files, *std::move(bare_cell));
    for (const std::string& conveyor : conveyors) reader.add_conveyor(conveyor, root);
    Cell cell = reader.read(root);
    if (errors != nullptr) *errors = error.all();
    if (error.text()) return tl::unexpected(*error.text());
    return cell;
}

}  // namespace gsim::cell
