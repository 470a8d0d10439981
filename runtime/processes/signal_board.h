#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/report/report.h"

namespace gsim::process {

/// What a signal can be: a switch or a number.
using Value = std::variant<bool, double>;

/// Neither false nor 0.
bool is_on(const Value& value);
/// Numbers and switches compare: true is 1, false is 0.
bool same(const Value& a, const Value& b);
/// As scripts write it.
std::string text_of(const Value& value);

/// The signals by which processes tell each other. One never set is false.
class SignalBoard {
  public:
    /// A report lists no more changes than this; what is past it is counted.
    static constexpr std::size_t kMostListed = 10'000;

    Value get(std::string_view name) const;
    /// Whether it has ever been set.
    bool has(std::string_view name) const { return values_.find(name) != values_.end(); }
    /// True where the value is another one than before.
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
