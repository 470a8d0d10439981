#include "cam/waterjet/value_resolver.h"

namespace gsim::waterjet {

std::string_view origin_name(Origin origin) {
    switch (origin) {
        case Origin::from_request: return "given";
        case Origin::from_file: return "file";
        case Origin::inferred: return "inferred";
    }
    return "";
}

double ValueResolver::from_request(std::string_view name, std::string_view unit, double value) {
    values_.push_back({name, unit, value, Origin::from_request, {}});
    return value;
}

double ValueResolver::from_file(std::string_view name, std::string_view unit, double value,
                                std::string basis) {
    values_.push_back({name, unit, value, Origin::from_file, std::move(basis)});
    return value;
}

double ValueResolver::inferred(std::string_view name, std::string_view unit, InferredValue value) {
    values_.push_back({name, unit, value.value, Origin::inferred, std::move(value.basis)});
    return value.value;
}

}  // namespace gsim::waterjet
