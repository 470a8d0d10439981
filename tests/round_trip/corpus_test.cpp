// The fidelity table of docs/round-trip.md: the shared corpus, run, recorded, written for each control and
// run again. GSIM_ROUND_TRIP_TABLE=FILE writes the table and what became of each file.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <map>

#include <fmt/format.h>

#include "tests/round_trip/way_round.h"

namespace gsim::round_trip::corpus_test {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> kNoPrograms = {".gz",  ".tsv", ".md", ".tbl",
                                                         ".var", ".txt", ".lua"};

std::vector<fs::path> programs(const fs::path& folder) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        const bool other = std::find(kNoPrograms.begin(), kNoPrograms.end(), extension) != kNoPrograms.end();
        if (entry.is_regular_file() && !other && entry.path().filename() != "expected")
            found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// File that does not come back as it was, and the reason (docs/round-trip.md).
struct Exception {
    std::string_view post, file;
};

constexpr std::array<Exception, 2> kExceptions = {{
    // Chords of 0.1 mm lose their directions in three digits.
    {"ab9", "flowsnake.ngc"},
    {"ab9", "systems.ngc"},
}};

bool is_exception(std::string_view post, std::string_view file) {
    return std::any_of(kExceptions.begin(), kExceptions.end(),
                       [&](const Exception& each) { return each.post == post && file.ends_with(each.file); });
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

class Table {
  public:
    void add(const std::string& file, const std::string& post, const Outcome& outcome) {
        static constexpr std::array<const char*, 6> kNames = {"same",    "differs",      "not written",
                                                              "not run", "not recorded", "does not run"};
        const std::string extension = kNames[static_cast<std::size_t>(outcome.extension)];
        ++counts_[post][extension];
        if (outcome.by_lines) ++counts_[post]["with arcs by lines"];
        const auto print_difference = [&](const char* what, const std::string& difference) {
            if (!difference.empty())
                lines_.push_back(fmt::format("{}\t{}\t{}\t{}\t{}", post, extension, file, what, difference));
        };
        print_difference("positions", outcome.differences.positions);
        print_difference("times", outcome.differences.times);
        print_difference("events", outcome.differences.events);
        print_difference("", first_line(outcome.message));
    }
    std::string text() const {
        std::string text;
        for (const auto& [post, counts] : counts_) {
            text += fmt::format("{}:", post);
            for (const auto& [extension, count] : counts) text += fmt::format(" {} {};", count, extension);
            text += "\n";
        }
        for (const std::string& line : lines_) text += line + "\n";
        return text;
    }

  private:
    std::map<std::string, std::map<std::string, int>> counts_;
    std::vector<std::string> lines_;
};

class Corpus : public apps::Apps {
  protected:
    const fs::path& folder() const { return folder_; }
};

// In the dialect and on the axes with which it runs, the fewest first.
std::optional<WayRound> begun(const fs::path& folder, const fs::path& program, std::string& message) {
    for (const char* dialect : {"rs274ngc", "ab9"}) {
        for (const char* axes : {"XYZ", "XYZABC"}) {
            WayRound round(folder, axes);
            if (round.begin(program, dialect)) return round;
            if (message.empty()) message = round.message();
        }
    }
    return std::nullopt;
}

TEST_F(Corpus, IsReproducedByRoundTrip) {
    const char* const corpus = std::getenv("GSIM_CORPUS");
    if (corpus == nullptr || !fs::is_directory(corpus)) GTEST_SKIP() << "no folder GSIM_CORPUS";
    Table strict, going_on;
    for (const fs::path& program : programs(corpus)) {
        const std::string name = program.lexically_relative(corpus).string();
        std::string message;
        const std::optional<WayRound> round = begun(folder(), program, message);
        if (!round) {
            strict.add(name, "all", {Ending::does_not_run, {}, message, false});
            continue;
        }
        for (const Way& write_mode : kWays) {
            const Outcome outcome = round->end(write_mode);
            strict.add(name, write_mode.post, outcome);
            EXPECT_TRUE(outcome.extension != Ending::differs || is_exception(write_mode.post, name))
                << write_mode.post << " " << name << "\n"
                << outcome.differences.positions << "\n"
                << outcome.differences.times << "\n"
                << outcome.differences.events;
            EXPECT_NE(outcome.extension, Ending::not_run) << write_mode.post << " " << name << "\n"
                                                          << outcome.message;
            if (outcome.extension == Ending::not_written)
                going_on.add(name, write_mode.post, round->end(write_mode, {"--continue-on-unknown"}));
        }
    }
    if (const char* const table = std::getenv("GSIM_ROUND_TRIP_TABLE"); table != nullptr)
        std::ofstream(table) << strict.text() << "\nwith --continue-on-unknown\n" << going_on.text();
}

}  // namespace
}  // namespace gsim::round_trip::corpus_test
