#pragma once

#include <bitset>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "toolpath/json/keys.h"
#include "toolpath/json/path_draft.h"
#include "toolpath/model/path.h"

namespace gsim::path {

/// Target while its keys are read, one by one in any order. Errors are messages.
class TargetDraft {
  public:
    /// Kind of value of a key.
    enum class ValueKind { text, number, text_or_number, vector, letters, list, touches };
    static ValueKind value_kind(TargetKey key);

    /// Marks the key as present; returns true if it was present before.
    bool mark_present(TargetKey key);

    Result<void> set_text(TargetKey key, std::string_view value);
    Result<void> set_number(TargetKey key, double value);
    /// Sets a vector, which needs its exact number of values.
    Result<void> set_vector(TargetKey key, const std::vector<double>& values);
    Result<void> set_rotary(std::string_view letter, double value_deg);
    void add_action(std::string action) { point_.actions.push_back(std::move(action)); }
    /// Adds one of the list of `probe_offset`; end_touches() follows the last one.
    void add_touch(const Touch& touch) { frame_.add_touch(touch); }
    Result<void> end_touches() const { return frame_.end_touches(); }
    /// Begins a table of rotary axes, which may be empty.
    void begin_rotary() { point_.orientation = RotaryAxes{}; }

    /// Returns the target, once all its keys are read. A sub-path has the index 0; `path_name()` gives the
    /// path that is meant.
    Result<Target> finish();
    bool is_sub_path() const {
        return has(TargetKey::path) || has(TargetKey::repeats) || has(TargetKey::set_offset_mm) ||
               has(TargetKey::probe_offset);
    }
    const std::string& path_name() const { return path_name_; }

  private:
    bool has(TargetKey key) const { return present_keys_[static_cast<std::size_t>(key)]; }
    Result<void> set_point_number(TargetKey key, double value, int max);
    bool is_machine_point() const { return has(TargetKey::fixed) || has(TargetKey::reference); }
    std::optional<Error> find_sub_path_error() const;
    std::optional<Error> find_point_error() const;
    std::optional<Error> find_machine_point_error() const;
    std::optional<Error> find_arc_error() const;

    std::bitset<kTargetKeys.size()> present_keys_;
    Point point_;
    MachinePoint machine_point_;
    CenterArc center_;
    ViaPoint via_;
    PathDraft frame_;  // of a sub-path
    std::string path_name_;
    int repeats_ = 1;
};

/// "unknown key 'fed_mm_min' in a target; did you mean 'feed_mm_min'?"
std::string unknown_key(std::string_view key, std::string_view where,
                        std::span<const std::string_view> known);

}  // namespace gsim::path
