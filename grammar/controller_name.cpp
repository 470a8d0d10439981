#include "grammar/controller_name.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/nearest_name.h"

namespace gsim::grammar {

namespace {

struct ControllerEntry {
    std::string_view name;
    std::string_view dialect;  // Empty: no similar dialect.
    std::string_view caution;
};

constexpr std::string_view kAb9 = "ab9";
constexpr std::string_view kNgc = "rs274ngc";
constexpr std::string_view kKlipper = "klipper";

constexpr std::string_view kFanuc =
    "a relative of the 9/Series with the same macros and subprograms; codes and parameters of its own "
    "(G5.1, G54.1 P, G10 L50, #3000 on) are errors or mean what they mean on the 9/Series";
constexpr std::string_view kHaas =
    "a relative of the 9/Series; G12, G13, G70, G71, G150 and settings of its own are not read as it means "
    "them, and its programs in inches often do not say G20";
constexpr std::string_view kGrbl =
    "it knows a part of that language; what it lacks (O-words, parameters, cycles) passes here all the same";
constexpr std::string_view kMach =
    "a relative of LinuxCNC: M98 P with O numbers as there, but no O-words; G12, G13 and macros in M codes "
    "are its own";
constexpr std::string_view kPathPilot = "built on LinuxCNC; G47 and the M codes of its probing are its own";
constexpr std::string_view kEding = "a relative of LinuxCNC with IF and SUB of its own in place of O-words";
constexpr std::string_view kTinyG = "it knows a part of that language; its JSON commands are not read";

constexpr std::array kControllers{
    ControllerEntry{"ab9", kAb9, ""},
    ControllerEntry{"rs274ngc", kNgc, ""},
    ControllerEntry{"klipper", kKlipper, ""},
    ControllerEntry{"9/series", kAb9, ""},
    ControllerEntry{"allen-bradley", kAb9, ""},
    ControllerEntry{"linuxcnc", kNgc, ""},
    ControllerEntry{"emc2", kNgc, ""},
    ControllerEntry{"machinekit", kNgc, ""},
    ControllerEntry{"brother", kAb9, kFanuc},
    ControllerEntry{"doosan", kAb9, kFanuc},
    ControllerEntry{"fanuc", kAb9, kFanuc},
    ControllerEntry{"haas", kAb9, kHaas},
    ControllerEntry{"mazak-eia", kAb9, kFanuc},
    ControllerEntry{"mitsubishi", kAb9, kFanuc},
    ControllerEntry{"eding", kNgc, kEding},
    ControllerEntry{"fluidnc", kNgc, kGrbl},
    ControllerEntry{"g2core", kNgc, kTinyG},
    ControllerEntry{"grbl", kNgc, kGrbl},
    ControllerEntry{"grblhal", kNgc, kGrbl},
    ControllerEntry{"mach3", kNgc, kMach},
    ControllerEntry{"mach4", kNgc, kMach},
    ControllerEntry{"pathpilot", kNgc, kPathPilot},
    ControllerEntry{"tinyg", kNgc, kTinyG},
    ControllerEntry{"tormach", kNgc, kPathPilot},
    ControllerEntry{"heidenhain", "", "Heidenhain's own language (BEGIN PGM, L X+10 FMAX) is not read"},
    ControllerEntry{
        "siemens", "",
        "the language of Sinumerik (DEF, R1=, MCALL) is not read; programs in its ISO mode are near to ab9"},
    ControllerEntry{
        "sinumerik", "",
        "the language of Sinumerik (DEF, R1=, MCALL) is not read; programs in its ISO mode are near to ab9"},
    ControllerEntry{"okuma", "", "the language of OSP controls (VC1=, CALL O1, NLAP) is not read"},
};

// Returns letters and digits alone, in lower case.
std::string normalized_name(std::string_view name) {
    std::string out;
    for (const char c : name) {
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) out += c;
        if (c >= 'A' && c <= 'Z') out += static_cast<char>(c - 'A' + 'a');
    }
    return out;
}

std::string unknown(std::string_view name) {
    std::vector<std::string_view> known;
    known.reserve(kControllers.size());
    for (const ControllerEntry& controller : kControllers) known.push_back(controller.name);
    const auto nearest = text::nearest_name(name, known);
    return fmt::format("there is no dialect or control '{}'; {}", name,
                       nearest
                           ? fmt::format("did you mean '{}'?", *nearest)
                           : std::string("the dialects are ab9, rs274ngc and klipper, and docs/language.md "
                                         "lists the controls"));
}

}  // namespace

tl::expected<ControllerName, std::string> find_controller(std::string_view name) {
    const std::string requested = normalized_name(name);
    const auto* controller =
        std::find_if(kControllers.begin(), kControllers.end(),
                     [&](const ControllerEntry& one) { return normalized_name(one.name) == requested; });
    if (controller == kControllers.end()) return tl::unexpected(unknown(name));
    if (controller->dialect.empty()) return tl::unexpected(std::string(controller->caution));
    ControllerName found{.dialect = find_dialect(controller->dialect)};
    if (!controller->caution.empty()) {
        found.caution = fmt::format("programs of {} are read as {} ({}): {}", controller->name,
                                    controller->dialect, found.dialect->title(), controller->caution);
    }
    return found;
}

std::vector<std::string> controller_names() {
    std::vector<std::string> names;
    for (const ControllerEntry& controller : kControllers) {
        if (!controller.dialect.empty()) names.emplace_back(controller.name);
    }
    return names;
}

std::string controller_table() {
    std::string table = "| control | dialect | to mind |\n| --- | --- | --- |\n";
    for (const ControllerEntry& controller : kControllers) {
        text::append_format(
            table, "| `{}` | {} | {} |\n", controller.name,
            controller.dialect.empty() ? std::string("none") : fmt::format("`{}`", controller.dialect),
            controller.caution);
    }
    return table;
}

}  // namespace gsim::grammar
