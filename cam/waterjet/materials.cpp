#include "cam/waterjet/materials.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/nearest_name.h"
#include "base/toml/toml_writer.h"

namespace gsim::waterjet {

Result<const Material*> find_material(const Materials& materials, std::string_view name) {
    const auto& list = materials.materials;
    const auto found = std::find_if(list.begin(), list.end(),
                                    [&](const Material& material) { return material.name == name; });
    if (found != list.end()) return &*found;
    std::vector<std::string_view> known;
    known.reserve(list.size());
    for (const Material& material : list) known.emplace_back(material.name);
    const auto nearest = text::nearest_name(name, known);
    const std::string hint = nearest ? fmt::format("did you mean {}?", base::toml_string(*nearest))
                                     : fmt::format("known materials: {}", text::joined(known, ", "));
    return Unexpected(fmt::format("unknown material {}; {}", base::toml_string(name), hint));
}

double material_machinability(const Materials& materials, const Material& material) {
    if (material.machinability) return *material.machinability;
    if (const auto& cut = material.measured)
        return machinability_of_cut(cut->jet, cut->speed_mm_min, cut->thickness_mm, cut->quality);
    const auto other = find_material(materials, material.like);
    return other ? (*other)->machinability.value_or(0) : 0;
}

}  // namespace gsim::waterjet
