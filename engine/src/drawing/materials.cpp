#include "engine/materials.h"

#include "engine/src/drawing/cutting_rules.h"
#include "engine/src/guarded.h"
#include "engine/src/values.h"

namespace gsim::engine {

tl::expected<std::vector<CuttingMaterial>, Failure> cutting_materials(const Host& host,
                                                                      const std::string& file) {
    return guarded([&]() -> tl::expected<std::vector<CuttingMaterial>, Failure> {
        const auto read = read_materials_input(host, file);
        if (!read) return tl::unexpected(failure_of(text::DiagnosticKind::input_file, read.error(), file));
        std::vector<CuttingMaterial> materials;
        for (const waterjet::Material& each : read->materials) {
            materials.push_back({.name = each.name,
                                 .machinability = waterjet::machinability_of(*read, each),
                                 .like = each.like,
                                 .measured = each.measured.has_value(),
                                 .source = each.source});
        }
        return materials;
    });
}

}  // namespace gsim::engine
