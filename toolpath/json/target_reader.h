#pragma once

#include <string>
#include <vector>

#include "toolpath/json/keys.h"
#include "toolpath/json/read_result.h"
#include "toolpath/json/target_draft.h"
#include "toolpath/model/source_location.h"

namespace gsim::path {

/// Reader of a target, key by key.
class TargetReader {
  public:
    /// Begins a target, which is at this location.
    void start(const SourceLocation& location);
    ReadResult key(const std::string& name);
    ReadResult number(double value);
    ReadResult string(const std::string& value);
    ReadResult vector(const std::vector<double>& values) { return draft_.set_vector(key_, values); }
    /// Returns true if the next value is of this kind.
    bool expects(TargetDraft::ValueKind kind) const { return TargetDraft::value_kind(key_) == kind; }

    /// Sets the letter of the next rotary axis.
    void rotary_key(std::string& letter) { rotary_letter_ = std::move(letter); }
    ReadResult rotary_number(double value_deg) { return draft_.set_rotary(rotary_letter_, value_deg); }
    std::string expected_rotary() const { return fmt::format("'{}' must be a number", rotary_letter_); }

    TargetDraft& draft() { return draft_; }
    const SourceLocation& location() const { return location_; }
    std::string_view current_key() const { return key_name(key_); }
    /// Returns the expected value, for messages.
    std::string expected_type() const;

  private:
    TargetKey key_ = TargetKey::name;
    TargetDraft draft_;
    SourceLocation location_;
    std::string rotary_letter_;
};

}  // namespace gsim::path
