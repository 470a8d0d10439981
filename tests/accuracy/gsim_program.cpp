#include "tests/accuracy/gsim_program.h"

#include <cstdio>
#include <exception>
#include <fstream>
#include <memory>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "base/os/child_process.h"
#include "base/os/file_handle.h"
#include "base/text/json.h"
#include "machine/file/machine_file.h"
#include "tests/support/machine_folders.h"

namespace gsim::accuracy {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string read_all(std::FILE* file) {
    std::string text;
    char buffer[1 << 16];
    std::rewind(file);
    for (std::size_t count = 0; (count = std::fread(buffer, 1, sizeof buffer, file)) > 0;)
        text.append(buffer, count);
    return text;
}

Result<std::string> command_output(const std::vector<std::string>& command, const fs::path& input) {
    const os::FileHandle in(std::fopen(input.c_str(), "rb"));
    if (!in) return Unexpected(fmt::format("cannot read {}", input.string()));
    const os::FileHandle out(std::tmpfile());
    if (!out) return Unexpected("cannot create a temporary file");
    const auto ran = os::run_child(command, in.get(), out.get());
    std::string printed = read_all(out.get());
    if (ran) return printed;
    // With --json the error is in the report and is not printed again.
    const auto time_s = read_cycle_time_s(printed);
    return tl::unexpected(json::accept(printed) && !time_s ? time_s.error().message : ran.error().message);
}

// Returns the messages of gsim-run without the folders.
std::string without_paths(std::string message, const std::string& gsim_run, const fs::path& program) {
    for (const std::string& part : {gsim_run + " failed: ", program.parent_path().string() + "/"}) {
        if (const std::size_t at = message.find(part); at != std::string::npos)
            message.erase(at, part.size());
    }
    return message.empty() ? "gsim-run failed without a word" : message;
}

std::string table_of_tools(int count) {
    std::string text = "NCFILE\nTOOL\n";
    for (int number = 1; number <= count; ++number) text += fmt::format("{} 0 0 CUTTER\n", number);
    return text + "ENDFILE\n";
}

}  // namespace

GsimProgram::GsimProgram(std::string gsim_run, std::vector<std::string> machines)
    : gsim_run_(std::move(gsim_run)), machines_(std::move(machines)) {}

Result<std::string> GsimProgram::run(const Recording& recording,
                                     const std::vector<std::string>& outputs) const {
    return run_on(tests::machine_file_in(machines_, recording.machine_file), recording, outputs);
}

Result<std::string> GsimProgram::run_on(const fs::path& machine, const Recording& recording,
                                        const std::vector<std::string>& outputs) const {
    std::vector<std::string> command{gsim_run_,   "--dialect",      recording.dialect,
                                     "--machine", machine.string(), "--json"};
    if (recording.tools > 0) {
        const fs::path data = scratch_.write("tools.txt", table_of_tools(recording.tools));
        command.insert(command.end(), {"--machine-data", data.string()});
    }
    if (!recording.overrides.empty()) {
        const fs::path overridden = scratch_.write("overrides.toml", recording.overrides);
        command.insert(command.end(), {"--overrides", overridden.string()});
    }
    command.insert(command.end(), outputs.begin(), outputs.end());
    command.push_back(recording.program.string());
    return command_output(command, "/dev/null").map_error([&](const Error& error) {
        return Error(without_paths(error.message, gsim_run_, recording.program));
    });
}

Result<double> GsimProgram::cycle_time_s(const Recording& recording) const {
    if (!recording.from_first_move) return run(recording, {}).and_then(read_cycle_time_s);
    const fs::path moves_file = scratch_.path() / "moves.jsonl";
    const auto total_s = run(recording, {"--moves", moves_file}).and_then(read_cycle_time_s);
    if (!total_s) return total_s;
    std::ifstream moves(moves_file);
    return *total_s - first_motion_s(moves);
}

Result<ProgrammedRun> GsimProgram::programmed_run(const Recording& recording) const {
    auto machine = machine::load_machine(tests::machine_file_in(machines_, recording.machine_file));
    if (!machine) return tl::unexpected(machine.error());
    const machine::Machine full = *machine;
    rrs::ControllerRules& rules = machine->controller;
    rules.planner = rrs::PlannerKind::rest_to_rest;
    rules.curves.arc_chord_tolerance_mm = rules.standstill.dwell_step_s = rules.standstill.dwell_s =
        rules.position_loop.servo_period_s = 0;
    rules.blocks.path_measure = rrs::PathMeasure::tool;
    rules.ramps.limit_jerk = false;
    const fs::path from_rest_to_rest = scratch_.write("machine.toml", machine::print_machine(*machine));
    const fs::path moves_file = scratch_.path() / "moves.jsonl";
    if (const auto ran = run_on(from_rest_to_rest, recording, {"--moves", moves_file}); !ran)
        return tl::unexpected(ran.error());
    std::ifstream moves(moves_file);
    return read_programmed_moves(moves, *machine).map([&](std::vector<ProgrammedMove> read) {
        return ProgrammedRun{std::move(read), full};
    });
}

Result<TimedPath> GsimProgram::path(const Recording& recording) const {
    const fs::path trajectory_file = scratch_.path() / "trajectory.csv";
    const fs::path moves_file = scratch_.path() / "moves.jsonl";
    const auto ran =
        run(recording, {"--trajectory", trajectory_file, "--step", "0.01", "--moves", moves_file});
    if (!ran) return tl::unexpected(ran.error());
    std::ifstream trajectory(trajectory_file);
    auto samples = read_trajectory(trajectory);
    if (!samples) return tl::unexpected(samples.error());
    std::ifstream moves(moves_file);
    auto blocks = read_blocks(moves);
    if (!blocks) return tl::unexpected(blocks.error());
    return TimedPath{*std::move(samples), *std::move(blocks)};
}

Result<double> read_cycle_time_s(const std::string& report) {
    try {
        const json object = text::parse_json<json>(report);
        const std::string status = object.at("status").get<std::string>();
        if (status == "completed") return object.at("cycle_time_s").get<double>();
        const json& reason = status == "violations" ? object.at("violations").at(0) : object.at("alarm");
        return Unexpected(fmt::format("{}: {}", status, reason.at("message").get<std::string>()));
    } catch (const std::exception& error) {  // nlohmann's
        return Unexpected(fmt::format("the report cannot be understood: {}", error.what()));
    }
}

double first_motion_s(std::istream& moves) {
    std::string line;
    while (std::getline(moves, line)) {
        const json move = text::try_parse_json<json>(line);
        if (move.is_object() && move.value("kind", "dwell") != "dwell") return move.value("start_s", 0.0);
    }
    return 0;
}

Result<TimedPath> recorded_path(const Recording& recording) {
    const auto csv = command_output({"gzip", "-dc"}, recording.samples);
    if (!csv) return tl::unexpected(csv.error());
    std::istringstream lines(*csv);
    auto samples = read_trajectory(lines);
    if (!samples)
        return Unexpected(fmt::format("{}: {}", recording.samples.string(), samples.error().message));
    return TimedPath{*std::move(samples), recording.blocks};
}

}  // namespace gsim::accuracy
