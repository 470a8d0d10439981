#pragma once

#include <optional>
#include <string>

#include "base/os/temporary_name.h"

namespace gsim::studio {

/// A page for the system's browser that leads on to an address. A browser gets the name of a file that no
/// other user may read, since all users see with what arguments programs are begun, and the address has the
/// token. Goes with this object.
class BrowserPage {
  public:
    /// Nothing where no file can be made, or no browser begun: a line on standard error says so.
    static std::optional<BrowserPage> open(const std::string& address);

  private:
    explicit BrowserPage(os::TemporaryName file) : file_(std::move(file)) {}

    os::TemporaryName file_;
};

}  // namespace gsim::studio
