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
json ranges_of(const std::vector<std::uint64_t>& numbers) {
    json ranges = json::array();
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
        ranges.push_back({numbers[i], numbers[end - 1]});
        i = end;
    }
    return ranges;
}

std::vector<std::uint64_t> numbers_in(const json& ranges) {
    std::vector<std::uint64_t> numbers;
    for (const json& range : ranges) {
        for (auto number = range.at(0).get<std::uint64_t>(); number <= range.at(1).get<std::uint64_t>();
             ++number)
            numbers.push_back(number);
    }
    return numbers;
}

tl::expected<std::string, std::string> read_file(const fs::path& file) {
    return os::read_input(file, os::NamedBy::a_file, kMostBytes);
}

/// Calls `take(name, member)` for each member that is a text or a number.
template <typename State, typename Take>
void for_each_state_field(State& state, const Take& take) {
    take("results", state.results);
    take("batch", state.batch);
    take("token", state.token);
    take("jobs", state.jobs);
    take("shards", state.shards);
    take("workers", state.workers);
    take("memory_mb", state.memory_mb);
    take("timeout_s", state.timeout_s);
    take("array_job", state.array_job);
    take("gather_job", state.gather_job);
    take("gathered", state.gathered);
    take("ended", state.ended);
}

}  // namespace

std::vector<std::uint64_t> Shards::jobs_of(std::uint64_t shard) const {
    const auto place = [&](std::uint64_t at) {
        return static_cast<std::ptrdiff_t>(todo.size() * at / shards);
    };
    return {todo.begin() + place(shard), todo.begin() + place(shard + 1)};
}

fs::path folder_of(const std::string& results) {
    return results + ".slurm";
}

fs::path shard_file(const fs::path& folder, std::uint64_t shard) {
    return folder / fmt::format("shard-{}.sqlite", shard);
}

std::uint64_t shard_count(std::uint64_t jobs, std::uint64_t each, std::uint64_t most) {
    return std::clamp<std::uint64_t>((jobs + each - 1) / each, 1, std::max<std::uint64_t>(most, 1));
}

tl::expected<void, std::string> write_shards(const fs::path& folder, const Shards& shards) {
    json text = json::object();
    for_each_state_field(shards, [&](const char* name, const auto& value) { text[name] = value; });
    text["todo"] = ranges_of(shards.todo);
    return os::write_file(folder / "shards.json", text.dump(1) + '\n', os::Reach::disk);
}

tl::expected<Shards, std::string> read_shards(const fs::path& folder) {
    const auto text = read_file(folder / "shards.json");
    if (!text) return tl::unexpected(text.error());
    try {
        const json read = text::parse_json<json>(*text);
        Shards shards;
        for_each_state_field(shards, [&](const char* name, auto& value) { read.at(name).get_to(value); });
        shards.todo = numbers_in(read.at("todo"));
        return shards;
    } catch (const json::exception& error) {
        return tl::unexpected(fmt::format("{}: {}", folder.string(), error.what()));
    }
}

tl::expected<void, std::string> write_plan_of(const fs::path& folder, const Plan& plan) {
    return os::write_file(folder / "plan.json", print_plan_json(plan) + '\n', os::Reach::disk);
}

tl::expected<Plan, std::string> read_plan_of(const fs::path& folder) {
    return read_file(folder / "plan.json").and_then([](const std::string& text) {
        return read_plan_json(text);
    });
}

}  // namespace gsim::batch
