#include "batch/work/job.h"

#include <fmt/format.h>

#include "base/text/json.h"

namespace gsim::batch {

using nlohmann::json;

std::string print_job(const Job& job) {
    json settings = json::array();
    for (const SettingValue& setting : job.settings)
        settings.push_back({setting.key, setting.value, setting.use});
    return json{{"number", job.number},
                {"program", job.program},
                {"machine", job.machine},
                {"options", job.options},
                {"settings", settings},
                {"report", job.stored_documents.report},
                {"picture", job.stored_documents.picture}}
        .dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<Job> read_job(std::string_view line) {
    try {
        const json read = text::parse_json<json>(line);
        Job job{.number = read.at("number"),
                .program = read.at("program"),
                .machine = read.at("machine"),
                .options = read.at("options"),
                .settings = {},
                .stored_documents = {read.at("report"), read.at("picture")}};
        for (const json& setting : read.at("settings"))
            job.settings.push_back({setting.at(0), setting.at(1), setting.at(2)});
        return job;
    } catch (const json::exception& error) {
        return Unexpected(fmt::format("not a job: {}", error.what()));
    }
}

nlohmann::ordered_json settings_json(const std::vector<SettingValue>& settings) {
    nlohmann::ordered_json text = nlohmann::ordered_json::object();
    for (const SettingValue& setting : settings) {
        switch (setting.use) {
            case SettingUse::set: text[setting.key] = setting.value; break;
            case SettingUse::factor: text[setting.key] = "x " + setting.value.dump(); break;
            case SettingUse::shift: text[setting.key] = "+ " + setting.value.dump(); break;
        }
    }
    return text;
}

}  // namespace gsim::batch
