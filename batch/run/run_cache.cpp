#include "batch/run/run_cache.h"

#include <fmt/format.h>

#include "base/os/installation.h"
#include "base/text/json.h"
#include "batch/run/current_executable.h"
#include "batch/work/run_options.h"
#include "batch/work/sha256.h"
#include "engine/system/system_host.h"
#include "engine/version.h"

namespace gsim::batch {

using nlohmann::json;

namespace {

/// Hashes this program, and those that runs may call.
std::string hash_programs(InputFiles& files) {
    std::string hashes = files.file_hash(current_executable());
    for (const char* helper : {"gsim-solid", "gsim-rcs-host"}) {
        if (const auto program = os::helper_program(os::program_folder(), helper))
            hashes += files.file_hash(program->string());
    }
    return hashes;
}

}  // namespace

RunCache::RunCache()
    : host_(engine::make_system_host()),
      version_(fmt::format("{}+{}", engine::version(), sha256(hash_programs(files_)).substr(0, 16))) {}

RunKey RunCache::run_key(const Job& job) {
    RunKey key;
    key.program_sha256 = files_.file_hash(job.program);
    key.machine_sha256 = machine_hash(job.machine);
    json files = json::object();
    for (const auto& [name, value] : job.options.items()) {
        if (find_option(name)->kind == RunOption::Kind::file)
            files[name] = files_.file_hash(value.get<std::string>());
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

Result<std::optional<Results::StoredRun>> RunCache::find(Results& results, const RunKey& key, const Job& job,
                                                         bool retry) {
    const auto file_hash = [this](const std::string& name) { return files_.file_hash(name); };
    return results.find(key.key, file_hash, job.stored_documents, retry);
}

std::string RunCache::machine_hash(const std::string& name) {
    if (name.empty()) return {};
    auto found = machines_.find(name);
    if (found == machines_.end())
        found = machines_.emplace(name, host_.find(engine::NameKind::machine, name).value_or(name)).first;
    return files_.file_hash(found->second);
}

}  // namespace gsim::batch
