#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>

#include "controller/services/status.h"
#include "controller/services/types.h"

namespace gsim::rrs {

/// The interface of a robot controller's motion: Realistic Robot Simulation (RRS) services, one method each,
/// listed and described in rcs_services.def.
/// The default planner and loaded controller modules derive from it and override the services that they
/// offer.
///
/// Every method returns a Status and, unless overridden, returns RRS_SERVICE_NOT_SUPPORTED and does nothing.
/// After a negative status nothing has changed. Lengths are mm, angles rad, times s; joint values are mm
/// (prismatic) or rad (revolute). Every service that is offered, other than Initialize and GetMessage,
/// returns RRS_NOT_INITIALIZED before Initialize. It returns RRS_INVALID_PARAMETER for a number that is not
/// finite or out of the range stated here. Selections and programmed values are modal: they hold for all
/// following targets until set again.
class Shell {
  public:
    virtual ~Shell() = default;

#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments) \
    virtual Status method parameters;
#include "controller/module/rcs_services.def"

  protected:
    /// Returns the result of each service by default; a controller may store the name for GetMessage.
    virtual Status not_supported(std::string_view service);
};

}  // namespace gsim::rrs
