#include "tests/conformance/programs.h"

#include <cstdio>
#include <fstream>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "base/os/child_process.h"
#include "tests/conformance/moves_reader.h"

namespace gsim::conformance {

namespace {

namespace fs = std::filesystem;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string read_all(std::FILE* file) {
    std::string text;
    char buffer[1 << 16];
    std::rewind(file);
    for (std::size_t count = 0; (count = std::fread(buffer, 1, sizeof buffer, file)) > 0;)
        text.append(buffer, count);
    return text;
}

}  // namespace

Result<std::string> command_output(const std::vector<std::string>& command, const fs::path& input) {
    const File in(std::fopen(input.c_str(), "rb"));
    if (!in) return Unexpected("cannot read " + input.string());
    const File out(std::tmpfile());
    if (!out) return Unexpected("cannot create a temporary file");
    if (const auto ran = os::run_child(command, in.get(), out.get()); !ran)
        return tl::unexpected(ran.error());
    return read_all(out.get());
}

GsimRuns::GsimRuns(GsimOptions options, const std::vector<ToolRow>& tools)
    : options_(std::move(options)), machine_data_(scratch_.write("tools.txt", machine_data_text(tools))) {}

// Each program is run alone, as the reference was: with a name of its own, in a folder without its
// neighbours. A short name also leaves space for the message.
Result<fs::path> GsimRuns::place(const Recorded& recorded) const {
    const fs::path standalone = scratch_.path() / ("program" + recorded.program.extension().string());
    fs::remove(standalone);
    if (!recorded.without_kinematics) {
        fs::create_symlink(fs::absolute(recorded.program), standalone);
        return standalone;
    }
    return read_text(recorded.program).map([&](const std::string& text) {
        return scratch_.write(standalone.filename(), without_kinematics_switches(text));
    });
}

/// Limit above the blocks of any recording, so that an endless program does not take long.
constexpr const char* kMaxBlocks = "300000";

Result<std::vector<Move>> GsimRuns::moves(const Recorded& recorded) const {
    const auto program = place(recorded);
    if (!program) return tl::unexpected(program.error());
    const fs::path moves_file = scratch_.path() / "moves.jsonl";
    std::vector<std::string> command{options_.gsim_run, "--dialect",      "rs274ngc",     "--machine",
                                     options_.machine,  "--machine-data", machine_data_,  "--quiet",
                                     "--max-time",      "1e12",           "--max-blocks", kMaxBlocks,
                                     "--moves",         moves_file};
    command.insert(command.end(), options_.extra.begin(), options_.extra.end());
    command.push_back(*program);
    if (const auto ran = command_output(command, "/dev/null"); !ran)
        return tl::unexpected(without_paths(ran.error().message));
    std::ifstream moves(moves_file);
    return read_moves(moves);
}

// Returns the messages of gsim-run.
std::string GsimRuns::without_paths(std::string message) const {
    for (const std::string& part : {options_.gsim_run + " failed: ", scratch_.path().string() + "/"}) {
        if (const std::size_t at = message.find(part); at != std::string::npos)
            message.erase(at, part.size());
    }
    return message;
}

Result<std::string> read_text(const fs::path& file) {
    if (file.extension() == ".gz") return command_output({"gzip", "-dc"}, file);
    return command_output({"cat"}, file);
}

}  // namespace gsim::conformance
