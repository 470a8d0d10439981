#include "engine/materials.h"

#include "engine/src/conversions.h"
#include "engine/src/drawing/cutting_rules.h"
#include "engine/src/guard_exceptions.h"

namespace gsim::engine {

tl::expected<std::vector<CuttingMaterial>, Error> cutting_materials(const Host& host,
                                                                    const std::string& file) {
    return guard_exceptions([&]() -> tl::expected<std::vector<CuttingMaterial>, Error> {
        const auto read = read_materials_input(host, file);
        if (!read) return tl::unexpected(make_error(text::DiagnosticKind::input_file, read.error(), file));
        std::vector<CuttingMaterial> materials;
        for (const waterjet::Material& each : read->materials) {
            materials.push_back({.name = each.name,
                                 .machinability = waterjet::material_machinability(*read, each),
                                 .like = each.like,
                                 .measured = each.measured.has_value(),
                                 .source = each.source});
        }
        return materials;
    });
}

}  // namespace gsim::engine
