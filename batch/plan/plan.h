#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/text/json.h"
#include "batch/plan/design.h"
#include "batch/plan/setting.h"
#include "batch/work/job.h"

namespace gsim::batch {

/// Plan of a batch: each program on each machine with each controller, in each variant of the settings.
struct Plan {
    std::string name;                   ///< Name of its file; empty: command line only.
    std::vector<std::string> programs;  ///< Files.
    std::vector<std::string> machines = {
        ""};  ///< Files or names; an empty one: that of the cell, or built in.
    nlohmann::json options = nlohmann::json::object();  ///< For all runs (run_options()).
    std::vector<Setting> settings;
    DesignOptions design;
    StoredDocuments stored_documents;
};

/// Returns the same plan with these variants instead of its settings.
Plan with_variants(Plan plan, std::vector<std::vector<SettingValue>> variants);

/// Jobs of a plan, made on demand because there may be millions.
class Jobs {
  public:
    explicit Jobs(const Plan& plan);

    std::uint64_t size() const { return plan_.programs.size() * plan_.machines.size() * design_.size(); }
    Job job(std::uint64_t number) const;

  private:
    const Plan& plan_;
    Design design_;
};

/// Returns the part programs that a folder or a pattern (`*`, `?`, `[...]`, `**` for nested folders) matches.
/// They are recognised by their extensions (.nc, .ngc, .tap, .cnc, .gcode, .lua, .path.json and others, in
/// any case), and sorted by name. A file matches itself, whatever its extension. Names are relative to
/// `folder`. The error: no match, or a name is not UTF-8.
Result<std::vector<std::string>> find_programs(const std::string& name,
                                               const std::filesystem::path& folder = {});

/// Adds those files that are not in the plan yet.
void add_programs(Plan& plan, const std::vector<std::string>& files);

/// Use of a plan: a search takes values of settings between their bounds, whatever the sampling is.
enum class PlanUse : std::uint8_t { batch, search };

/// Reads a plan (docs/batch.md), without its search part. File names are relative to its folder. The error
/// begins with its source location.
Result<Plan> read_plan(std::string_view toml_text, const std::string& file_name,
                       PlanUse use = PlanUse::batch);

}  // namespace gsim::batch
