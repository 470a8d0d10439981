#include "tests/accuracy/recording.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/accuracy/run_table.h"

namespace gsim::accuracy {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

Result<std::string> read_file(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (!in) return Unexpected(fmt::format("cannot read {}", file.string()));
    return text;
}

double time_in(const json& object) {
    const double time_s = object.get<double>();
    if (!std::isfinite(time_s) || time_s < 0) throw std::runtime_error("a time is negative");
    return time_s;
}

std::vector<Block> blocks_in(const json& object) {
    std::vector<LineTime> times;
    for (const json& entry : object) times.push_back({entry.at(0).get<long>(), time_in(entry.at(1))});
    return blocks_of(times);
}

// A program as its interpreter sees it: small letters, without comments and blanks.
std::string bare(std::string_view program) {
    std::string text;
    char comment = 0;
    for (const char c : program) {
        if (c == '\n' || (comment == '(' && c == ')')) {
            comment = 0;
            text += '\n';
        } else if (comment == 0 && (c == '(' || c == ';')) {
            comment = c;
        } else if (comment == 0 && c != ' ' && c != '\t' && c != '\r') {
            text += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        }
    }
    return text;
}

// A word's number, from its first character on, is 4: 4, 04, 4.0.
bool is_four(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of('0'), text.size()));
    if (!text.starts_with('4')) return false;
    text.remove_prefix(1);
    if (text.starts_with('.')) text.remove_prefix(std::min(text.find_first_not_of('0', 1), text.size()));
    return text.empty() || text[0] < '0' || text[0] > '9';
}

fs::path times_file_of(const fs::path& program) {
    return fs::path(program).replace_extension(".json");
}

// A program with values of its own does not need the table.
Result<std::map<std::string, double>> listed_times(const fs::path& folder, const Controller& controller) {
    const fs::path table = folder / "table.tsv";
    if (!fs::is_regular_file(table)) return {};
    auto times =
        read_file(table).and_then([&](const std::string& text) { return read_times(text, controller); });
    if (!times) return Unexpected(fmt::format("{}: {}", table.string(), times.error().message));
    std::erase_if(*times, [&](const auto& listed) {
        return fs::is_regular_file(times_file_of(folder / (listed.first + ".ngc")));
    });
    return times;
}

Result<Recording> read_recording(const fs::path& program, const Controller& controller,
                                 const std::map<std::string, double>& times) {
    Recording recording;
    recording.name = program.stem().string();
    recording.program = program;
    recording.samples = fs::path(program).replace_extension(".csv.gz");
    recording.machine_file =
        fmt::format("{}-{}.toml", controller.machines, recording.name.substr(0, recording.name.find('_')));
    const auto program_text = read_file(program);
    if (!program_text) return tl::unexpected(program_text.error());
    if (const auto listed = times.find(recording.name); listed != times.end()) {
        recording.cycle_time_s = listed->second;
    } else {
        const fs::path times_file = times_file_of(program);
        const auto json_text = read_file(times_file);
        if (!json_text) return tl::unexpected(json_text.error());
        if (const auto read = read_recorded_values(*json_text, controller, recording); !read)
            return Unexpected(fmt::format("{}: {}", times_file.string(), read.error().message));
    }
    recording.from_first_move = controller.from_first_move;
    recording.tools = controller.tools;
    recording.counted = controller.times_dwells || !has_dwell(*program_text);
    return recording;
}

Result<std::vector<Recording>> runs_of_table(const fs::path& folder, const Controller& controller) {
    return read_file(folder / "table.tsv").and_then([&](const std::string& text) {
        return listed_runs(folder, read_rows(text), controller);
    });
}

}  // namespace

Result<std::vector<Recording>> find_recordings(const fs::path& folder, const Controller& controller) {
    if (controller.runs != nullptr) return runs_of_table(folder, controller);
    std::error_code error;
    const auto times = listed_times(folder, controller);
    if (!times) return tl::unexpected(times.error());
    std::vector<fs::path> programs;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const fs::path& file = entry->path();
        if (file.extension() != ".ngc") continue;
        if (times->contains(file.stem().string()) || fs::is_regular_file(times_file_of(file)))
            programs.push_back(file);
    }
    if (error) return Unexpected(fmt::format("cannot read {}: {}", folder.string(), error.message()));
    std::sort(programs.begin(), programs.end());
    std::vector<Recording> recordings;
    for (const fs::path& program : programs) {
        auto recording = read_recording(program, controller, *times);
        if (!recording) return tl::unexpected(recording.error());
        recordings.push_back(*std::move(recording));
    }
    return recordings;
}

Result<void> read_recorded_values(const std::string& json_text, const Controller& controller,
                                  Recording& recording) {
    try {
        const json times_file = text::parse_json<json>(json_text);
        recording.cycle_time_s = time_in(times_file.at(std::string(controller.time_key)));
        recording.note = times_file.at(std::string(controller.note_key)).get<std::string>();
        recording.exact_stop = times_file.value("mode", "") == "G61.1";
        if (times_file.contains("time_per_line")) recording.blocks = blocks_in(times_file["time_per_line"]);
    } catch (const std::exception& error) {  // those of nlohmann and our own
        return Unexpected(error.what());
    }
    return {};
}

Result<std::map<std::string, double>> read_times(const std::string& table, const Controller& controller) {
    const std::vector<TableRow> rows = read_rows(table);
    std::map<std::string, double> times;
    for (const TableRow& row : rows) {
        const auto name = row.find("name");
        if (name == row.end()) return Unexpected("there is no column 'name'");
        const auto time_s = column_s(row, controller.time_key);
        if (!time_s) return tl::unexpected(time_s.error());
        times[name->second] = *time_s;
    }
    return times;
}

bool has_dwell(std::string_view program) {
    const std::string text = bare(program);
    for (std::size_t at = text.find('g'); at != std::string::npos; at = text.find('g', at + 1)) {
        if (is_four(std::string_view(text).substr(at + 1))) return true;
    }
    return false;
}

}  // namespace gsim::accuracy
