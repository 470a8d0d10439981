#pragma once

#include <cstddef>
#include <string_view>

#include "runtime/simulator/program_observer.h"

namespace gsim::simulation {

/// Connection to the observer of the program's requests, if a run has one.
class ProgramNotifier {
  public:
    /// Sets the observer, which must outlive this.
    void set_observer(ProgramObserver& observer) { observer_ = &observer; }
    /// Calls `notification` with the observer; without an observer it has no effect.
    template <typename Notification>
    void notify(const Notification& notification) const {
        if (observer_ != nullptr) notification(*observer_);
    }
    /// Notifies of motion that an observer cannot record; `why` is a message.
    void notify_unrecordable(std::string_view why) const {
        if (observer_ != nullptr) observer_->on_unrecordable_motion(why);
    }
    /// Returns the approximate memory that the observer has for the run so far, in bytes.
    std::size_t observed_bytes() const { return observer_ == nullptr ? 0 : observer_->retained_bytes(); }

  private:
    ProgramObserver* observer_ = nullptr;
};

}  // namespace gsim::simulation
