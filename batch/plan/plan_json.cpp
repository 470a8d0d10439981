#include "batch/plan/plan_json.h"

#include <fmt/format.h>

namespace gsim::batch {

namespace {

using nlohmann::json;

json json_of(const Choices& choices) {
    return {{"values", choices.values}};
}
json json_of(const Uniform& uniform) {
    return {{"uniform", {uniform.from, uniform.to}}};
}
json json_of(const Normal& normal) {
    return {{"normal", {normal.mean, normal.deviation}}};
}
json json_of(const Triangular& triangle) {
    return {{"triangular", {triangle.from, triangle.to, triangle.mode}}};
}

Domain domain_in(const json& one) {
    if (one.contains("values")) return Choices{one.at("values").get<std::vector<json>>()};
    if (one.contains("uniform")) return Uniform{one.at("uniform").at(0), one.at("uniform").at(1)};
    if (one.contains("normal")) return Normal{one.at("normal").at(0), one.at("normal").at(1)};
    const json& triangle = one.at("triangular");
    return Triangular{triangle.at(0), triangle.at(1), triangle.at(2)};
}

}  // namespace

std::string print_plan_json(const Plan& plan) {
    json settings = json::array();
    for (const Setting& setting : plan.settings)
        settings.push_back(
            {{"key", setting.key},
             {"factor", setting.is_factor},
             {"domain", std::visit([](const auto& one) { return json_of(one); }, setting.domain)}});
    return json{{"name", plan.name},        {"programs", plan.programs}, {"machines", plan.machines},
                {"options", plan.options},  {"settings", settings},      {"sampling", plan.design.sampling},
                {"runs", plan.design.runs}, {"seed", plan.design.seed},  {"reports", plan.keeps_reports}}
        .dump(1, ' ', false, json::error_handler_t::replace);
}

tl::expected<Plan, std::string> read_plan_json(std::string_view text) {
    try {
        const json read = json::parse(text);
        Plan plan;
        read.at("name").get_to(plan.name);
        read.at("programs").get_to(plan.programs);
        read.at("machines").get_to(plan.machines);
        plan.options = read.at("options");
        for (const json& setting : read.at("settings"))
            plan.settings.push_back(
                {setting.at("key"), domain_in(setting.at("domain")), setting.at("factor")});
        read.at("sampling").get_to(plan.design.sampling);
        read.at("runs").get_to(plan.design.runs);
        read.at("seed").get_to(plan.design.seed);
        read.at("reports").get_to(plan.keeps_reports);
        return plan;
    } catch (const json::exception& error) {
        return tl::unexpected(fmt::format("no plan: {}", error.what()));
    }
}

}  // namespace gsim::batch
