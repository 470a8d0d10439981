#include "grammar/controller_name.h"

#include <algorithm>
#include <array>
#include <iterator>

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

constexpr std::string_view kFanuc =
    "similar to the 9/Series, with the same macros and subprograms; its additional codes and parameters "
    "(G5.1, G54.1 P, G10 L50, #3000 on) are errors or have the meaning of the 9/Series";
constexpr std::string_view kHaas =
    "similar to the 9/Series; G12, G13, G70, G71, G150 and its additional settings do not have its meaning "
    "here, and its programs in inches often lack G20";
constexpr std::string_view kGrbl =
    "it supports a part of that language; the parts that it lacks (O-words, parameters, cycles) are accepted "
    "here";
constexpr std::string_view kMach =
    "similar to LinuxCNC: M98 P with O numbers, but no O-words; G12, G13 and macros in M codes are specific "
    "to it";
constexpr std::string_view kPathPilot =
    "based on LinuxCNC; G47 and the M codes of its probing are specific to it";
constexpr std::string_view kEding = "similar to LinuxCNC, but with a specific IF and SUB instead of O-words";
constexpr std::string_view kTinyG =
    "it supports a part of that language; its JSON commands are not supported here";

// The names of the dialects come before these; a row with such a name is ignored.
constexpr std::array kControllers{
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
    ControllerEntry{"heidenhain", "", "the language of Heidenhain (BEGIN PGM, L X+10 FMAX) is not supported"},
    ControllerEntry{"siemens", "",
                    "the language of Sinumerik (DEF, R1=, MCALL) is not supported; programs in its ISO mode "
                    "are similar to ab9"},
    ControllerEntry{"sinumerik", "",
                    "the language of Sinumerik (DEF, R1=, MCALL) is not supported; programs in its ISO mode "
                    "are similar to ab9"},
    ControllerEntry{"okuma", "", "the language of OSP controllers (VC1=, CALL O1, NLAP) is not supported"},
};

/// Returns the dialects by their names, and then the controllers.
std::vector<ControllerEntry> controllers() {
    std::vector<ControllerEntry> entries;
    for (const std::string_view name : dialect_names()) entries.push_back({name, name, ""});
    std::copy_if(kControllers.begin(), kControllers.end(), std::back_inserter(entries),
                 [](const ControllerEntry& controller) { return find_dialect(controller.name) == nullptr; });
    return entries;
}

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
    for (const ControllerEntry& controller : controllers()) known.push_back(controller.name);
    const auto nearest = text::nearest_name(name, known);
    return fmt::format("unknown dialect or controller '{}'; {}", name,
                       nearest
                           ? fmt::format("did you mean '{}'?", *nearest)
                           : fmt::format("the dialects are {}, and docs/language.md lists the controllers",
                                         text::enumerated(dialect_names(), "and")));
}

}  // namespace

tl::expected<ControllerName, std::string> find_controller(std::string_view name) {
    const std::string requested = normalized_name(name);
    const std::vector<ControllerEntry> entries = controllers();
    const auto controller = std::find_if(entries.begin(), entries.end(), [&](const ControllerEntry& one) {
        return normalized_name(one.name) == requested;
    });
    if (controller == entries.end()) return tl::unexpected(unknown(name));
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
    for (const ControllerEntry& controller : controllers()) {
        if (!controller.dialect.empty()) names.emplace_back(controller.name);
    }
    return names;
}

std::string controller_table() {
    std::string table = "| controller | dialect | notes |\n| --- | --- | --- |\n";
    for (const ControllerEntry& controller : controllers()) {
        text::append_format(
            table, "| `{}` | {} | {} |\n", controller.name,
            controller.dialect.empty() ? std::string("none") : fmt::format("`{}`", controller.dialect),
            controller.caution);
    }
    return table;
}

}  // namespace gsim::grammar
