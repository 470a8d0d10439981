#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "toolpath/json/keys.h"
#include "toolpath/model/path.h"

namespace gsim::path {

/// A touch while its keys are read, one after the other in any order. Errors are sentences.
class TouchDraft {
  public:
    /// What kind of value a key takes.
    enum class ValueKind { text, number, vector };
    static ValueKind kind_of(TouchKey key);

    /// Whether the key was there before; it is from now on.
    bool mark(TouchKey key);
    tl::expected<void, std::string> set_text(TouchKey key, std::string_view value);
    tl::expected<void, std::string> set_number(TouchKey key, double value);
    /// As many values as a vector has, no more and no fewer.
    tl::expected<void, std::string> set_vector(TouchKey key, const std::vector<double>& values);

    /// The touch, once all its keys are there.
    tl::expected<Touch, std::string> finish() const;

  private:
    std::vector<bool> seen_ = std::vector<bool>(kTouchKeys.size(), false);
    Touch touch_;
};

/// What is wrong with the values of a touch.
std::optional<std::string> touch_fault(const Touch& touch);

/// Whether the way of a touch leads towards greater values of its axis.
bool goes_up(const Touch& touch);

/// What the axis shall have where the touch ends: the surface, less the radius of the ball.
double contact_mm(const Touch& touch);

}  // namespace gsim::path
