#include "batch/run/known_runs.h"

#include <fmt/format.h>

#include "base/os/installation.h"
#include "base/text/json.h"
#include "batch/run/own_program.h"
#include "batch/work/run_options.h"
#include "batch/work/sha256.h"
#include "engine/system/host_of_system.h"
#include "engine/version.h"

namespace gsim::batch {

using nlohmann::json;

namespace {

/// Hashes this program, and those that runs may call.
std::string hash_of_programs(InputFiles& files) {
    std::string hashes = files.hash_of(own_program());
    for (const char* helper : {"gsim-solid", "gsim-rcs-host"}) {
        if (const auto program = os::helper_program(os::program_folder(), helper))
            hashes += files.hash_of(program->string());
    }
    return hashes;
}

}  // namespace

KnownRuns::KnownRuns()
    : host_(engine::host_of_system()),
      version_(fmt::format("{}+{}", engine::version(), sha256(hash_of_programs(files_)).substr(0, 16))) {}

RunKey KnownRuns::key_of(const Job& job) {
    RunKey key;
    key.program_sha256 = files_.hash_of(job.program);
    key.machine_sha256 = hash_of_machine(job.machine);
    json files = json::object();
    for (const auto& [name, value] : job.options.items()) {
        if (find_option(name)->kind == RunOption::Kind::file)
            files[name] = files_.hash_of(value.get<std::string>());
    }
    const json all{{"version", version_},
                   {"program", {job.program, key.program_sha256}},
                   {"machine", {job.machine, key.machine_sha256}},
                   {"options", job.options},
                   {"files", files},
                   {"settings", settings_json(job.settings)}};
    key.key = sha256(all.dump(-1, ' ', false, json::error_handler_t::replace));
    return key;
}

tl::expected<std::optional<Results::FoundRun>, std::string> KnownRuns::find(Results& results,
                                                                            const RunKey& key, const Job& job,
                                                                            bool retry) {
    const auto hash_of = [this](const std::string& name) { return files_.hash_of(name); };
    return results.find(key.key, hash_of, job.keeps, retry);
}

std::string KnownRuns::hash_of_machine(const std::string& name) {
    if (name.empty()) return {};
    auto found = machines_.find(name);
    if (found == machines_.end())
        found = machines_.emplace(name, host_.find(engine::NameKind::machine, name).value_or(name)).first;
    return files_.hash_of(found->second);
}

}  // namespace gsim::batch
