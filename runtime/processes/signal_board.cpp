#include "runtime/processes/signal_board.h"

#include <fmt/format.h>

namespace gsim::process {

namespace {

double to_number(const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) return *number;
    return std::get<bool>(value) ? 1 : 0;
}

}  // namespace

bool is_on(const Value& value) {
    return to_number(value) != 0;
}

bool same(const Value& a, const Value& b) {
    return to_number(a) == to_number(b);
}

std::string value_text(const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:.10g}", *number);
    return std::get<bool>(value) ? "true" : "false";
}

Value SignalBoard::get(std::string_view name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? Value(false) : found->second;
}

bool SignalBoard::set(const std::string& name, const Value& value) {
    Value& current = values_.try_emplace(name, false).first->second;
    const bool changes = !same(current, value);
    current = value;
    return changes;
}

void SignalBoard::note(simulation::SignalChange change) {
    if (changes_.size() == kMaxListed) {
        ++dropped_;
        return;
    }
    changes_.push_back(std::move(change));
}

}  // namespace gsim::process
