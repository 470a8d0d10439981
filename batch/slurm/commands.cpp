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

/// Runs a program and returns its output.
Result<std::string> command_output(const std::vector<std::string>& command) {
    const os::FileHandle in(std::fopen("/dev/null", "rb")), out(std::tmpfile());
    if (!in || !out) return Unexpected("cannot create a temporary file");
    if (const auto ran = os::run_child(command, in.get(), out.get()); !ran) return Unexpected(ran.error());
    std::string text;
    char chunk[4096];
    std::rewind(out.get());
    for (std::size_t count = 0; (count = std::fread(chunk, 1, sizeof chunk, out.get())) > 0;)
        text.append(chunk, count);
    return text;
}

std::vector<std::string> split_lines(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        if (!text::trimmed(line, " ").empty()) lines.push_back(line);
    }
    return lines;
}

std::optional<std::uint64_t> parse_integer(std::string_view text) {
    std::uint64_t value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string field_value(const std::map<std::string, std::string>& fields, const std::string& name) {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string() : found->second;
}

/// Returns the partition for jobs that name none: sinfo marks it with a star at the end.
Result<std::string> default_partition() {
    const auto names = command_output({"sinfo", "--noheader", "--format=%P"});
    if (!names) return Unexpected(names.error());
    for (const std::string& line : split_lines(*names)) {
        const std::string name(text::trimmed(line, " "));
        if (name.ends_with('*')) return name.substr(0, name.size() - 1);
    }
    return Unexpected("this cluster has no default partition; name one (--partition)");
}

Result<std::optional<std::uint64_t>> largest_memory_mb(const std::string& partition) {
    const auto output = command_output({"sinfo", "--noheader", "--partition=" + partition, "--format=%m"});
    if (!output) return Unexpected(output.error());
    std::optional<std::uint64_t> max;
    for (const std::string& line : split_lines(*output)) {
        std::string_view text = text::trimmed(line, " ");
        if (text.ends_with('+')) text.remove_suffix(1);
        if (const auto memory_mb = parse_integer(text)) max = std::max(max.value_or(0), *memory_mb);
    }
    return max;
}

}  // namespace

std::map<std::string, std::string> read_fields(std::string_view text) {
    std::map<std::string, std::string> fields;
    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);) {
        if (const std::size_t separator = line.find(" = "); separator != std::string::npos) {
            fields[std::string(text::trimmed(line.substr(0, separator), " "))] =
                text::trimmed(line.substr(separator + 3), " ");
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

Result<std::optional<std::uint64_t>> read_minutes(std::string_view text) {
    if (text == "UNLIMITED" || text == "INFINITE") return std::nullopt;
    const auto invalid = [&] { return Unexpected(fmt::format("'{}' is not a Slurm time", text)); };
    std::uint64_t days = 0;
    std::string_view remaining_text = text;
    const std::size_t dash = text.find('-');
    if (dash != std::string_view::npos) {
        const auto read = parse_integer(text.substr(0, dash));
        if (!read) return invalid();
        days = *read;
        remaining_text = text.substr(dash + 1);
    }
    std::vector<std::uint64_t> parts;
    while (true) {
        const std::size_t colon = remaining_text.find(':');
        const auto part = parse_integer(remaining_text.substr(0, colon));
        if (!part || parts.size() == 3) return invalid();
        parts.push_back(*part);
        if (colon == std::string_view::npos) break;
        remaining_text.remove_prefix(colon + 1);
    }
    // Hours follow days. Otherwise minutes are alone or in front of seconds, hours in front of both.
    if (dash != std::string_view::npos) parts.resize(3, 0);
    const std::uint64_t hours = parts.size() == 3 ? parts[0] : 0;
    const std::uint64_t minutes = parts.size() == 3 ? parts[1] : parts[0];
    return (days * 24 + hours) * 60 + minutes;
}

Result<ClusterLimits> query_limits(const std::string& partition) {
    ClusterLimits limits{.partition = partition};
    const auto config = command_output({"scontrol", "show", "config"});
    if (!config) return Unexpected("the cluster does not respond: " + config.error().message);
    // Array indices are below it.
    limits.max_array_tasks =
        parse_integer(field_value(read_fields(*config), "MaxArraySize")).value_or(1001) - 1;
    if (limits.partition.empty()) {
        auto name = default_partition();
        if (!name) return Unexpected(name.error());
        limits.partition = *std::move(name);
    }
    const auto output = command_output({"scontrol", "--oneliner", "show", "partition", limits.partition});
    if (!output) return Unexpected(fmt::format("this cluster has no partition '{}'", limits.partition));
    const auto fields = read_fields(*output);
    const auto time_min = read_minutes(field_value(fields, "MaxTime"));
    if (!time_min) return Unexpected(time_min.error());
    limits.time_min = *time_min;
    limits.nodes = parse_integer(field_value(fields, "TotalNodes")).value_or(0);
    const auto memory_mb = largest_memory_mb(limits.partition);
    if (!memory_mb) return Unexpected(memory_mb.error());
    limits.memory_mb = *memory_mb;
    return limits;
}

Result<std::string> submit_job(const std::vector<std::string>& options, const std::string& script) {
    std::vector<std::string> command{"sbatch", "--parsable"};
    command.insert(command.end(), options.begin(), options.end());
    command.push_back(script);
    return command_output(command).map([](const std::string& output) {
        // With several clusters the cluster's name follows the number.
        return output.substr(0, output.find_first_of(";\n"));
    });
}

Result<std::map<std::int64_t, std::string>> queued_tasks(const std::string& job) {
    std::map<std::int64_t, std::string> tasks;
    const auto output =
        command_output({"squeue", "--noheader", "--array", "--format=%K %T %r", "--jobs=" + job});
    if (!output) {
        // squeue prints this if it has forgotten a job.
        if (output.error().message.find("Invalid job id") != std::string::npos) return tasks;
        return Unexpected(output.error());
    }
    for (const std::string& line : split_lines(*output)) {
        std::istringstream words(line);
        std::string task_index, state;
        if (!(words >> task_index >> state)) continue;
        const auto number = parse_integer(task_index);
        std::string reason;
        std::getline(words, reason);
        if (reason.find("held") != std::string::npos || reason.find("Held") != std::string::npos)
            state = "HELD";
        tasks[number ? static_cast<std::int64_t>(*number) : -1] = state;
    }
    return tasks;
}

Result<void> cancel_jobs(const std::vector<std::string>& jobs) {
    for (const std::string& job : jobs) {
        if (job.empty()) continue;
        // A job that Slurm has forgotten has ended.
        const auto output = command_output({"scancel", job});
        if (!output && output.error().message.find("Invalid job id") == std::string::npos)
            return Unexpected(output.error());
    }
    return {};
}

}  // namespace gsim::batch
