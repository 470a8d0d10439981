#include "batch/slurm/commands.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <sstream>

#include <fmt/format.h>

#include "base/os/child_process.h"
#include "base/os/file_handle.h"
#include "base/text/trimmed.h"

namespace gsim::batch {

namespace {

using Fault = tl::unexpected<std::string>;

/// Runs a program and returns its output.
tl::expected<std::string, std::string> output_of(const std::vector<std::string>& command) {
    const os::FileHandle in(std::fopen("/dev/null", "rb")), out(std::tmpfile());
    if (!in || !out) return Fault("cannot make a temporary file");
    if (const auto ran = os::run_child(command, in.get(), out.get()); !ran) return Fault(ran.error());
    std::string text;
    char piece[4096];
    std::rewind(out.get());
    for (std::size_t count = 0; (count = std::fread(piece, 1, sizeof piece, out.get())) > 0;)
        text.append(piece, count);
    return text;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        if (!text::trimmed(line, " ").empty()) lines.push_back(line);
    }
    return lines;
}

std::optional<std::uint64_t> whole(std::string_view text) {
    std::uint64_t value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string value_of(const std::map<std::string, std::string>& fields, const std::string& name) {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string() : found->second;
}

/// Returns the partition for jobs that name none: sinfo marks it with a star at the end.
tl::expected<std::string, std::string> default_partition() {
    const auto names = output_of({"sinfo", "--noheader", "--format=%P"});
    if (!names) return Fault(names.error());
    for (const std::string& line : lines_of(*names)) {
        const std::string name(text::trimmed(line, " "));
        if (name.ends_with('*')) return name.substr(0, name.size() - 1);
    }
    return Fault("this cluster has no default partition; name one (--partition)");
}

tl::expected<std::optional<std::uint64_t>, std::string> largest_memory_mb(const std::string& partition) {
    const auto told = output_of({"sinfo", "--noheader", "--partition=" + partition, "--format=%m"});
    if (!told) return Fault(told.error());
    std::optional<std::uint64_t> most;
    for (const std::string& line : lines_of(*told)) {
        std::string_view text = text::trimmed(line, " ");
        if (text.ends_with('+')) text.remove_suffix(1);
        if (const auto memory_mb = whole(text)) most = std::max(most.value_or(0), *memory_mb);
    }
    return most;
}

}  // namespace

std::map<std::string, std::string> read_fields(std::string_view text) {
    std::map<std::string, std::string> fields;
    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);) {
        if (const std::size_t spaced = line.find(" = "); spaced != std::string::npos) {
            fields[std::string(text::trimmed(line.substr(0, spaced), " "))] =
                text::trimmed(line.substr(spaced + 3), " ");
            continue;
        }
        std::istringstream words(line);
        for (std::string word; words >> word;) {
            if (const std::size_t equal = word.find('='); equal != std::string::npos)
                fields[word.substr(0, equal)] = word.substr(equal + 1);
        }
    }
    return fields;
}

tl::expected<std::optional<std::uint64_t>, std::string> read_minutes(std::string_view text) {
    if (text == "UNLIMITED" || text == "INFINITE") return std::nullopt;
    const auto fault = [&] { return Fault(fmt::format("'{}' is no time of Slurm's", text)); };
    std::uint64_t days = 0;
    std::string_view rest = text;
    const std::size_t dash = text.find('-');
    if (dash != std::string_view::npos) {
        const auto read = whole(text.substr(0, dash));
        if (!read) return fault();
        days = *read;
        rest = text.substr(dash + 1);
    }
    std::vector<std::uint64_t> parts;
    while (true) {
        const std::size_t colon = rest.find(':');
        const auto part = whole(rest.substr(0, colon));
        if (!part || parts.size() == 3) return fault();
        parts.push_back(*part);
        if (colon == std::string_view::npos) break;
        rest.remove_prefix(colon + 1);
    }
    // After days come hours. Otherwise minutes are alone or in front of seconds, hours in front of both.
    if (dash != std::string_view::npos) parts.resize(3, 0);
    const std::uint64_t hours = parts.size() == 3 ? parts[0] : 0;
    const std::uint64_t minutes = parts.size() == 3 ? parts[1] : parts[0];
    return (days * 24 + hours) * 60 + minutes;
}

tl::expected<ClusterLimits, std::string> ask_limits(const std::string& partition) {
    ClusterLimits limits{.partition = partition};
    const auto config = output_of({"scontrol", "show", "config"});
    if (!config) return Fault("no cluster answers: " + config.error());
    // Array indices are below it.
    limits.array_tasks = whole(value_of(read_fields(*config), "MaxArraySize")).value_or(1001) - 1;
    if (limits.partition.empty()) {
        auto name = default_partition();
        if (!name) return Fault(name.error());
        limits.partition = *std::move(name);
    }
    const auto told = output_of({"scontrol", "--oneliner", "show", "partition", limits.partition});
    if (!told) return Fault(fmt::format("this cluster has no partition '{}'", limits.partition));
    const auto fields = read_fields(*told);
    const auto time_min = read_minutes(value_of(fields, "MaxTime"));
    if (!time_min) return Fault(time_min.error());
    limits.time_min = *time_min;
    limits.nodes = whole(value_of(fields, "TotalNodes")).value_or(0);
    const auto memory_mb = largest_memory_mb(limits.partition);
    if (!memory_mb) return Fault(memory_mb.error());
    limits.memory_mb = *memory_mb;
    return limits;
}

tl::expected<std::string, std::string> submit_job(const std::vector<std::string>& options,
                                                  const std::string& script) {
    std::vector<std::string> command{"sbatch", "--parsable"};
    command.insert(command.end(), options.begin(), options.end());
    command.push_back(script);
    return output_of(command).map([](const std::string& told) {
        // With several clusters the cluster's name follows the number.
        return told.substr(0, told.find_first_of(";\n"));
    });
}

tl::expected<std::map<std::int64_t, std::string>, std::string> queued_tasks(const std::string& job) {
    std::map<std::int64_t, std::string> tasks;
    const auto told = output_of({"squeue", "--noheader", "--array", "--format=%K %T %r", "--jobs=" + job});
    if (!told) {
        // squeue prints this if it has forgotten a job.
        if (told.error().find("Invalid job id") != std::string::npos) return tasks;
        return Fault(told.error());
    }
    for (const std::string& line : lines_of(*told)) {
        std::istringstream words(line);
        std::string place, state;
        if (!(words >> place >> state)) continue;
        const auto number = whole(place);
        std::string reason;
        std::getline(words, reason);
        if (reason.find("held") != std::string::npos || reason.find("Held") != std::string::npos)
            state = "HELD";
        tasks[number ? static_cast<std::int64_t>(*number) : -1] = state;
    }
    return tasks;
}

tl::expected<void, std::string> cancel_jobs(const std::vector<std::string>& jobs) {
    for (const std::string& job : jobs) {
        if (job.empty()) continue;
        // A job that Slurm has forgotten has ended.
        const auto told = output_of({"scancel", job});
        if (!told && told.error().find("Invalid job id") == std::string::npos) return Fault(told.error());
    }
    return {};
}

}  // namespace gsim::batch
