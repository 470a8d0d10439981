// gsim-batch and gsim-optimise if their output does not fit on the disk. A limit on the size of files
// simulates a full disk, because it needs no permission. With a byte more of space, the error comes a call
// later.

#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "batch/store/sqlite.h"
#include "tests/apps/run_program.h"
#include "tests/batch/slide.h"
#include "tests/build_files/build_files.h"

namespace gsim::batch::full_disk_test {
namespace {

using apps::Ended;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;

constexpr const char* kReason = "File too large";
constexpr int kStep_kib = 4;  // a page of SQLite's
constexpr int kMost_kib = 400;

class FullDisk : public apps::Apps {
  protected:
    FullDisk() {
        write("m.toml", kSlide);
        write_program("p.ngc", 10);
        write_program("p1.ngc", 11);
        write_program("p2.ngc", 12);
    }

    void write_program(const std::string& name, int distance_mm) const {
        write(name, fmt::format("G21 G90 G94 F600\nG1 X{}\nM2\n", distance_mm));
    }

    /// Runs a program with files of at most `room_kib` KiB. Standard error is not limited.
    Ended within(int room_kib, const std::string& program, const std::string& words) const {
        const std::string command =
            fmt::format("set -o pipefail; (trap '' XFSZ; ulimit -f {}; exec {} {}) 2>&1 >/dev/null | cat >&2",
                        room_kib, program, words);
        return apps::run_program("/bin/bash", {"-c", command}, folder_);
    }
    Ended batch(const std::vector<std::string>& words) const {
        return apps::run_program(tests::program_path("gsim-batch"), words, folder_);
    }

    /// Returns the result of each program of the latest batch.
    std::map<std::string, std::string> rows(const std::string& file) const {
        auto results = Database::open((folder_ / file).string(), true);
        EXPECT_TRUE(results) << results.error().message;
        auto statement = results->prepare("SELECT program, status, cycle_time_s, extents FROM latest");
        EXPECT_TRUE(statement) << statement.error().message;
        std::map<std::string, std::string> found;
        while (statement->step().value_or(false))
            found[std::string(statement->text(0))] =
                fmt::format("{} {} {}", statement->text(1), statement->number(2), statement->text(3));
        return found;
    }

