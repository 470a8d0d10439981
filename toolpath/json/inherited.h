#pragma once

#include <optional>
#include <utility>

namespace gsim::path {

/// A value that a path takes over from those that use it: not there, the same from all of them, or not; or
/// one that a target has left unknown.
template <typename T>
class Inherited {
  public:
    Inherited() = default;
    explicit Inherited(T value) : value_(std::move(value)) {}

    /// One that nobody can tell.
    static Inherited unknown() {
        Inherited made;
        made.differs_ = true;
        return made;
    }

    const std::optional<T>& value() const { return value_; }
    bool differs() const { return differs_; }
    /// Takes in what another user hands over.
    void merge(const Inherited& other) {
        differs_ = differs_ || other.differs_ || value_ != other.value_;
        if (differs_) value_.reset();
    }
    /// Takes over what something behind it sets; nothing where that leaves it.
    void set(const Inherited& later) {
        if (later.value_ || later.differs_) *this = later;
    }
    bool operator==(const Inherited&) const = default;

  private:
    std::optional<T> value_;
    bool differs_ = false;
};

}  // namespace gsim::path
