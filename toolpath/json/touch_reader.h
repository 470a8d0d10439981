#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "toolpath/json/keys.h"
#include "toolpath/json/read_result.h"
#include "toolpath/json/touches.h"
#include "toolpath/model/source_location.h"

namespace gsim::path {

/// Reader of a touch, key by key.
class TouchReader {
  public:
    /// Begins a touch, which is at this location.
    void start(const SourceLocation& location);
    ReadResult key(const std::string& name);
    ReadResult number(double value);
    ReadResult string(std::string_view value);
    ReadResult vector(const std::vector<double>& values) { return draft_.set_vector(key_, values); }
    bool expects_vector() const { return TouchDraft::value_kind(key_) == TouchDraft::ValueKind::vector; }
    /// Returns the touch, once all its keys are read.
    Result<Touch> finish() const { return draft_.finish(); }

    const SourceLocation& location() const { return location_; }
    std::string_view current_key() const { return key_name(key_); }
    /// Returns the expected value, for messages.
    std::string expected_type() const;

  private:
    TouchKey key_ = TouchKey::axis;
    TouchDraft draft_;
    SourceLocation location_;
};

}  // namespace gsim::path
