#include "batch/plan/plan_json.h"

#include <fmt/format.h>

#include "base/text/json.h"

namespace gsim::batch {

namespace {

using nlohmann::json;

json as_json(const Choices& choices) {
    return {{"values", choices.values}};
}
json as_json(const Uniform& uniform) {
    return {{"uniform", {uniform.from, uniform.to}}};
}
json as_json(const Normal& normal) {
    return {{"normal", {normal.mean, normal.deviation}}};
}
json as_json(const Triangular& triangle) {
    return {{"triangular", {triangle.from, triangle.to, triangle.mode}}};
}

json as_json(const Order& order) {
    return {{"order", order.count}};
}

json as_json(const std::vector<SettingValue>& values) {
    json list = json::array();
    for (const SettingValue& value : values) list.push_back({value.key, value.value, value.use});
    return list;
}

std::vector<SettingValue> parse_variant(const json& list) {
    std::vector<SettingValue> values;
    for (const json& value : list) values.push_back({value.at(0), value.at(1), value.at(2)});
    return values;
}

Domain parse_domain(const json& one) {
    if (one.contains("values")) return Choices{one.at("values").get<std::vector<json>>()};
    if (one.contains("uniform")) return Uniform{one.at("uniform").at(0), one.at("uniform").at(1)};
    if (one.contains("normal")) return Normal{one.at("normal").at(0), one.at("normal").at(1)};
    if (one.contains("order")) return Order{one.at("order")};
    const json& triangle = one.at("triangular");
    return Triangular{triangle.at(0), triangle.at(1), triangle.at(2)};
}

}  // namespace

std::string print_plan_json(const Plan& plan) {
    json settings = json::array();
    for (const Setting& setting : plan.settings)
        settings.push_back(
            {{"keys", setting.keys},
             {"use", setting.use},
             {"domain", std::visit([](const auto& one) { return as_json(one); }, setting.domain)}});
    json listed = json::array();
    for (const auto& variant : plan.design.listed) listed.push_back(as_json(variant));
    return json{{"name", plan.name},
                {"listed", listed},
                {"programs", plan.programs},
                {"machines", plan.machines},
                {"options", plan.options},
                {"settings", settings},
                {"sampling", plan.design.sampling},
                {"runs", plan.design.runs},
                {"seed", plan.design.seed},
                {"reports", plan.stored_documents.report},
                {"pictures", plan.stored_documents.picture}}
        .dump(1, ' ', false, json::error_handler_t::replace);
}

Result<Plan> read_plan_json(std::string_view text) {
    try {
        const json read = text::parse_json<json>(text);
        Plan plan;
        read.at("name").get_to(plan.name);
        read.at("programs").get_to(plan.programs);
        read.at("machines").get_to(plan.machines);
        plan.options = read.at("options");
        for (const json& setting : read.at("settings"))
            plan.settings.push_back(
                {setting.at("keys"), parse_domain(setting.at("domain")), setting.at("use")});
        for (const json& variant : read.at("listed")) plan.design.listed.push_back(parse_variant(variant));
        read.at("sampling").get_to(plan.design.sampling);
        read.at("runs").get_to(plan.design.runs);
        read.at("seed").get_to(plan.design.seed);
        read.at("reports").get_to(plan.stored_documents.report);
        read.at("pictures").get_to(plan.stored_documents.picture);
        return plan;
    } catch (const json::exception& error) {
        return Unexpected(fmt::format("not a plan: {}", error.what()));
    }
}

}  // namespace gsim::batch
