#include "batch/slurm/shards.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/os/input_file.h"
#include "base/os/output_file.h"
#include "base/text/json.h"
#include "batch/plan/plan_json.h"

namespace gsim::batch {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostBytes = std::size_t{1} << 30U;

/// Encodes consecutive numbers as first and last, so that a million of them is one line.
json encode_ranges(const std::vector<std::uint64_t>& numbers) {
    json ranges = json::array();
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
        ranges.push_back({numbers[i], numbers[end - 1]});
        i = end;
    }
    return ranges;
}

std::vector<std::uint64_t> decode_ranges(const json& ranges) {
    std::vector<std::uint64_t> numbers;
    for (const json& range : ranges) {
        for (auto number = range.at(0).get<std::uint64_t>(); number <= range.at(1).get<std::uint64_t>();
             ++number)
            numbers.push_back(number);
    }
    return numbers;
}

Result<std::string> read_file(const fs::path& file) {
    return os::read_input(file, os::NameSource::in_file, kMostBytes);
}

/// Calls `take(name, member)` for each member that is a text or a number.
template <typename State, typename Visitor>
void for_each_state_field(State& state, const Visitor& on_field) {
    on_field("results", state.results);
    on_field("batch", state.batch);
    on_field("token", state.token);
    on_field("jobs", state.jobs);
    on_field("shards", state.shards);
    on_field("workers", state.workers);
    on_field("memory_mb", state.memory_mb);
    on_field("timeout_s", state.timeout_s);
    on_field("array_job", state.array_job);
    on_field("gather_job", state.gather_job);
    on_field("gathered", state.gathered);
    on_field("ended", state.ended);
}

}  // namespace

std::vector<std::uint64_t> Shards::shard_jobs(std::uint64_t shard) const {
    const auto offset = [&](std::uint64_t at) {
        return static_cast<std::ptrdiff_t>(pending_jobs.size() * at / shards);
    };
    return {pending_jobs.begin() + offset(shard), pending_jobs.begin() + offset(shard + 1)};
}

fs::path shard_folder(const std::string& results) {
    return results + ".slurm";
}

fs::path shard_file(const fs::path& folder, std::uint64_t shard) {
    return folder / fmt::format("shard-{}.sqlite", shard);
}

std::uint64_t shard_count(std::uint64_t jobs, std::uint64_t each, std::uint64_t max) {
    return std::clamp<std::uint64_t>((jobs + each - 1) / each, 1, std::max<std::uint64_t>(max, 1));
}

Result<void> write_shards(const fs::path& folder, const Shards& shards) {
    json text = json::object();
    for_each_state_field(shards, [&](const char* name, const auto& value) { text[name] = value; });
    text["todo"] = encode_ranges(shards.pending_jobs);
    return os::write_file(folder / "shards.json", text.dump(1) + '\n', os::Durability::disk);
}

Result<Shards> read_shards(const fs::path& folder) {
    const auto text = read_file(folder / "shards.json");
    if (!text) return tl::unexpected(text.error());
    try {
        const json read = text::parse_json<json>(*text);
        Shards shards;
        for_each_state_field(shards, [&](const char* name, auto& value) { read.at(name).get_to(value); });
        shards.pending_jobs = decode_ranges(read.at("todo"));
        return shards;
    } catch (const json::exception& error) {
        return Unexpected(fmt::format("{}: {}", folder.string(), error.what()));
    }
}

Result<void> write_stored_plan(const fs::path& folder, const Plan& plan) {
    return os::write_file(folder / "plan.json", print_plan_json(plan) + '\n', os::Durability::disk);
}

Result<Plan> read_stored_plan(const fs::path& folder) {
    return read_file(folder / "plan.json").and_then([](const std::string& text) {
        return read_plan_json(text);
    });
}

}  // namespace gsim::batch
