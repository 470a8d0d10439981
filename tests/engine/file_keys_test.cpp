// Comparison of the guides of forms with the readers of files: the readers accept and reject what the guides
// say.
#include "engine/file_keys.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "base/text/json.h"
#include "base/toml/toml_editor.h"
#include "collision/cell/cell_file.h"
#include "machine/file/controller_file.h"
#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"
#include "tests/engine/keyed_documents.h"

namespace gsim::engine {
namespace {

using base::TomlEditor;
using base::TomlPath;
using nlohmann::json;

constexpr const char* kUnknown = "qqqqqqqqqqqq";

constexpr std::array kFiles{ConfigFileKind::machine, ConfigFileKind::cell, ConfigFileKind::controller};

std::string document(ConfigFileKind file) {
    if (file == ConfigFileKind::machine) return kMachine;
    return file == ConfigFileKind::cell ? kCell : kController;
}

const os::Files& files() {
    static const os::CallbackFiles kGiven([](const std::string&) {
        return "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
               "endfacet\nendsolid t\n";
    });
    return kGiven;
}

Result<cell::Cell> cell_of(const std::string& text, std::vector<std::string>* errors) {
    const auto machine = machine::read_machine(machine::built_in_machine_toml(), "built in").value();
    const cell::MeshFiles meshes{
        .files = files(), .read_solid = [](const std::filesystem::path&, double) -> Result<solid::Mesh> {
            return solid::Mesh{.vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
        }};
    return cell::read_cell(text, "c.toml", machine, {}, meshes, errors);
}

/// Returns all errors that the reader of such files finds.
std::vector<std::string> find_errors(ConfigFileKind file, const std::string& text) {
    std::vector<std::string> errors;
    if (file == ConfigFileKind::machine) {
        machine::FileMessages messages;
        (void)machine::read_machine(text, "m.toml", files(), &messages);
        errors = std::move(messages.errors);
    } else if (file == ConfigFileKind::cell) {
        if (const auto named = cell::read_cell_files(text, "c.toml"); !named)
            errors.push_back(named.error().message);
        std::vector<std::string> others;
        (void)cell_of(text, &others);
        errors.insert(errors.end(), others.begin(), others.end());
    } else if (const auto rules = machine::read_controller(text, "own.toml", "own"); !rules) {
        errors.push_back(rules.error().message);
    }
    return errors;
}

/// Returns the error for this key, which is not right as it is, or an empty text if it is right.
std::string rejection(const std::vector<std::string>& errors, const std::string& key) {
    for (const std::string& error : errors) {
        for (const char* words : {"' must be", "' must hold", "' must name", "' is a diameter"}) {
            if (error.find("'" + key + words) != std::string::npos) return error;
        }
    }
    return {};
}

/// A key of the guide in a document that has its table.
class KeyOfDocument {
  public:
    KeyOfDocument(ConfigFileKind file, const json& table, const json& key)
        : file_(file), name_(key["name"]), edit_(TomlEditor::read(document(file), "d.toml").value()) {
        for (const json& step : table["at"]) {
            const json* there = at(path_);
            path_.emplace_back(step.get<std::string>());
            if (!table["many"].get<bool>() || path_.size() > 1) continue;
            path_.emplace_back(find_entry(table, (*there)[step.get<std::string>()]));
        }
        // A joint lies by its row, or by these.
        if ((name_ == "direction" || name_ == "frame") && at(base::below(path_, "dh")) != nullptr) {
            EXPECT_TRUE(edit_.remove(base::below(path_, "dh")));
        }
        // The form of a body is one of several keys.
        const bool form = path_.size() == 3 && table["at"][1] == "shape";
        if (form) {
            EXPECT_TRUE(edit_.remove(base::below(path_, "sphere_mm")));
        }
        if (form && name_ == "scale") set_at("mesh", "part.stl");
        if (form && name_ == "tolerance_mm") set_at("mesh", "part.step");
    }

    void set(const json& value) { set_at(name_, value); }
    void remove() {
        const TomlPath path = base::below(path_, name_);
        if (at(path) == nullptr) return;
        EXPECT_TRUE(edit_.remove(path));
    }
    /// Returns the error of the key if it has this value.
    std::string rejected(const json& value) {
        set(value);
        return rejection(errors(), name_);
    }
    /// "inf" is a number only in the position of one.
    std::string refused_infinite(const char* infinite) {
        set(1.5);
        return rejected(infinite);
    }
    std::vector<std::string> errors() const { return find_errors(file_, edit_.text()); }
    const std::string& text() const { return edit_.text(); }

  private:
    const json* at(const TomlPath& path) const {
        const json* value = &edit_.value();
        for (const base::TomlStep& step : path) {
            if (const auto* index = std::get_if<std::size_t>(&step)) {
                value = &(*value)[*index];
            } else {
                const auto found = value->find(std::get<std::string>(step));
                if (found == value->end()) return nullptr;
                value = &*found;
            }
        }
        return value;
    }

    static std::size_t find_entry(const json& table, const json& entries) {
        for (std::size_t i = 0; i < entries.size(); ++i) {
            const bool has_inner = table["at"].size() < 2 || entries[i].contains(table["at"][1]);
            const bool fits = !table.contains("where") || entries[i]["kind"] == table["where"]["kind"];
            if (has_inner && fits) return i;
        }
        ADD_FAILURE() << table["at"];
        return 0;
    }

    void set_at(const std::string& key, const json& value) {
        const TomlPath path = base::below(path_, key);
        const json* old = at(path);
        if (old != nullptr && old->is_structured()) {
            EXPECT_TRUE(edit_.remove(path));
        }
        const auto done = edit_.set(path, value);
        EXPECT_TRUE(done) << name_ << ": " << done.error().message;
    }

    ConfigFileKind file_;
    std::string name_;
    TomlEditor edit_;
    TomlPath path_;
};

template <typename Visitor>
void for_each_table(const Visitor& visit) {
    for (const ConfigFileKind file : kFiles) {
        const json tables = text::parse_json<json>(file_keys_json(file));
        for (const json& table : tables) {
            SCOPED_TRACE(table["at"].dump());
            visit(file, table);
        }
    }
}

template <typename Visitor>
void for_each_key(const Visitor& visit) {
    for_each_table([&](ConfigFileKind file, const json& table) {
        for (const json& key : table["keys"]) {
            SCOPED_TRACE(key.dump());
            visit(file, table, key);
        }
    });
}

TEST(FileKeys, MatchKeysOfReaders) {
    std::size_t tables = 0;
    for_each_table([&](ConfigFileKind file, const json& table) {
        ++tables;
        std::set<std::string> listed;
        for (const json& key : table["keys"]) {
            if (!key.contains("pattern")) listed.insert(key["name"].get<std::string>());
        }
        KeyOfDocument unknown(file, table, {{"name", kUnknown}});
        unknown.set(1);
        std::set<std::string> taken;
        for (const std::string& error : unknown.errors()) {
            const std::string head = "known keys: ";
            const std::size_t begin = error.find(head);
            if (error.find(kUnknown) == std::string::npos || begin == std::string::npos) continue;
            std::string remainder = error.substr(begin + head.size()) + ", ";
            for (std::size_t end = remainder.find(", "); end != std::string::npos;
                 end = remainder.find(", ")) {
                taken.insert(remainder.substr(0, end));
                remainder.erase(0, end + 2);
            }
        }
        EXPECT_EQ(listed, taken) << unknown.text();
    });
    EXPECT_GT(tables, 30U);
}

TEST(FileKeys, HaveKindsOfReaders) {
    for_each_key([](ConfigFileKind file, const json& table, const json& key) {
        // It belongs to a file of robots, and is checked where that is read.
        if (file == ConfigFileKind::cell && (key["name"] == "robot" || key["name"] == "conveyor")) return;
        const bool text = key["kind"] == "text";
        KeyOfDocument wrong(file, table, key);
        EXPECT_NE(wrong.rejected(text ? json(3) : json("x")), "") << wrong.text();
        if (key["kind"] != "switch") return;
        for (const bool value : {true, false}) EXPECT_EQ(KeyOfDocument(file, table, key).rejected(value), "");
    });
}

TEST(FileKeys, HaveRangesOfReaders) {
    for_each_key([](ConfigFileKind file, const json& table, const json& key) {
        if (key["kind"] != "number") return;
        KeyOfDocument number(file, table, key);
        const json others = key.value("or", json::array());
        const auto has = [&](const json& value) {
            return std::find(others.begin(), others.end(), value) != others.end();
        };
        const double min = key.value(key.contains("min") ? "min" : "above", 0.0);
        const double max = key.value(key.contains("max") ? "max" : "below", 0.0);
        EXPECT_EQ(number.rejected(min).empty(), key.contains("min"));
        EXPECT_EQ(number.rejected(max).empty(), key.contains("max"));
        EXPECT_EQ(number.rejected(std::min(min + 1, (min + max) / 2)), "");
        EXPECT_NE(number.rejected(min > 0 ? min / 2 : min - 1), "");
        EXPECT_NE(number.rejected(2 * max + 1), "");
        if (min > 0) {
            EXPECT_EQ(number.rejected(0).empty(), has(0));
        }
        EXPECT_EQ(number.refused_infinite("inf").empty(), has("inf"));
        EXPECT_EQ(number.refused_infinite("-inf").empty(), has("-inf"));
        EXPECT_EQ(number.rejected(min + 1.5).empty(), !key.contains("integer") && min + 1.5 < max);
    });
}

TEST(FileKeys, HaveChoicesOfReaders) {
    for_each_key([](ConfigFileKind file, const json& table, const json& key) {
        if (!key.contains("choices")) return;
        KeyOfDocument word(file, table, key);
        for (const json& options : key["choices"]) EXPECT_EQ(word.rejected(options), "");
        if (key.contains("open")) return;
        std::string error = word.rejected(kUnknown);
        if (key["name"] == "kind" && key["choices"].size() == 2)
            error = "\"linear\" or \"rotary\"";  // comes first
        std::size_t named = 0;
        for (const json& options : key["choices"]) {
            const auto text = options.get<std::string>();
            if (error.find("\"" + text + "\"") != std::string::npos ||
                error.find(" " + text) != std::string::npos)
                ++named;
        }
        EXPECT_EQ(named, key["choices"].size()) << error;
        const auto marks = static_cast<std::size_t>(std::count(error.begin(), error.end(), '"'));
        EXPECT_TRUE(marks == 2 * named || key["name"] == "letter") << error;
    });
}

TEST(FileKeys, AreRequiredIfReadersRequireThem) {
    for_each_key([](ConfigFileKind file, const json& table, const json& key) {
        KeyOfDocument gone(file, table, key);
        gone.remove();
        const auto errors = gone.errors();
        const std::string lacks = "lacks the key '" + key["name"].get<std::string>() + "'";
        const bool lacking = std::any_of(errors.begin(), errors.end(), [&](const std::string& error) {
            return error.find(lacks) != std::string::npos;
        });
        EXPECT_EQ(lacking, key.contains("required")) << gone.text();
    });
}

/// Returns the contents of a cell, as far as keys with defaults set them.
std::vector<double> cell_values(const cell::Cell& cell) {
    std::vector<double> values{cell.clearance_mm};
    for (const cell::Item& item : cell.items) {
        values.push_back(static_cast<double>(item.role));
        values.push_back(static_cast<double>(item.frame));
    }
    return values;
}

TEST(FileKeys, HaveDefaultsOfReaders) {
    std::size_t defaults = 0;
    for_each_key([&](ConfigFileKind file, const json& table, const json& key) {
        if (!key.contains("default") || file == ConfigFileKind::controller) return;
        ++defaults;
        KeyOfDocument given(file, table, key);
        KeyOfDocument left_out(file, table, key);
        left_out.remove();
        if (key["kind"] == "number") given.set(1.5);  // "inf" is a number only in the position of one
        given.set(key["default"]);
        if (file == ConfigFileKind::machine) {
            const auto with = machine::read_machine(given.text(), "m.toml", files());
            const auto without = machine::read_machine(left_out.text(), "m.toml", files());
            ASSERT_TRUE(with && without) << (with ? without.error().message : with.error().message);
            EXPECT_TRUE(*with == *without) << given.text();
        } else {
            const auto with = cell_of(given.text(), nullptr);
            const auto without = cell_of(left_out.text(), nullptr);
            ASSERT_TRUE(with && without) << (with ? without.error().message : with.error().message);
            EXPECT_EQ(cell_values(*with), cell_values(*without));
        }
    });
    EXPECT_GT(defaults, 80U);
}

TEST(FileKeys, AreDescribedInDocs) {
    const auto page = [](const std::string& name) {
        std::ifstream file(tests::source_path("docs/") + name);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    const std::string pages = page("machine-file.md") + page("cell-file.md");
    for_each_key([&](ConfigFileKind /*file*/, const json& table, const json& key) {
        EXPECT_FALSE(key["meaning"].get<std::string>().empty());
        if (table.contains("where") && table["where"]["kind"] == "rotary")
            return;                                                        // described by the linear ones
        if (table["at"].size() == 2 && table["at"][1] == "stops") return;  // words of programs, "M48 to M51"
        EXPECT_NE(pages.find(key["name"].get<std::string>()), std::string::npos);
    });
}

TEST(FileKeys, HaveUnitsMatchingTheirNames) {
    const json tables = text::parse_json<json>(file_keys_json(ConfigFileKind::machine));
    std::set<std::string> units;
    for (const json& table : tables) {
        for (const json& key : table["keys"]) {
            if (key.contains("unit")) units.insert(key["unit"].get<std::string>());
            const auto name = key["name"].get<std::string>();
            if (key["kind"] != "number" || name.find("_mm") == std::string::npos) continue;
            if (name.find("_per_mm") != std::string::npos) continue;  // "N/mm"
            EXPECT_EQ(key["unit"].get<std::string>().substr(0, 2), "mm") << name;
        }
    }
    EXPECT_EQ(units,
              (std::set<std::string>{"%",      "1/s",  "deg",        "deg/s", "deg/s2", "deg/s3", "mm",
                                     "mm/min", "mm/s", "mm/s2",      "mm/s3", "s",      "N",      "N/(mm/s)",
                                     "N/mm",   "Nm",   "Nm/(deg/s)", "kg",    "kg m2",  "kg/m3",  "m/s2"}));
}

}  // namespace
}  // namespace gsim::engine
