#pragma once

#include <StepRepr_RepresentationItem.hxx>
#include <XSControl_WorkSession.hxx>
#include <string>

namespace gsim::solid {

/// Returns true if an item of a STEP file has that name, is on a layer of that name, or has that colour: a
/// name of the standard
/// ("red"), or its red, green and blue from 0 to 255 ("255,128,0").
bool matches_name(const Handle(XSControl_WorkSession) & session,
                  const Handle(StepRepr_RepresentationItem) & item, const std::string& name);

}  // namespace gsim::solid
