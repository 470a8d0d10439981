#include "studio/engine/session.h"

#include <exception>
#include <utility>

#include <fmt/format.h>

#include "engine/language.h"
#include "engine/machine.h"
#include "engine/run.h"
#include "engine/translation.h"
#include "studio/engine/message.h"
#include "studio/engine/request.h"
#include "studio/engine/run_messages.h"

namespace gsim::studio {

namespace {

using engine::Failure;
using engine::Run;
using Done = tl::expected<void, Failure>;

Done run_one(engine::Request request, const Post& post) {
    auto run =
        Run::open(std::move(request), [&post](const engine::Diagnostic& told) { post_told(told, post); });
    if (!run) return tl::unexpected(run.error());
    if (auto prepared = run->prepare(); !prepared) {
        if (prepared.error().in_program) post_report(run->report_of(prepared.error()), post);
        return prepared;
    }
    if (auto told = post_run(*run, post); !told) return told;
    run->show_progress([&post](std::uint64_t done, std::uint64_t total) {
        Message message("progress");
        message.header().update({{"done", done}, {"total", total}});
        post(message.bytes());
    });
    const auto report = run->go();
    if (!report) return tl::unexpected(report.error());
    return post_end(*run, *report, post);
}

Done translate(const engine::Request& request, bool wants_script, const Post& post) {
    auto translation = engine::Translation::open(translation_request(request));
    if (!translation) return tl::unexpected(translation.error());
    if (auto made = translation->make([&post](const engine::Diagnostic& told) { post_told(told, post); });
        !made) {
        if (made.error().in_program) return {};  // the page has been told what is wrong
        return made;
    }
    if (!wants_script) return {};
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

Done envelope(const engine::Request& request, const Post& post) {
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

Done languages(const Post& post) {
    Message message("languages");
    message.header()["languages"] = nlohmann::ordered_json::parse(engine::languages_json());
    post(message.bytes());
    return {};
}

Failure failure(std::string sentence) {
    return {.code = "usage", .message = std::move(sentence)};
}

Done answer(const nlohmann::json& asked, const engine::Host& host, const Post& post) {
    auto request = run_request(asked);
    if (!request) return tl::unexpected(failure(request.error()));
    request->host = host;
    const auto told = asked.find("do");
    if (told == asked.end() || !told->is_string())
        return tl::unexpected(failure("'do' should be a text: run, check, translate, envelope or languages"));
    const auto what = told->get<std::string>();
    if (what == "run") return run_one(*std::move(request), post);
    if (what == "check" || what == "translate") return translate(*request, what == "translate", post);
    if (what == "envelope") return envelope(*request, post);
    if (what == "languages") return languages(post);
    return tl::unexpected(failure(fmt::format("nothing is known of how to do '{}'", what)));
}

/// The last message.
void end(const Done& done, const Post& post) {
    Message message(done ? "done" : "failed");
    if (!done) {
        message.header().update({{"code", done.error().code},
                                 {"message", done.error().message},
                                 {"file", done.error().file},
                                 {"in_program", done.error().in_program}});
    }
    post(message.bytes());
}

/// What an answer throws is a failure of it: a lack of memory, say.
template <typename Answer>
Done guarded(const Answer& answer) {
    try {
        return answer();
    } catch (const std::exception& fault) {
        return tl::unexpected(Failure{.code = "internal", .message = fault.what()});
    }
}

}  // namespace

void serve(std::string_view asked, const engine::Host& host, const Post& post) {
    end(guarded([&]() -> Done {
            const auto json = nlohmann::json::parse(asked, nullptr, false);
            if (json.is_discarded()) return tl::unexpected(failure("a request should be JSON"));
            return answer(json, host, post);
        }),
        post);
}

}  // namespace gsim::studio
