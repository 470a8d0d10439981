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

/// The imported settings of a controller: LinuxCNC's .ini, .tbl and .var, or the response of grbl to $$.
class GSIM_API ControllerSettings {
  public:
    /// Unit and machine of a table, which contains neither.
    struct TableOptions {
        LengthUnit unit = LengthUnit::mm;
        const Machine* machine = nullptr;  ///< Machine with its axes; null: X, Y and Z.
    };

    /// Returns true if a name is that of a table of tools or parameters (.tbl, .var), by its extension; else
    /// it is that of settings of a machine, which may name tables.
    static bool is_table(const std::string& name);
    /// Reads settings or a table, by the extension of `name`. `files` contains those that settings name, from
    /// their folder.
    static tl::expected<ControllerSettings, Error> read(std::string_view text, const std::string& name,
                                                        const Files& files, const TableOptions& options);
    ControllerSettings(ControllerSettings&&) noexcept;
    ControllerSettings& operator=(ControllerSettings&&) noexcept;
    ~ControllerSettings();

    /// Returns the items that are not imported: as a warning if that changes positions or times, else as a
    /// note.
    const std::vector<Diagnostic>& left_out() const;
    /// Returns the machine file (TOML); empty for a table.
    const std::string& machine_file() const;
    /// Returns true if offsets, tools or variables exist.
    bool has_machine_data() const;
    /// Returns these as machine data (NCFILE).
    tl::expected<std::string, Error> machine_data() const;

  private:
    struct State;
    explicit ControllerSettings(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::engine
