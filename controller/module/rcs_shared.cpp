#include "controller/module/rcs_shared.h"

#include <type_traits>

#include "controller/module/rcs_codec.h"
#include "controller/services/services.h"

namespace gsim::rrs {

namespace {

template <typename Structure>
constexpr std::size_t size() {
    static_assert(std::is_trivially_copyable_v<Structure> && sizeof(Structure) <= kMaxStructureSize);
    return sizeof(Structure);
}

template <>
constexpr std::size_t size<gsim_rcs_none>() {
    return 0;
}

}  // namespace

RcsSizes rcs_sizes(std::int32_t service_number) {
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments) \
    if (service_number == GSIM_RCS_##opcode) return {size<gsim_rcs_##input>(), 0};
#define GSIM_RCS_QUERY(method, opcode, number, rrs, input, output, statuses, parameters, arguments) \
    if (service_number == GSIM_RCS_##opcode) return {size<gsim_rcs_##input>(), size<gsim_rcs_##output>()};
#include "controller/module/rcs_services.def"
    return {};
}

std::string_view rcs_service_name(std::int32_t service_number) {
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments) \
    if (service_number == GSIM_RCS_##opcode) return services::method.name;
#include "controller/module/rcs_services.def"
    return {};
}

}  // namespace gsim::rrs
