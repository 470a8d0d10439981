#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/simulator/commands.h"
#include "runtime/simulator/program/program_notifier.h"

namespace gsim::simulation {

/// Work coordinate systems that the program has selected. Targets remain machine coordinates; observers and
/// violations name the selected one.
class WorkOffsets {
  public:
    /// Begins without a selected offset. `notifier` must outlive this.
    explicit WorkOffsets(const ProgramNotifier& notifier) : notifier_(notifier) {}

    /// Selects an offset for the moves that follow.
    void select(const WorkOffset& offset);
    /// Returns the offset that was selected last; no value before the first one.
    const std::optional<WorkOffset>& selected() const { return selected_; }
    /// Returns the number of the active offset, for MoveInfo::offset.
    std::uint16_t index() const { return index_; }
    /// Returns the code of an offset by its number, such as "G54"; the first one is empty: no offset.
    const std::string& code(std::uint16_t index) const { return codes_[index]; }

  private:
    const ProgramNotifier& notifier_;
    std::optional<WorkOffset> selected_;
    std::vector<std::string> codes_{std::string()};
    std::uint16_t index_ = 0;
};

}  // namespace gsim::simulation
