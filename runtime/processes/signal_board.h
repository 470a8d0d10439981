#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/report/report.h"

namespace gsim::process {

/// Value of a signal: a switch or a number.
using Value = std::variant<bool, double>;

/// Returns true for neither false nor 0.
bool is_on(const Value& value);
/// Compares numbers and switches: true is 1, false is 0.
bool same(const Value& a, const Value& b);
/// Returns the value as scripts write it.
std::string value_text(const Value& value);

/// Signals by which processes communicate. One that was never set is false.
class SignalBoard {
  public:
    /// Max number of changes in a report; further ones are counted.
    static constexpr std::size_t kMaxListed = 10'000;

    Value get(std::string_view name) const;
    /// Returns true if it has ever been set.
    bool has(std::string_view name) const { return values_.find(name) != values_.end(); }
    /// Sets a signal; returns true if the value differs from the one before.
    bool set(const std::string& name, const Value& value);
    /// Notes a change for the report.
    void note(simulation::SignalChange change);

    const std::vector<simulation::SignalChange>& changes() const { return changes_; }
    std::uint64_t dropped() const { return dropped_; }

  private:
    std::map<std::string, Value, std::less<>> values_;
    std::vector<simulation::SignalChange> changes_;
    std::uint64_t dropped_ = 0;
};

}  // namespace gsim::process
