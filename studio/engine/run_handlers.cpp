#include <utility>

#include "base/text/json.h"
#include "engine/language.h"
#include "engine/machine.h"
#include "engine/run.h"
#include "engine/translation.h"
#include "studio/engine/message.h"
#include "studio/engine/request.h"
#include "studio/engine/request_handlers.h"
#include "studio/engine/run_series.h"

namespace gsim::studio {

using engine::Run;

namespace {

VoidResult translate(const engine::Request& request, bool with_script, const Post& post) {
    auto translation = engine::Translation::open(translation_request(request));
    if (!translation) return tl::unexpected(translation.error());
    if (auto result = translation->make(
            [&post](const engine::Diagnostic& reported) { send_diagnostic(reported, post); });
        !result) {
        if (result.error().in_program) return {};  // the page already has the error
        return result;
    }
    if (!with_script) return {};
    std::string script;
    auto written = translation->write([&](std::string_view part) {
        script += part;
        return true;
    });
    if (!written) return written;
    Message message("script");
    message.add("lua", script);
    post(message.bytes());
    return {};
}

}  // namespace

VoidResult handle_run(const nlohmann::json& /*own*/, const engine::Request& request, const Post& post) {
    RunSeries series;
    auto run =
        Run::open(request, [&post](const engine::Diagnostic& reported) { send_diagnostic(reported, post); });
    if (!run) return tl::unexpected(run.error());
    if (auto prepared = run->prepare(); !prepared) {
        if (prepared.error().in_program) send_report(run->make_report(prepared.error()), post);
        return prepared;
    }
    if (auto reported = send_run(*run, series, post); !reported) return reported;
    run->on_progress([&post](std::uint64_t done, std::uint64_t total) {
        Message message("progress");
        message.header().update({{"done", done}, {"total", total}});
        post(message.bytes());
    });
    const auto report = run->go();
    if (!report) return tl::unexpected(report.error());
    return send_end(*run, series, *report, post);
}

VoidResult handle_check(const nlohmann::json& /*own*/, const engine::Request& request, const Post& post) {
    return translate(request, false, post);
}

VoidResult handle_translate(const nlohmann::json& /*own*/, const engine::Request& request, const Post& post) {
    return translate(request, true, post);
}

VoidResult handle_envelope(const nlohmann::json& /*own*/, const engine::Request& request, const Post& post) {
    auto machine = engine::Machine::read(request);
    if (!machine) return tl::unexpected(machine.error());
    auto surface = machine->envelope(engine::EnvelopeKind::volume_stl);
    if (!surface) return tl::unexpected(surface.error());
    Message message("envelope");
    message.header()["summary"] = machine->envelope_summary();
    message.add("stl", *surface);
    post(message.bytes());
    return {};
}

VoidResult handle_languages(const nlohmann::json& /*own*/, const engine::Request& /*request*/,
                            const Post& post) {
    Message message("languages");
    message.header()["languages"] = text::parse_json<nlohmann::ordered_json>(engine::languages_json());
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