    void remove_results() const {
        for (const char* extension : {"", "-wal", "-shm", "-journal"})
            std::filesystem::remove(folder_ / (std::string("r.sqlite") + extension));
    }
};

const std::string kWords = "--machine m.toml p.ngc p1.ngc p2.ngc --reports --results r.sqlite";

TEST_F(FullDisk, IsReportedAndNextRunCompletes) {
    const std::vector<std::string> good = {"--machine", "m.toml",    "p.ngc",     "p1.ngc",
                                           "p2.ngc",    "--reports", "--results", "clean.sqlite"};
    ASSERT_EQ(batch(good).status, 0);
    const auto is_clean = rows("clean.sqlite");
    ASSERT_EQ(is_clean.size(), 3U);
    int full = 0, complete = 0;
    for (int room_kib = 0; room_kib <= kMost_kib && complete < 2; room_kib += kStep_kib) {
        remove_results();
        const Ended ended = within(room_kib, tests::program_path("gsim-batch"), kWords);
        ++(ended.status == 0 ? complete : full);
        if (ended.status != 0) {
            EXPECT_EQ(ended.status, 2) << room_kib << ": " << ended.err;
            EXPECT_THAT(ended.err, HasSubstr("'r.sqlite': ")) << room_kib;
        }
        const Ended next = within(kMost_kib, tests::program_path("gsim-batch"), kWords);
        EXPECT_EQ(next.status, 0) << room_kib << ": " << next.err;
        EXPECT_EQ(rows("r.sqlite"), is_clean) << room_kib;
    }
    EXPECT_GT(full, 10) << "it was not cut off in its rows";
    EXPECT_EQ(complete, 2) << "with enough room all is well";
}

// Existing rows stay, whatever comes after them.
TEST_F(FullDisk, KeepsExistingRows) {
    ASSERT_EQ(batch({"--machine", "m.toml", "p.ngc", "--results", "r.sqlite"}).status, 0);
    const auto before = rows("r.sqlite");
    ASSERT_EQ(within(kStep_kib, tests::program_path("gsim-batch"), kWords).status, 2);
    EXPECT_EQ(rows("r.sqlite"), before);
    const Ended next = batch({"--machine", "m.toml", "p.ngc", "p1.ngc", "--results", "r.sqlite"});
    EXPECT_THAT(next.err, HasSubstr("1 run in")) << "the first one is there already";
}

TEST_F(FullDisk, KeepsOldOutputs) {
    ASSERT_EQ(batch({"--machine", "m.toml", "p.ngc", "--results", "r.sqlite"}).status, 0);
    for (const char* option :
         {"--csv", "--json-lines", "--junit", "--sarif", "--statistics-json", "--page"}) {
        write("out", "old\n");
        const Ended ended =
            within(0, tests::program_path("gsim-batch"), fmt::format("--results r.sqlite {} out", option));
        EXPECT_EQ(ended.status, 2) << option << ended.err;
        EXPECT_THAT(ended.err, AllOf(HasSubstr("'out'"), HasSubstr(kReason))) << option;
        EXPECT_EQ(ended.err.find("r.sqlite"), std::string::npos) << option << ": it is not to blame";
        EXPECT_EQ(read("out"), "old\n") << option;
    }
    const Ended pages = within(0, tests::program_path("gsim-batch"), "--results r.sqlite --pages site");
    EXPECT_EQ(pages.status, 2);
    EXPECT_THAT(pages.err, AllOf(HasSubstr("site/"), HasSubstr(kReason)));
}

// A log on a full disk ends no batch, and an error remains one.
TEST_F(FullDisk, OnStandardErrorIsIgnored) {
    write("search.toml", kOverride);
    const auto unheard = [&](const std::string& words) {
        return apps::run_program("/bin/bash", {"-c", words + " 2>/dev/full"}, folder_).status;
    };
    const std::string batch = tests::program_path("gsim-batch") + " ",
                      optimise = tests::program_path("gsim-optimise") + " ";
    EXPECT_EQ(unheard(batch + kWords), 0);
    EXPECT_EQ(rows("r.sqlite").size(), 3U);
    EXPECT_EQ(unheard(batch + "none.ngc"), 2);
    EXPECT_EQ(unheard(batch + "--none"), 2);
    EXPECT_EQ(unheard(optimise + "search.toml --variants 20 --results s.sqlite --json s.json"), 0);
    EXPECT_TRUE(exists("s.json"));
    EXPECT_EQ(unheard(optimise + "none.toml"), 2);
}

TEST_F(FullDisk, NextSearchCompletes) {
    write("search.toml", kOverride);
    const auto search = [&](int room_kib, const std::string& file) {
        return within(
            room_kib, tests::program_path("gsim-optimise"),
            fmt::format("search.toml --variants 20 -q --results {0}.sqlite --json {0}.json --best best-{0}",
                        file));
    };
    ASSERT_EQ(search(kMost_kib, "clean").status, 0);
    int full = 0;
    for (int room_kib = 0; room_kib <= kMost_kib; room_kib += 3 * kStep_kib) {
        remove_results();
        std::filesystem::remove_all(folder_ / "best-r");
        const Ended ended = search(room_kib, "r");
        if (ended.status == 0) break;
        ++full;
        EXPECT_EQ(ended.status, 2) << room_kib << ": " << ended.err;
        EXPECT_THAT(ended.err, AnyOf(HasSubstr("'r.sqlite': "), HasSubstr("best-r"), HasSubstr("r.json")))
            << room_kib;
        const Ended next = search(kMost_kib, "r");
        EXPECT_EQ(next.status, 0) << room_kib << ": " << next.err;
        EXPECT_EQ(read("best-r/p.ngc"), read("best-clean/p.ngc")) << room_kib;
    }
    EXPECT_GT(full, 5);
}

}  // namespace
}  // namespace gsim::batch::full_disk_test
