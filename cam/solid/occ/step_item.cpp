#include "cam/solid/occ/step_item.h"

#include <Interface_InterfaceModel.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_ColourRgb.hxx>
#include <StepVisual_DraughtingPreDefinedColour.hxx>
#include <StepVisual_LayeredItem.hxx>
#include <StepVisual_PreDefinedItem.hxx>
#include <StepVisual_PresentationLayerAssignment.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <cmath>

#include <fmt/format.h>

namespace gsim::solid {

namespace {

bool equals_text(const Handle(TCollection_HAsciiString) & text, const std::string& name) {
    return !text.IsNull() && name == text->ToCString();
}

bool has_item(const Handle(StepVisual_PresentationLayerAssignment) & layer,
              const Handle(StepRepr_RepresentationItem) & item) {
    for (int k = 1; k <= layer->NbAssignedItems(); ++k) {
        if (layer->AssignedItemsValue(k).Value() == item) return true;
    }
    return false;
}

bool is_colour(const Handle(StepVisual_Colour) & colour, const std::string& name) {
    if (const auto known = Handle(StepVisual_DraughtingPreDefinedColour)::DownCast(colour); !known.IsNull())
        return equals_text(known->GetPreDefinedItem()->Name(), name);
    const auto mixed = Handle(StepVisual_ColourRgb)::DownCast(colour);
    if (mixed.IsNull()) return false;
    const auto byte = [](double share) { return std::lround(255 * share); };
    return name == fmt::format("{},{},{}", byte(mixed->Red()), byte(mixed->Green()), byte(mixed->Blue()));
}

bool has_colour(const STEPConstruct_Styles& styles, const Handle(StepVisual_StyledItem) & style,
                const std::string& name) {
    Handle(StepVisual_Colour) surface, boundary, curve, rendering;
    double transparency = 0;
    bool is_component = false;
    styles.GetColors(style, surface, boundary, curve, rendering, transparency, is_component);
    return is_colour(surface, name);
}

}  // namespace

bool matches_name(const Handle(XSControl_WorkSession) & session,
                  const Handle(StepRepr_RepresentationItem) & item, const std::string& name) {
    if (equals_text(item->Name(), name)) return true;
    const Handle(Interface_InterfaceModel) model = session->Model();
    const STEPConstruct_Styles styles(session);
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto layer = Handle(StepVisual_PresentationLayerAssignment)::DownCast(model->Value(i));
        if (!layer.IsNull() && equals_text(layer->Name(), name) && has_item(layer, item)) return true;
        const auto style = Handle(StepVisual_StyledItem)::DownCast(model->Value(i));
        if (!style.IsNull() && style->Item() == item && has_colour(styles, style, name)) return true;
    }
    return false;
}

}  // namespace gsim::solid
