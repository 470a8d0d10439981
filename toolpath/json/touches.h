#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "toolpath/json/keys.h"
#include "toolpath/model/path.h"

namespace gsim::path {

/// Touch while its keys are read, one by one in any order. Errors are messages.
class TouchDraft {
  public:
    /// Kind of value of a key.
    enum class ValueKind { text, number, vector };
    static ValueKind value_kind(TouchKey key);

    /// Marks the key as present; returns true if it was present before.
    bool mark_present(TouchKey key);
    Result<void> set_text(TouchKey key, std::string_view value);
    Result<void> set_number(TouchKey key, double value);
    /// Sets a vector, which needs its exact number of values.
    Result<void> set_vector(TouchKey key, const std::vector<double>& values);

    /// Returns the touch, once all its keys are read.
    Result<Touch> finish() const;

  private:
    std::vector<bool> present_keys_ = std::vector<bool>(kTouchKeys.size(), false);
    Touch touch_;
};

/// Returns the error in the values of a touch.
std::optional<Error> find_touch_error(const Touch& touch);

/// Returns true if the path of a touch leads towards larger values of its axis.
bool is_upward(const Touch& touch);

/// Returns the expected axis value at the end of the touch: the surface, less the radius of the ball.
double contact_mm(const Touch& touch);

}  // namespace gsim::path
