#include "tests/faults/jobs.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "tests/build_files/build_files.h"

namespace gsim::faults {

namespace {

const std::string kSamples = tests::source_path("samples/");
const std::string kWheel = kSamples + "wheel.nc";
const Files kKept = {{"data.txt", "NCFILE\nVARIABLE\n500 7\nENDFILE\n"},
                     {"variables", "501\t19\n"},
                     {"part.nc", "#500=#500+1\n#501=#501+1\nG0 X10\nG1 X20 F1000\nM2\n"}};

// But for pictures, which gnuplot draws.
std::vector<std::string> all_outputs() {
    std::vector<std::string> command = {"gsim-run", kWheel, "--step", "0.02", "--report", "report.json"};
    const auto add = [&](const char* option, std::string name, std::initializer_list<const char*> endings) {
        if (name != "plot") command.insert(command.end(), {option, name + *endings.begin()});
    };
#define GSIM_DOCUMENT(name, number, option, help, ...) add(option, #name, {__VA_ARGS__});
#include "engine/outputs.def"
    return command;
}

std::vector<Job> run_jobs() {
    return {
        {"gsim-run, all outputs", all_outputs(), {{"report.json", "old\n"}}},
        {"gsim-run --no-confine", {"gsim-run", "--no-confine", "--json", kWheel, "--moves", "moves.jsonl"}},
        {"gsim-run, a long program", {"gsim-run", "--json", "long.nc"}, {{"long.nc", long_program()}}},
        {"gsim-run, kept data",
         {"gsim-run", "--quiet", "--variables", "variables", "--machine-data", "data.txt",
          "--save-machine-data", "data.txt", "part.nc"},
         kKept},
    };
}

std::vector<Job> other_jobs() {
    return {
        {"gcode2lua", {"gcode2lua", kWheel, "-o", "wheel.lua"}, {{"wheel.lua", "old\n"}}},
        {"gcode2lua, from and to a pipe", {"gcode2lua", "-"}, {}, long_program()},
        {"gsim-data set", {"gsim-data", "data.txt", "set", "VARIABLE", "500", "VALUE=3"}, kKept},
        {"autopath",
         {"autopath", kSamples + "plate.svg", "--material", "aluminum", "--thickness", "12", "-o",
          "plate.path.json"}},
        {"path2gcode", {"path2gcode", kSamples + "wheel.path.json", "-o", "wheel.nc"}},
        {"path2gcode, a script", {"path2gcode", kSamples + "flange.path.lua", "-o", "flange.nc"}},
        {"gsim-check", {"gsim-check", kWheel, "part.nc"}, kKept},
        {"gsim-run, a cell",
         {"gsim-run", "--quiet", "--cell", kSamples + "cell/table.toml", kWheel, "--report", "report.json"}},
    };
}

}  // namespace

std::string long_program() {
    constexpr int kLines = 700;
    constexpr int kAcross_mm = 300;
    constexpr int kAlong_mm = 200;
    constexpr int kStride = 7;
    std::string text = "G90 G21 G1 F3000\n";
    for (int i = 0; i < kLines; ++i)
        text += fmt::format(
            "G1 X{} Y{} F3000 (a remark that goes along with the line, and is long, so that few lines make a "
            "long program)\n",
            i % kAcross_mm, i * kStride % kAlong_mm);
    return text + "M2\n";
}

std::vector<Job> jobs() {
    std::vector<Job> all = run_jobs();
    for (Job& job : other_jobs()) all.push_back(std::move(job));
    return all;
}

Job job_named(const std::string& name) {
    for (Job& job : jobs()) {
        if (job.name == name) return std::move(job);
    }
    throw std::logic_error("no job " + name);
}

}  // namespace gsim::faults
