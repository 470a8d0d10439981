#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>
#include <unistd.h>

#include "base/error.h"
#include "batch/pages/page_name.h"
#include "batch/pages/pages.h"
#include "batch/store/results.h"

namespace gsim::batch::pages_test {

namespace fs = std::filesystem;

/// Run as a test describes it; two equal descriptions are one run.
struct Told {
    std::string program;
    double time_s = 10;
    std::string cause = {};
    std::string program_sha256 = "1", machine_sha256 = "2";
    std::vector<ReadFile> files = {};
    std::string version = "v1", machine = "m.toml";
    std::string status = {};
    std::string text = "too far";
    std::vector<SettingValue> settings = {};

    auto operator<=>(const Told& other) const { return key() <=> other.key(); }
    std::string key() const {
        std::string all =
            fmt::format("{} {} {} {} {} {} {} {} {} {}", program, time_s, cause, program_sha256,
                        machine_sha256, version, machine, status, text, settings_json(settings).dump());
        for (const ReadFile& file : files) all += file.name + file.sha256;
        return all;
    }
};

inline RunRow run_row(const Told& reported) {
    RunRow row{.outcome = {.status = reported.status, .cause = reported.cause},
               .machine = "M",
               .controller = "exact-stop",
               .times = {.cycle_s = reported.time_s},
               .extents = R"({"X":[0,10]})",
               .findings = "[]",
               .files = reported.files};
    if (row.outcome.status.empty()) row.outcome.status = reported.cause.empty() ? "completed" : "violations";
    if (reported.cause.empty()) return row;
    row.outcome.message = reported.text;
    row.outcome.file = reported.program;
    row.outcome.line = 7;
    row.counts.violations = 1;
    row.findings = nlohmann::json::array({{{"severity", "error"},
                                           {"code", reported.cause},
                                           {"file", reported.program},
                                           {"line", 7},
                                           {"text", reported.text}}})
                       .dump();
    return row;
}

inline std::string text_in(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Returns all text below a node, parts separated by a blank.
inline std::string page_words(const pugi::xml_node& node) {
    std::string words;
    if (node.type() == pugi::node_pcdata) words = node.value();
    for (const pugi::xml_node& child : node.children()) {
        const std::string more = page_words(child);
        if (!more.empty()) words += (words.empty() ? "" : " ") + more;
    }
    return words;
}

/// Pages of batches that a test describes, in a folder of its own.
class Pages : public testing::Test {
  protected:
    Pages() { fs::create_directories(folder_); }
    ~Pages() override { fs::remove_all(folder_); }

    void batch(const std::vector<Told>& runs, bool complete = true, const std::string& plan = "plan.toml") {
        auto results = Results::open(file_);
        ASSERT_TRUE(results) << results.error().message;
        ASSERT_TRUE(results->begin_batch(plan, runs.size(), "v"));
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const Job job{.number = i,
                          .program = runs[i].program,
                          .machine = runs[i].machine,
                          .options = nlohmann::json::object(),
                          .settings = runs[i].settings};
            const auto known = runs_.find(runs[i]);
            const std::int64_t run =
                known != runs_.end() ? known->second
                                     : results
                                           ->add(job, {"k", runs[i].program_sha256, runs[i].machine_sha256},
                                                 run_row(runs[i]), runs[i].version)
                                           .value();
            ASSERT_TRUE(results->record(i, run, known != runs_.end()));
            runs_[runs[i]] = run;
        }
        ASSERT_TRUE(results->end_batch(complete));
    }

    Result<void> write(std::int64_t since = 0) {
        auto results = Database::open(file_, true);
        EXPECT_TRUE(results) << results.error().message;
        return write_pages(*results, {.folder = site_.string(), .since = since, .views = views_});
    }

    void write_and_read(std::int64_t since = 0) {
        const auto written = write(since);
        ASSERT_TRUE(written) << written.error().message;
        pages_.clear();
        for (const auto& entry : fs::directory_iterator(site_)) {
            if (entry.is_directory()) continue;
            const auto read = pages_[entry.path().filename().string()].load_file(entry.path().c_str());
            ASSERT_TRUE(read) << entry.path() << ": " << read.description() << " at " << read.offset;
        }
        expect_that_links_lead_somewhere();
    }

    void expect_that_links_lead_somewhere() const {
        for (const auto& [name, page] : pages_) {
            for (const auto& each : page.select_nodes("//a")) {
                const std::string address = each.node().attribute("href").value();
                if (address.starts_with("views/")) {
                    EXPECT_TRUE(fs::exists(site_ / address)) << address;
                    continue;
                }
                const std::size_t hash = address.find('#');
                const std::string file = address.substr(0, hash);
                const auto there = pages_.find(file.empty() ? name : file);
                ASSERT_NE(there, pages_.end()) << address << " of " << name;
                if (hash == std::string::npos) continue;
                const std::string place = "//*[@id='" + address.substr(hash + 1) + "']";
                EXPECT_TRUE(there->second.select_node(place.c_str())) << address << " of " << name;
            }
        }
    }

    const pugi::xml_document& front() const { return pages_.at("index.html"); }
    std::string words_of_page(const std::string& program) const {
        return page_words(pages_.at(page_name(program)).select_node("//main").node());
    }

    /// The rows of the list below a heading of the front page, cell by cell.
    std::vector<std::vector<std::string>> rows_below(const std::string& id) const {
        std::vector<std::vector<std::string>> rows;
        const auto heading = front().select_node(("//h3[@id='" + id + "']").c_str()).node();
        for (const auto& each : heading.next_sibling("div").select_nodes("table/tbody/tr")) {
            std::vector<std::string>& row = rows.emplace_back();
            for (const pugi::xml_node& cell : each.node().children()) row.push_back(page_words(cell));
        }
        return rows;
    }

    fs::path folder_ = fs::temp_directory_path() / ("gsim-pages-" + std::to_string(::getpid()));
    fs::path site_ = folder_ / "site";
    std::string file_ = (folder_ / "r.sqlite").string();
    std::optional<ViewGenerator> views_;
    std::map<Told, std::int64_t> runs_;
    std::map<std::string, pugi::xml_document> pages_;
};

}  // namespace gsim::batch::pages_test
