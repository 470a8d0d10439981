#include "tests/round_trip/way_round.h"

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "tests/build_files/build_files.h"

namespace gsim::round_trip {

namespace fs = std::filesystem;

namespace {

constexpr const char* kExactStop = "exact-stop";

// Offsets are not 0, so that a program which forgets them moves elsewhere.
std::string machine_data() {
    std::string text = "NCFILE\nOFFSET\n";
    int x = 200;
    for (const char* system : {"54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3"}) {
        text += fmt::format("{} {} {} {}\n", system, x, 150.5 - x / 10.0, -60.25 + x / 20.0);
        x += 17;
    }
    text += "HOME\n2 10 20 30\nTOOL\n";
    for (int tool = 1; tool <= 99; ++tool) text += fmt::format("{} {} 6\n", tool, 20 + tool / 2.0);
    return text + "ENDFILE\n";
}

std::string axis(char letter) {
    const bool rotary = letter < 'D';
    return fmt::format(
        "[[axis]]\nletter = \"{0}\"\nkind = \"{1}\"\nmin_{2} = -1e6\nmax_{2} = 1e6\nmax_speed_{2}_s = {3}\n"
        "max_acceleration_{2}_s2 = {4}\ndh = {{ theta_deg = 90, alpha_deg = 90 }}\n",
        letter, rotary ? "rotary" : "linear", rotary ? "deg" : "mm", rotary ? 90 : 100, rotary ? 400 : 1000);
}

// The actions that path2gcode says are comments.
std::set<std::string> comments_of(const std::string& notes) {
    static constexpr std::string_view kBegin = "note: '", kEnd = "' is written as a comment, ";
    std::set<std::string> names;
    std::istringstream lines(notes);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t end = line.rfind(kEnd);
        if (line.starts_with(kBegin) && end != std::string::npos)
            names.insert(line.substr(kBegin.size(), end - kBegin.size()));
    }
    return names;
}

RunRecord without_times(RunRecord run) {
    for (MadeEvent& event : run.events) event.t_s = 0;
    return run;
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

}  // namespace

WayRound::WayRound(fs::path folder, std::string axes) : folder_(std::move(folder)), axes_(std::move(axes)) {
    write(folder_ / "data.txt", machine_data());
    for (const char* controller : {kExactStop, "linuxcnc-2.9", "ab9", "grbl-1.1"}) {
        // The chain's first Z along the world's X, and each row of 90 and 90 turns it to the next one.
        std::string text = fmt::format(
            "[machine]\nname = \"round trip\"\n[controller]\nmodel = \"{}\"\n[base]\nroll_deg = 90\n"
            "yaw_deg = 90\n",
            controller);
        for (const char letter : axes_) text += axis(letter);
        write(folder_ / machine(controller), text);
    }
}

std::string WayRound::machine(const std::string& controller) const {
    return fmt::format("{}-{}.toml", controller, axes_);
}

apps::Ended WayRound::gsim_run(const std::string& program, const std::string& dialect,
                               const std::string& name, const std::string& controller, bool record) const {
    std::vector<std::string> arguments{
        program,          "--dialect",    dialect,        "--machine", machine(controller),
        "--machine-data", "data.txt",     "--quiet",      "--moves",   name + ".jsonl",
        "--report",       name + ".json", "--max-blocks", "100000"};
    if (record) arguments.insert(arguments.end(), {"--record", "path.json"});
    return apps::run_program(tests::program_path("gsim-run"), arguments, folder_);
}

RunRecord WayRound::read(const std::string& name) const {
    return read_run(folder_ / (name + ".jsonl"), folder_ / (name + ".json"));
}

bool WayRound::begin(const fs::path& program, const std::string& dialect) {
    program_ = program;
    dialect_ = dialect;
    fs::remove(folder_ / "path.json");
    fs::remove(folder_ / "first.json");
    const apps::Ended ended = gsim_run(program, dialect, "first", kExactStop, true);
    has_path_ = fs::exists(folder_ / "path.json");
    message_ = ended.err;
    return ended.status == 0 ||
           (fs::exists(folder_ / "first.json") && message_.starts_with("gsim-run: no path"));
}

Outcome WayRound::end(const Way& write_mode, const std::vector<std::string>& options) const {
    if (!has_path_) return {Ending::not_recorded, {}, message_, false};
    gsim_run(program_, dialect_, "first-timed", write_mode.controller, true);
    std::vector<std::string> arguments{"path.json",         "--dialect", write_mode.post, "--machine",
                                       machine(kExactStop), "-o",        "again.nc"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const apps::Ended written = apps::run_program(tests::program_path("path2gcode"), arguments, folder_);
    if (written.status != 0) return {Ending::not_written, {}, written.err, false};
    const apps::Ended repeated = gsim_run("again.nc", write_mode.dialect, "again", kExactStop, false);
    if (repeated.status != 0) return {Ending::not_run, {}, repeated.err, false};
    const RunRecord first = read("first"), second = read("again");
    Outcome outcome;
    const std::set<std::string> unsaid = comments_of(written.err);
    outcome.by_lines = written.err.find(" as lines within ") != std::string::npos;
    const bool by_blocks = written.err.find(" as several blocks") != std::string::npos;
    if (outcome.by_lines || by_blocks) {
        outcome.differences = {compare_positions(first, second),
                               {},
                               compare_events(without_times(first), without_times(second), unsaid)};
    } else {
        outcome.differences = {compare_positions(first, second), compare_times(first, second),
                               compare_events(first, second, unsaid)};
    }
    if (outcome.differences.none() && !outcome.by_lines) {
        gsim_run("again.nc", write_mode.dialect, "again-timed", write_mode.controller, false);
        const RunRecord first_timed = read("first-timed"), second_timed = read("again-timed");
        outcome.differences.times = compare_times(first_timed, second_timed);
        outcome.differences.events = compare_events(first_timed, second_timed, unsaid);
    }
    outcome.extension = outcome.differences.none() ? Ending::same : Ending::differs;
    return outcome;
}

std::string WayRound::written() const {
    std::ifstream file(folder_ / "again.nc");
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace gsim::round_trip
