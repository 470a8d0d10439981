#pragma once

#include <optional>
#include <string>

#include "base/os/temporary_name.h"

namespace gsim::studio {

/// Page that redirects the system's browser to an address. The browser gets the name of a file that no other
/// user may read. All users can see the arguments of programs, and the address contains the token. The file
/// is removed with this object.
class BrowserPage {
  public:
    /// Returns no page if no file can be created, or no browser started; a line on standard error reports it.
    static std::optional<BrowserPage> open(const std::string& address);

  private:
    explicit BrowserPage(os::TemporaryName file) : file_(std::move(file)) {}

    os::TemporaryName file_;
};

}  // namespace gsim::studio
