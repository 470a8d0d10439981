#include "machine/file/controller_file.h"

#include <array>

#include "base/text/format.h"
#include "base/text/printable.h"
#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"
#include "machine/embedded_controllers.h"
#include "machine/schema/controller_keys.h"

namespace gsim::machine {

namespace {

using base::FirstError;
using base::TomlSection;
using base::TomlWriter;

using std::string_view_literals::operator""sv;

constexpr std::array kControllerFileKeys{"controller"sv};
constexpr std::string_view kExtension = ".toml";

std::string unknown_model(std::string_view model) {
    const std::vector<std::string_view> known = built_in_controllers();
    const auto nearest = text::nearest_name(model, known);
    return fmt::format(
        "unknown controller {}; {}built-in controllers are {}; the name of a controller file ends in .toml",
        base::toml_string(model),
        nearest ? fmt::format("did you mean {}? ", base::toml_string(*nearest)) : std::string(),
        text::joined(known, ", "));
}

/// Location in which custom controller files are searched.
struct CustomFiles {
    const std::filesystem::path& folder;
    const os::Files& files;
};

rrs::ControllerRules read_custom_file(TomlSection& section, const std::string& model,
                                      const CustomFiles& local_files) {
    if (!text::is_printable(model)) {
        section.fail(kModelKey, "'model' must not contain control characters");
        return {};
    }
    const std::filesystem::path path = local_files.folder / model;
    const auto text = local_files.files.read_text(path);
    if (!text) {
        section.fail(kModelKey, text.error().message);
        return {};
    }
    FileMessages messages;
    auto rules = read_controller(*text, path.string(), model, &messages);
    for (std::string& warning : messages.warnings) section.add_file_warning(std::move(warning));
    if (rules) return *std::move(rules);
    section.add_file_error(std::move(rules).error().message);
    return {};
}

// Reads the rules that the section's other keys change. Without `local_files` custom files are not available.
rrs::ControllerRules read_model(TomlSection& section, const CustomFiles* local_files) {
    if (!section.has(kModelKey)) return {};
    const std::string model = section.text(kModelKey);
    if (const auto rules = built_in_controller(model)) return *rules;
    if (!model.ends_with(kExtension)) {
        section.fail(kModelKey, unknown_model(model));
        return {};
    }
    if (local_files != nullptr) return read_custom_file(section, model, *local_files);
    section.fail(kModelKey, fmt::format("'model' of a controller file must be one of {}",
                                        text::joined(built_in_controllers(), ", ")));
    return {};
}

}  // namespace

Result<rrs::ControllerRules> read_controller(std::string_view toml_text, std::string_view file_name,
                                             std::string model, FileMessages* messages) {
    FirstError error(file_name);
    const toml::table root = base::parse_toml(error, toml_text);
    TomlSection file(error, root, "a controller file", kControllerFileKeys);
    rrs::ControllerRules rules;
    file.require("controller");
    if (const toml::table* table = file.table("controller")) {
        TomlSection section(error, *table, "[controller]", controller_keys());
        rules = read_model(section, nullptr);
        rules.model = std::move(model);
        read_controller_keys(section, rules);
    }
    if (messages != nullptr) *messages = {error.all(), error.warnings()};
    if (error.text()) return tl::unexpected(*error.text());
    return rules;
}

std::vector<std::string_view> built_in_controllers() {
    std::vector<std::string_view> names;
    for (const auto& [file_name, text] : embedded::embedded_controllers())
        names.push_back(file_name.substr(0, file_name.size() - kExtension.size()));
    return names;
}

std::string_view built_in_controller_toml(std::string_view model) {
    return embedded::embedded_controllers(fmt::format("{}{}", model, kExtension));
}

std::optional<rrs::ControllerRules> built_in_controller(std::string_view model) {
    const std::string_view text = built_in_controller_toml(model);
    if (!text.data()) return std::nullopt;
    return read_controller(text, model, std::string(model)).value();
}

rrs::ControllerRules read_controller_section(TomlSection& section, const std::filesystem::path& folder,
                                             const os::Files& files) {
    const CustomFiles local_files{folder, files};
    rrs::ControllerRules rules = read_model(section, &local_files);
    read_controller_keys(section, rules);
    return rules;
}

void print_controller(TomlWriter& out, const rrs::ControllerRules& rules) {
    if (rules == rrs::ControllerRules{}) return;
    const rrs::ControllerRules base = built_in_controller(rules.model).value_or(rrs::ControllerRules{});
    out.section("[controller]");
    out.line(kModelKey, base::toml_string(base.model));
    print_controller_keys(out, rules, base);
}

}  // namespace gsim::machine
