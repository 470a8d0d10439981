#pragma once

#include <optional>
#include <utility>

namespace gsim::path {

/// Value that a path inherits from those that use it: absent, the same from all of them, or different; or
/// left unknown by a target.
template <typename T>
class Inherited {
  public:
    Inherited() = default;
    explicit Inherited(T value) : value_(std::move(value)) {}

    /// Returns an unknown value.
    static Inherited unknown() {
        Inherited inherited;
        inherited.differs_ = true;
        return inherited;
    }

    const std::optional<T>& value() const { return value_; }
    bool differs() const { return differs_; }
    /// Merges the value that another user passes on.
    void merge(const Inherited& other) {
        differs_ = differs_ || other.differs_ || value_ != other.value_;
        if (differs_) value_.reset();
    }
    /// Applies what a later element sets; no change if that leaves the value.
    void set(const Inherited& later) {
        if (later.value_ || later.differs_) *this = later;
    }
    bool operator==(const Inherited&) const = default;

  private:
    std::optional<T> value_;
    bool differs_ = false;
};

}  // namespace gsim::path
