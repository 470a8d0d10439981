// Random data sets survive writing and reading; random changes leave the other lines as they are; no damage
// to a file makes half of it count.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/data/machine_data_document.h"
#include "machine/file/machine_file.h"

namespace gsim::machine::machine_data_random_test {
namespace {

std::vector<Axis> axes() {
    return read_machine(built_in_machine_toml(), "").value().axes;
}

class RandomData {
  public:
    explicit RandomData(unsigned seed) : random_(seed) {}

    int random_integer(int min, int max) { return std::uniform_int_distribution<int>(min, max)(random_); }
    bool chance(double p) { return std::bernoulli_distribution(p)(random_); }

    // Returns a number of any size, some with many digits and some with few.
    double number() {
        const double value =
            std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random_), random_integer(-40, 29));
        return chance(0.5) ? std::round(value * 1000) / 1000 : value;
    }

    AxisValues point() {
        AxisValues values{{'X', number()}, {'Y', number()}, {'Z', number()}};
        if (chance(0.5)) values['B'] = number();
        if (values.contains('B') && chance(0.5)) values['C'] = number();
        return values;
    }

    Tool tool() {
        Tool tool{.length_mm = number(), .diameter_mm = number()};
        if (chance(0.3)) tool.length_wear_mm = number();
        if (chance(0.3)) tool.diameter_wear_mm = number();
        if (chance(0.3)) tool.offsets = {{'X', number()}, {'C', number()}};
        if (chance(0.3)) tool.front_angle_deg = number();
        tool.orientation = random_integer(0, 9);
        tool.kind = std::array{ToolKind::unspecified, ToolKind::cutter, ToolKind::jet}.at(
            static_cast<std::size_t>(random_integer(0, 2)));
        return tool;
    }

    Zone zone(int zone_number) {
        Zone zone{.number = zone_number};
        for (auto& limits : zone.limits) {
            if (chance(0.3)) continue;
            const double low = number();
            limits = ZoneLimits{low, low + 1e-3 * (1 + std::abs(low)) + std::abs(number())};
        }
        if (!zone.limits[0]) zone.limits[0] = ZoneLimits{-1, 1};
        return zone;
    }

    Zone security_zone(int zone_number) {
        Zone random = zone(zone_number);
        if (chance(0.5)) random.kind = ZoneKind::leave_forbidden;
        random.active_at_start = chance(0.5);
        if (chance(0.5)) random.switch_number = random_integer(1, 99);
        return random;
    }

    std::string frame() {
        const int code = random_integer(0, 20);
        if (code < 6) return std::to_string(54 + code);
        return code < 9 ? fmt::format("59.{}", code - 5) : std::to_string(random_integer(505, 599));
    }

    /// For some of the points: no two are the same in any case.
    std::map<int, std::string> names(const std::map<int, AxisValues>& points) {
        std::map<int, std::string> names;
        for (const auto& [number, point] : points) {
            if (chance(0.5)) names[number] = fmt::format("{}{}", chance(0.5) ? "CLAMP_" : "Vise", number);
        }
        return names;
    }

    MachineData data() {
        MachineData data;
        for (int i = random_integer(0, 6); i > 0; --i) data.offsets[frame()] = point();
        for (int i = random_integer(0, 3); i > 0; --i) data.fixed[random_integer(1, 99999)] = point();
        for (int i = random_integer(0, 3); i > 0; --i) data.references[random_integer(1, 9)] = point();
        data.fixed_names = names(data.fixed);
        data.reference_names = names(data.references);
        for (int i = random_integer(0, 3); i > 0; --i) data.homes[random_integer(2, 4)] = point();
        for (int i = random_integer(0, 5); i > 0; --i) data.tools[random_integer(1, 999)] = tool();
        for (int i = random_integer(0, 5); i > 0; --i) data.variables[random_integer(1, 5601)] = number();
        for (int i = random_integer(0, 3); i > 0; --i)
            data.aliases[fmt::format("Name{}", i)] = fmt::format("M{}", random_integer(0, 99));
        for (int i = random_integer(0, 4); i > 0; --i) data.security_zones[i] = security_zone(i);
        if (chance(0.5)) data.working_zone = zone(1);
        if (data.working_zone) data.working_zone->kind = ZoneKind::working;
        return data;
    }

    /// A file of such data, with remarks and odd blanks, entries in inches, and line ends of both kinds.
    std::string file() {
        std::string out;
        const std::string text = write_machine_data(data(), axes_);
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = text.find('\n', at);
            out += odd_line(text.substr(at, end - at));
            at = end + 1;
        }
        return out;
    }

  private:
    std::string odd_line(const std::string& line) {
        std::string out = chance(0.2) ? "  " : "";
        for (const char c : line) out += c == ' ' && chance(0.2) ? '\t' : c;
        const bool point = line.find("  ") != std::string::npos && line.find('=') == std::string::npos;
        if (point && std::isdigit(static_cast<unsigned char>(line[0])) &&
            line.find('e') == std::string::npos && std::count(line.begin(), line.end(), ' ') >= 6 &&
            chance(0.3)) {
            out += " Metric";
        }
        if (chance(0.2)) out += "   ; remark 5 # ENDFILE";
        out += chance(0.5) ? "\r\n" : "\n";
        if (chance(0.1)) out += "\n# between\r\n";
        return out;
    }

    std::mt19937 random_;
    std::vector<Axis> axes_ = axes();
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        lines.push_back(text.substr(at, end - at));
        at = end;
    }
    return lines;
}

