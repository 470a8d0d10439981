#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "engine/api.h"
#include "engine/diagnostic.h"
#include "engine/files.h"
#include "engine/machine.h"
#include "engine/machine_data.h"

namespace gsim::engine {

/// What a control was set up with, taken over: LinuxCNC's .ini, .tbl and .var, or what grbl answers to $$.
class GSIM_API ControlSettings {
  public:
    /// Of a table, which says neither itself.
    struct TableChoice {
        LengthUnit unit = LengthUnit::mm;
        const Machine* machine = nullptr;  ///< Whose axes it is for; null: X, Y and Z.
    };

    /// Whether a name is that of a table of tools or parameters (.tbl, .var), by its ending; else it is that
    /// of settings of a machine, which may name tables.
    static bool is_table(const std::string& name);
    /// Reads settings or a table, by the ending of `name`. `files` has those that settings name, from their
    /// folder.
    static tl::expected<ControlSettings, Failure> read(std::string_view text, const std::string& name,
                                                       const Files& files, const TableChoice& choice);
    ControlSettings(ControlSettings&&) noexcept;
    ControlSettings& operator=(ControlSettings&&) noexcept;
    ~ControlSettings();

    /// What is not taken over: as a warning where that changes places or times, as a note else.
    const std::vector<Diagnostic>& left_out() const;
    /// The machine file (TOML); empty of a table.
    const std::string& machine_file() const;
    /// There are offsets, tools or variables.
    bool has_machine_data() const;
    /// These as machine data (NCFILE).
    tl::expected<std::string, Failure> machine_data() const;

  private:
    struct State;
    explicit ControlSettings(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::engine
