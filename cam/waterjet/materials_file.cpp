#include "cam/waterjet/materials_file.h"

#include <array>

#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"
#include "cam/waterjet/embedded_materials.h"
#include "cam/waterjet/value_range.h"

namespace gsim::waterjet {

namespace {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;
using std::string_view_literals::operator""sv;

constexpr std::array kFileKeys{"jet"sv, "lag"sv, "kerf"sv, "pierce"sv, "prices"sv, "material"sv};
constexpr std::array kJetKeys{"pressure_mpa"sv,    "orifice_mm"sv,        "mixing_tube_mm"sv,
                              "abrasive_g_min"sv,  "abrasive_factor"sv,   "discharge"sv,
                              "tube_to_orifice"sv, "abrasive_to_water"sv, "quality"sv};
constexpr std::array kLagKeys{"lag_to_thickness"sv, "exponent"sv, "contour_error_mm"sv, "min_feed_share"sv};
constexpr std::array kKerfKeys{"width_to_tube"sv, "taper_mm"sv};
constexpr std::array kPierceKeys{"factor"sv, "min_s"sv, "dynamic_share"sv};
constexpr std::array kPriceKeys{
    "currency"sv,       "machine_per_h"sv, "water_per_m3"sv,   "abrasive_per_kg"sv,  "recycled_per_kg"sv,
    "recycled_share"sv, "orifice_each"sv,  "orifice_life_h"sv, "mixing_tube_each"sv, "mixing_tube_life_h"sv,
};
constexpr std::array kMaterialKeys{"name"sv, "machinability"sv, "like"sv, "measured"sv, "source"sv};
constexpr std::array kMeasuredKeys{"speed_mm_min"sv,   "thickness_mm"sv,   "quality"sv,
                                   "pressure_mpa"sv,   "orifice_mm"sv,     "mixing_tube_mm"sv,
                                   "abrasive_g_min"sv, "abrasive_factor"sv};
constexpr std::size_t kMaxTextLength = 200;

constexpr ValueRange kAbrasiveFactor{"abrasive_factor", 0.01, 100};
constexpr ValueRange kDischarge{"discharge", 0.1, 1};
constexpr ValueRange kTubeRatio{"tube_to_orifice", 1.01, 20};
constexpr ValueRange kAbrasiveRatio{"abrasive_to_water", 0.001, 1};
constexpr ValueRange kLagRatio{"lag_to_thickness", 0.001, 10};
constexpr ValueRange kLagExponent{"exponent", 0.1, 10};
constexpr ValueRange kContourError{"contour_error_mm", 1e-4, 100};
constexpr ValueRange kMinFeed{"min_feed_share", 1e-4, 1};
constexpr ValueRange kWidthRatio{"width_to_tube", 0.1, 10};
constexpr ValueRange kTaper{"taper_mm", 0, 100};
constexpr ValueRange kPierceFactor{"factor", 0.001, 1e4};
constexpr ValueRange kMinPierce{"min_s", 0, 1e4};
constexpr ValueRange kDynamicPierce{"dynamic_share", 0.01, 1};
constexpr ValueRange kRecycled{"recycled_share", 0, 0.99};
constexpr double kMaxPrice = 1e6;
constexpr double kMinLife_h = 0.01;

std::optional<double> optional_number(TomlSection& section, const ValueRange& range) {
    if (!section.has(range.key)) return std::nullopt;
    const double value = section.number(range.key, range.min, NumberRule::finite);
    if (const auto error = range.find_error(value)) section.fail(range.key, error->message);
    return value;
}

double number(TomlSection& section, const ValueRange& range) {
    section.require(range.key);
    return optional_number(section, range).value_or(range.min);
}

double price(TomlSection& section, std::string_view key) {
    return number(section, {key, 0, kMaxPrice});
}

double life_h(TomlSection& section, std::string_view key) {
    return number(section, {key, kMinLife_h, kMaxPrice});
}

/// Returns a text that fits into one line of a report.
std::string short_text(TomlSection& section, std::string_view key) {
    std::string text = section.text(key);
    const bool printable = std::none_of(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
    if (!printable || text.empty() || text.size() > kMaxTextLength) {
        section.fail(
            key, fmt::format("'{}' must be 1 to {} bytes without control characters", key, kMaxTextLength));
    }
    return text;
}

void check_tube(TomlSection& section, double mixing_tube_mm, double orifice_mm) {
    if (mixing_tube_mm <= orifice_mm)
        section.fail("mixing_tube_mm", "'mixing_tube_mm' must be greater than 'orifice_mm'");
}

JetRule read_jet(TomlSection& section) {
    JetRule rule;
    rule.pressure_mpa = number(section, range::kPressure);
    rule.orifice_mm = number(section, range::kOrifice);
    rule.mixing_tube_mm = optional_number(section, range::kMixingTube);
    rule.abrasive_g_min = optional_number(section, range::kAbrasive);
    rule.abrasive_factor = number(section, kAbrasiveFactor);
    rule.discharge = number(section, kDischarge);
    rule.tube_to_orifice = number(section, kTubeRatio);
    rule.abrasive_to_water = number(section, kAbrasiveRatio);
    rule.quality = number(section, range::kQuality);
    if (rule.mixing_tube_mm) check_tube(section, *rule.mixing_tube_mm, rule.orifice_mm);
    return rule;
}

std::array<double, 5> read_contour_errors(TomlSection& section) {
    std::array<double, 5> errors{};
    constexpr std::string_view kKey = kContourError.key;
    const toml::node* node = section.require(kKey);
    if (!node) return errors;
    const toml::array* array = node->as_array();
    if (!array || array->size() != errors.size()) {
        section.fail(kKey, fmt::format("'{}' must be {} numbers in [], for the qualities 1 to 5", kKey,
                                       errors.size()));
        return errors;
    }
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const auto value = (*array)[i].value<double>();
        if (!value || kContourError.find_error(*value)) {
            section.fail(kKey, fmt::format("'{}' must contain numbers between {} and {}", kKey,
                                           kContourError.min, kContourError.max));
            return errors;
        }
        errors[i] = *value;
    }
    return errors;
}

LagRule read_lag(TomlSection& section) {
    return {.lag_to_thickness = number(section, kLagRatio),
            .exponent = number(section, kLagExponent),
            .contour_error_mm = read_contour_errors(section),
            .min_feed_share = number(section, kMinFeed)};
}

KerfRule read_kerf(TomlSection& section) {
    return {.width_to_tube = number(section, kWidthRatio), .taper_mm = number(section, kTaper)};
}

PierceRule read_pierce(TomlSection& section) {
    return {.factor = number(section, kPierceFactor),
            .min_s = number(section, kMinPierce),
            .dynamic_pierce_share = optional_number(section, kDynamicPierce)};
}

PriceRule read_prices(TomlSection& section) {
    return {.currency = short_text(section, "currency"),
            .machine_per_h = price(section, "machine_per_h"),
            .water_per_m3 = price(section, "water_per_m3"),
            .abrasive_per_kg = price(section, "abrasive_per_kg"),
            .recycled_per_kg = price(section, "recycled_per_kg"),
            .recycled_share = number(section, kRecycled),
            .orifice_price = price(section, "orifice_each"),
            .orifice_life_h = life_h(section, "orifice_life_h"),
            .mixing_tube_price = price(section, "mixing_tube_each"),
            .mixing_tube_life_h = life_h(section, "mixing_tube_life_h")};
}

MeasuredCut read_measured(FirstError& error, const toml::table& table) {
    TomlSection section(error, table, "'measured'", kMeasuredKeys);
    MeasuredCut cut{.jet = {.pressure_mpa = number(section, range::kPressure),
                            .orifice_mm = number(section, range::kOrifice),
                            .mixing_tube_mm = number(section, range::kMixingTube),
                            .abrasive_g_min = number(section, range::kAbrasive),
                            .abrasive_factor = number(section, kAbrasiveFactor)},
                    .speed_mm_min = number(section, range::kSpeed),
                    .thickness_mm = number(section, range::kThickness),
                    .quality = number(section, range::kQuality)};
    check_tube(section, cut.jet.mixing_tube_mm, cut.jet.orifice_mm);
    const double machinability =
        machinability_of_cut(cut.jet, cut.speed_mm_min, cut.thickness_mm, cut.quality);
    if (const auto range_error = range::kMachinability.find_error(machinability))
        section.fail("speed_mm_min", fmt::format("this cut is not possible: {}", range_error->message));
    return cut;
}

Material read_material(FirstError& error, const toml::table& table) {
    TomlSection section(error, table, "[[material]]", kMaterialKeys);
    Material material;
    material.name = short_text(section, "name");
    material.machinability = optional_number(section, range::kMachinability);
    if (section.has("like")) material.like = short_text(section, "like");
    if (const toml::table* measured = section.table("measured"))
        material.measured = read_measured(error, *measured);
    if (section.has("source")) material.source = short_text(section, "source");
    const int source_count = static_cast<int>(section.has("machinability")) +
                             static_cast<int>(section.has("like")) +
                             static_cast<int>(section.has("measured"));
    if (source_count != 1) {
        section.fail("name", fmt::format("the material {} must have one of 'machinability', 'like' and "
                                         "'measured'; it has {}",
                                         base::toml_string(material.name), source_count));
    }
    return material;
}

std::vector<Material> read_material_list(FirstError& error, TomlSection& file) {
    std::vector<Material> materials;
    const std::vector<const toml::table*> tables = file.tables("material");
    materials.reserve(tables.size());
    for (const toml::table* table : tables) {
        Material material = read_material(error, *table);
        const bool twice = std::any_of(materials.begin(), materials.end(),
                                       [&](const Material& other) { return other.name == material.name; });
        if (twice) {
            error.report(table->source().begin,
                         fmt::format("the material {} is given twice", base::toml_string(material.name)));
        }
        materials.push_back(std::move(material));
        if (error.text()) return materials;
    }
    if (materials.empty()) file.fail("material", "a materials file requires at least one [[material]]");
    return materials;
}

// A material that is cut like another one needs one with its own number, so that no cycles occur.
void check_references(FirstError& error, TomlSection& file, const Materials& all) {
    const std::vector<const toml::table*> tables = file.tables("material");
    for (std::size_t i = 0; i < all.materials.size(); ++i) {
        const Material& material = all.materials[i];
        if (material.like.empty()) continue;
        const toml::source_position where = tables[i]->get("like")->source().begin;
        const auto other = find_material(all, material.like);
        if (!other) {
            error.report(where, other.error().message);
        } else if (!(*other)->machinability) {
            error.report(where, fmt::format("'like' must name a material with a 'machinability'; {} has none",
                                            base::toml_string(material.like)));
        }
    }
}

template <typename Read>
auto read_section(FirstError& error, TomlSection& file, std::string_view key,
                  std::span<const std::string_view> keys, Read read) {
    file.require(key);
    const toml::table* table = file.table(key);
    const toml::table none;
    TomlSection section(error, table ? *table : none, fmt::format("[{}]", key), keys);
    return read(section);
}

Materials read_tables(FirstError& error, const toml::table& root) {
    TomlSection file(error, root, "a materials file", kFileKeys);
    Materials all;
    all.jet = read_section(error, file, "jet", kJetKeys, read_jet);
    all.lag = read_section(error, file, "lag", kLagKeys, read_lag);
    all.kerf = read_section(error, file, "kerf", kKerfKeys, read_kerf);
    all.pierce = read_section(error, file, "pierce", kPierceKeys, read_pierce);
    all.prices = read_section(error, file, "prices", kPriceKeys, read_prices);
    all.materials = read_material_list(error, file);
    if (!error.text()) check_references(error, file, all);
    return all;
}

}  // namespace

Result<Materials> read_materials(std::string_view toml_text, std::string_view file_name) {
    FirstError error(file_name);
    const toml::table root = base::parse_toml(error, toml_text);
    if (error.text()) return tl::unexpected(*error.text());
    Materials materials = read_tables(error, root);
    materials.warnings = error.warnings();
    if (error.text()) return tl::unexpected(*error.text());
    return materials;
}

Result<Materials> load_materials(const std::filesystem::path& path, os::NameSource name_source,
                                 const os::Files& files) {
    return files.read_text(path, name_source).and_then([&](const std::string& text) {
        return read_materials(text, path.string());
    });
}

std::string_view built_in_materials_toml() {
    return embedded::embedded_materials("materials.toml");
}

}  // namespace gsim::waterjet
