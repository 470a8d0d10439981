#include "machine/schema/key_schema.h"

#include <array>
#include <utility>

namespace gsim::machine {

namespace {

struct Suffix {
    std::string_view end;
    std::string_view unit;
};
// The first match is used.
constexpr std::array kSuffixes{Suffix{"_n_per_mm_s", "N/(mm/s)"},
                               Suffix{"_nm_per_deg_s", "Nm/(deg/s)"},
                               Suffix{"_n_per_mm", "N/mm"},
                               Suffix{"_kg_m3", "kg/m3"},
                               Suffix{"_kg_m2", "kg m2"},
                               Suffix{"_kg", "kg"},
                               Suffix{"_nm", "Nm"},
                               Suffix{"_n", "N"},
                               Suffix{"_m_s2", "m/s2"},
                               Suffix{"_mm_s3", "mm/s3"},
                               Suffix{"_mm_s2", "mm/s2"},
                               Suffix{"_mm_s", "mm/s"},
                               Suffix{"_mm_min", "mm/min"},
                               Suffix{"_mm", "mm"},
                               Suffix{"_deg_s3", "deg/s3"},
                               Suffix{"_deg_s2", "deg/s2"},
                               Suffix{"_deg_s", "deg/s"},
                               Suffix{"_deg", "deg"},
                               Suffix{"_1_s", "1/s"},
                               Suffix{"_percents", "%"},
                               Suffix{"_percent", "%"},
                               Suffix{"_s", "s"}};

}  // namespace

KeySchema number_key(std::string name, const NumberRange& range, std::string fallback, std::string meaning) {
    return {.name = std::move(name),
            .kind = KeyKind::number,
            .meaning = std::move(meaning),
            .range = range,
            .fallback = std::move(fallback)};
}

KeySchema text_key(std::string name, std::string fallback, std::string meaning) {
    return {.name = std::move(name),
            .kind = KeyKind::text,
            .meaning = std::move(meaning),
            .fallback = std::move(fallback)};
}

KeySchema choice_key(std::string name, std::string fallback, std::vector<std::string> choices,
                     std::string meaning) {
    KeySchema key = text_key(std::move(name), std::move(fallback), std::move(meaning));
    key.choices = std::move(choices);
    return key;
}

KeySchema flag_key(std::string name, bool fallback, std::string meaning) {
    return {.name = std::move(name),
            .kind = KeyKind::boolean,
            .meaning = std::move(meaning),
            .fallback = fallback ? "true" : "false"};
}

KeySchema list_key(std::string name, KeyKind elements, std::size_t count, std::string meaning) {
    return {.name = std::move(name),
            .kind = KeyKind::list,
            .meaning = std::move(meaning),
            .elements = elements,
            .count = count};
}

KeySchema table_key(std::string name, std::string meaning) {
    return {.name = std::move(name), .kind = KeyKind::table, .meaning = std::move(meaning)};
}

KeySchema required(KeySchema key) {
    key.required = true;
    return key;
}

std::string key_unit(std::string_view name) {
    for (const Suffix& suffix : kSuffixes) {
        if (name.ends_with(suffix.end)) return std::string(suffix.unit);
    }
    return {};
}

std::vector<KeySchema> frame_schema() {
    return {number_key("x_mm", kFinite, "0.0", "position along X of the previous frame"),
            number_key("y_mm", kFinite, "0.0", "along Y"),
            number_key("z_mm", kFinite, "0.0", "along Z"),
            number_key("roll_deg", kFinite, "0.0",
                       "rotation about Z; the rotation is Rz(roll) Ry(pitch) Rx(yaw)"),
            number_key("pitch_deg", kFinite, "0.0", "rotation about Y"),
            number_key("yaw_deg", kFinite, "0.0", "rotation about X")};
}

std::vector<KeySchema> shape_schema() {
    constexpr NumberRange kLength{.min = 0, .max = 1e6, .exclusive_min = true};
    const auto lengths = [&](std::string name, std::size_t count, std::string meaning) {
        KeySchema key = list_key(std::move(name), KeyKind::number, count, std::move(meaning));
        key.range = kLength;
        return key;
    };
    return {lengths("box_mm", 3, "a box: its lengths along X, Y and Z; its frame is in the middle"),
            lengths("cylinder_mm", 2, "a cylinder along Z: diameter and height; its frame is in the middle"),
            lengths("capsule_mm", 2, "the same with a hemisphere at each end, beyond the height"),
            number_key("sphere_mm", kLength, "", "a sphere: its diameter"),
            text_key("mesh", "", "a file of triangles (.stl, .obj), or a STEP or IGES file"),
            number_key("scale", kPositive, "1.0", "for a mesh: factor from its unit to mm"),
            number_key("tolerance_mm", {.min = 0.001, .max = 100}, "0.05",
                       "for a STEP or IGES file: max deviation of the triangles from its surfaces")};
}

}  // namespace gsim::machine
