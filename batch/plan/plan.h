#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/text/json.h"
#include "batch/plan/design.h"
#include "batch/plan/setting.h"
#include "batch/work/job.h"

namespace gsim::batch {

/// What is to be run: each program on each machine with each control, in each variant of the settings.
struct Plan {
    std::string name;                   ///< Of its file; empty: the command line has told it all.
    std::vector<std::string> programs;  ///< Files.
    std::vector<std::string> machines = {
        ""};  ///< Files or names; an empty one: that of the cell, or built in.
    nlohmann::json options = nlohmann::json::object();  ///< Of all runs (run_options()).
    std::vector<Setting> settings;
    DesignOptions design;
    Kept keeps;
};

/// The same with these variants in place of its settings.
Plan with_variants(Plan plan, std::vector<std::vector<SettingValue>> variants);

/// The jobs of a plan, made where they are needed: there may be millions.
class Jobs {
  public:
    explicit Jobs(const Plan& plan);

    std::uint64_t size() const { return plan_.programs.size() * plan_.machines.size() * design_.size(); }
    Job job(std::uint64_t number) const;

  private:
    const Plan& plan_;
    Design design_;
};

/// What a folder or a pattern (`*`, `?`, `[...]`, `**` for folders in folders) means: part programs by their
/// endings (.nc, .ngc, .tap, .cnc, .gcode, .lua, .path.json and others, in any case), in the order of their
/// names. A file is itself, whatever its ending. Names are from `folder`. The error: there is none, or it is
/// not UTF-8.
tl::expected<std::vector<std::string>, std::string> find_programs(const std::string& name,
                                                                  const std::filesystem::path& folder = {});

/// Adds those that are not there yet.
void add_programs(Plan& plan, const std::vector<std::string>& files);

/// What a plan is read for: a search takes values of settings between their bounds, whatever is to be
/// sampled.
enum class PlanUse : std::uint8_t { batch, search };

/// Reads a plan (docs/batch.md), without what it says of a search. Files are named from its folder. The error
/// begins with its place.
tl::expected<Plan, std::string> read_plan(std::string_view toml_text, const std::string& file_name,
                                          PlanUse use = PlanUse::batch);

}  // namespace gsim::batch