TEST(MachineDataRandom, DataRoundTripThroughFile) {
    const std::vector<Axis> machine = axes();
    RandomData random(11);
    for (int i = 0; i < 1000; ++i) {
        const MachineData data = random.data();
        const std::string text = write_machine_data(data, machine);
        const auto read = read_machine_data(text, "f", machine);
        ASSERT_TRUE(read) << read.error().message << '\n' << text;
        ASSERT_EQ(*read, data) << text;
        MachineDataDocument document(machine);
        const auto updated = document.update(data);
        ASSERT_TRUE(updated) << updated.error().message;
        ASSERT_EQ(document.text(), text);
    }
}

TEST(MachineDataRandom, FilesKeepEachByte) {
    const std::vector<Axis> machine = axes();
    RandomData random(12);
    for (int i = 0; i < 300; ++i) {
        const std::string text = random.file();
        auto document = MachineDataDocument::read(text, "f", machine);
        ASSERT_TRUE(document) << document.error().front().message << '\n' << text;
        ASSERT_EQ(document->text(), text);
        ASSERT_TRUE(document->update(document->data()));
        ASSERT_EQ(document->text(), text) << "data that are equal change nothing";
    }
}

// The update is from any data to any other; in inches too, although a number of mm may have no exact one of
// inches.
TEST(MachineDataRandom, UpdateStoresNewData) {
    const std::vector<Axis> machine = axes();
    RandomData random(13);
    for (int i = 0; i < 300; ++i) {
        auto document = MachineDataDocument::read(random.file(), "f", machine).value();
        const bool inch = random.chance(0.5);
        if (inch) {
            ASSERT_TRUE(document.convert(LengthUnit::inch));
        }
        const MachineData data = random.data();
        const auto updated = document.update(data);
        ASSERT_TRUE(updated) << updated.error().message << '\n' << document.text();
        const std::string once = document.text();
        ASSERT_TRUE(document.update(document.data()));
        ASSERT_EQ(document.text(), once);
        for (const auto& [number, tool] : data.tools) {
            const double length = document.data().tools.at(number).length_mm;
            ASSERT_NEAR(length, tool.length_mm, 1e-15 * std::abs(length)) << once;
            if (!inch) {
                ASSERT_EQ(length, tool.length_mm);
            }
        }
        for (const auto& [number, zone] : data.security_zones)
            ASSERT_EQ(document.data().security_zones.at(number).switch_number, zone.switch_number) << once;
        ASSERT_EQ(document.data().aliases, data.aliases);
        ASSERT_EQ(document.data().fixed_names, data.fixed_names) << once;
        ASSERT_EQ(document.data().reference_names, data.reference_names) << once;
        ASSERT_EQ(document.data().variables, data.variables);
    }
}

TEST(MachineDataRandom, EditChangesOnlyItsLine) {
    const std::vector<Axis> machine = axes();
    RandomData random(14);
    int edits = 0;
    for (int i = 0; i < 300; ++i) {
        const std::string text = random.file();
        auto document = MachineDataDocument::read(text, "f", machine).value();
        for (const DataSection section : kDataSections) {
            const std::vector<DataRow> rows = document.rows(section);
            if (rows.empty() || section == DataSection::alias) continue;
            const std::string id = rows[rows.size() / 2].id;
            const std::size_t line = document.location(section, id).line;
            const auto before = lines_of(document.text());
            const DataField& field = document.rules().of(section).fields[0];
            const std::string value =
                field.may_be_unlimited ? "-1e9" : std::to_string(random.random_integer(-9999, 9999));
            if (!document.set(section, id, {{field.name, value}})) continue;  // a zone open there
            ++edits;
            auto after = lines_of(document.text());
            ASSERT_EQ(after.size(), before.size());
            EXPECT_EQ(document.find(section, id)->values[0], value);
            after[line - 1] = before[line - 1];
            ASSERT_EQ(after, before);
        }
    }
    EXPECT_GT(edits, 500);
}

std::string mangled(RandomData& random, std::string text) {
    const auto below = [&](std::size_t end) {
        return static_cast<std::size_t>(random.random_integer(0, static_cast<int>(end) - 1));
    };
    for (int changes = random.random_integer(1, 4); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = below(text.size());
        const std::size_t count = 1 + below(20);
        switch (random.random_integer(0, 5)) {
            case 0: text.erase(at, count); break;
            case 1: text[at] = static_cast<char>(below(256)); break;
            case 2: std::swap(text[at], text[below(text.size())]); break;
            case 3:
                text.insert(at, std::string(count, static_cast<char>('0' + random.random_integer(0, 9))));
                break;
            case 4: text.insert(at, 1, '\0'); break;
            default: text.insert(at, text.substr(below(text.size()), count)); break;
        }
    }
    return text;
}

// Either the complete file is right, comes back as it is and means the same if rewritten, or the error has a
// source location.
TEST(MachineDataRandom, CorruptFilesAreReadCompletelyOrRejected) {
    const std::vector<Axis> machine = axes();
    RandomData random(15);
    int right = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::string text = mangled(random, random.file());
        auto document = MachineDataDocument::read(text, "f", machine);
        if (!document) {
            for (const Error& error : document.error())
                EXPECT_TRUE(error.message.starts_with("f:") && error.message.find('\n') == std::string::npos)
                    << error.message;
            ASSERT_FALSE(document.error().empty());
            EXPECT_EQ(read_machine_data(text, "f", machine).error(), document.error().front());
            continue;
        }
        ++right;
        ASSERT_EQ(document->text(), text);
        ASSERT_EQ(read_machine_data(write_machine_data(document->data(), machine), "f", machine).value(),
                  document->data())
            << text;
    }
    EXPECT_GT(right, 100);
    EXPECT_LT(right, 2900);
}

}  // namespace
}  // namespace gsim::machine::machine_data_random_test
