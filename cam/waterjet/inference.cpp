#include "cam/waterjet/inference.h"

namespace gsim::waterjet {

std::string_view origin_name(Origin origin) {
    switch (origin) {
        case Origin::given: return "given";
        case Origin::from_file: return "file";
        case Origin::inferred: return "inferred";
    }
    return "";
}

double Settlement::given(std::string_view name, std::string_view unit, double value) {
    values_.push_back({name, unit, value, Origin::given, {}});
    return value;
}

double Settlement::from_file(std::string_view name, std::string_view unit, double value, std::string basis) {
    values_.push_back({name, unit, value, Origin::from_file, std::move(basis)});
    return value;
}

double Settlement::inferred(std::string_view name, std::string_view unit, Inferred value) {
    values_.push_back({name, unit, value.value, Origin::inferred, std::move(value.basis)});
    return value.value;
}

}  // namespace gsim::waterjet
