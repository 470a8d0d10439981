#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <string_view>

#include "controller/module/rcs_module.h"
#include "controller/services/status.h"

namespace gsim::rrs {

/// Statuses that a service may return in addition to those that any may return (rcs_services.def).
class AllowedStatuses {
  public:
    constexpr AllowedStatuses(std::initializer_list<Status> statuses) : count_(statuses.size()) {
        std::copy(statuses.begin(), statuses.end(), statuses_.begin());
    }
    constexpr bool contains(Status status) const { return std::find(begin(), end(), status) != end(); }
    constexpr const Status* begin() const { return statuses_.begin(); }
    constexpr const Status* end() const { return begin() + count_; }

  private:
    std::array<Status, 8> statuses_{};
    std::size_t count_;
};

/// Data of a service that are the same wherever it is called.
struct Service {
    gsim_rcs_opcode opcode;
    std::string_view name;
    AllowedStatuses statuses;
};

/// The services by their names: services::SetRapid.
namespace services {

using enum Status;

#define GSIM_RCS_STATUSES(...) \
    { __VA_ARGS__ }
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments) \
    inline constexpr Service method{GSIM_RCS_##opcode, #method, GSIM_RCS_STATUSES statuses};
#include "controller/module/rcs_services.def"
#undef GSIM_RCS_STATUSES

}  // namespace services

}  // namespace gsim::rrs
