#include "apps/studio/view_page.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/studio/gzip.h"
#include "base/os/input_file.h"
#include "base/os/installation.h"
#include "base/os/output_file.h"
#include "base/text/base64.h"
#include "studio/engine/message.h"
#include "studio/engine/run_messages.h"
#include "studio/engine/run_series.h"

namespace gsim::apps {

namespace {

constexpr const char* kPage = "studio/view.html";
constexpr const char* kPipe = "stdin";  // as the run calls its program then
constexpr std::size_t kLargestPage = std::size_t{64} << 20U;
constexpr std::size_t kLargestSource = std::size_t{512} << 20U;
constexpr std::string_view kPlace = "<!-- run -->";
constexpr std::string_view kBefore = "<script type=\"application/octet-stream\" id=\"run\">";
constexpr std::string_view kBehind = "</script>";

tl::expected<void, std::string> with_sentence(const tl::expected<void, engine::Failure>& done) {
    if (done) return {};
    return tl::unexpected(done.error().message);
}

}  // namespace

class ViewPage::State {
  public:
    State(std::string name, std::string page) : name_(std::move(name)), page_(std::move(page)) {}

    const studio::Post& post() const { return post_; }
    studio::RunSeries& series() { return series_; }

    tl::expected<void, std::string> begin() {
        return os::OutputFile::open(name_).map([this](os::OutputFile file) {
            file_.emplace(std::move(file));
            file_->write(std::string_view(page_).substr(0, page_.find(kPlace)));
            file_->write(kBefore);
        });
    }

    tl::expected<void, std::string> end() {
        text_.clear();
        packed_.clear();
        gzip_.end(packed_);
        base64_.add(packed_, text_);
        base64_.end(text_);
        file_->write(text_);
        file_->write(kBehind);
        file_->write(std::string_view(page_).substr(page_.find(kPlace) + kPlace.size()));
        return file_->settle();
    }
    tl::expected<void, std::string> commit() { return file_->commit(); }

  private:
    void put(const std::string& bytes) {
        text_.clear();
        packed_.clear();
        gzip_.add(bytes, packed_);
        base64_.add(packed_, text_);
        file_->write(text_);
    }

    std::string name_;
    std::string page_;
    std::optional<os::OutputFile> file_;
    Gzip gzip_;
    text::Base64 base64_;
    std::string packed_, text_;
    studio::RunSeries series_;
    studio::Post post_ = [this](const std::string& bytes) { put(bytes); };
};

ViewPage::ViewPage(std::unique_ptr<State> state) : state_(std::move(state)) {}
ViewPage::~ViewPage() = default;

tl::expected<std::unique_ptr<ViewPage>, std::string> ViewPage::open(const std::string& file) {
    std::string why = "it is not known where the program lies";
    for (const auto& folder : os::data_folders(os::program_folder())) {
        const std::string page = folder / kPage;
        auto text = os::read_input(page, os::NamedBy::a_file, kLargestPage);
        if (text && text->find(kPlace) != std::string::npos)
            return std::unique_ptr<ViewPage>(new ViewPage(std::make_unique<State>(file, *std::move(text))));
        why = text ? fmt::format("'{}' has no place for a run", page) : text.error();
    }
    return tl::unexpected(fmt::format(
        "--view needs the page of the studio, which is not there ({}); `make studio` makes it", why));
}

tl::expected<void, std::string> ViewPage::attach(engine::Run& run) {
    return state_->begin().and_then(
        [&] { return with_sentence(studio::post_run(run, state_->series(), state_->post())); });
}

// Input from a pipe can be read only once, so such a run is shown without its source. The text is that of the
// file after the run, as far as the run may still read it.
tl::expected<void, std::string> ViewPage::finish(const engine::Run& run, const engine::Report& report) {
    std::vector<std::string> sources;
    for (std::size_t robot = 0; robot < run.robots().size(); ++robot) {
        for (const std::string& name : run.files(robot)) {
            const bool is_pipe = run.request().program == os::kStandardStream && name == kPipe;
            if (!is_pipe && std::find(sources.begin(), sources.end(), name) == sources.end())
                sources.push_back(name);
        }
    }
    for (const std::string& name : sources) {
        const auto text = os::read_input(name, os::NamedBy::a_file, kLargestSource);
        if (!text) continue;
        studio::Message message("source");
        message.header()["name"] = name;
        message.add("text", *text);
        state_->post()(message.bytes());
    }
    return with_sentence(studio::post_end(run, state_->series(), report, state_->post())).and_then([&] {
        return state_->end();
    });
}

tl::expected<void, std::string> ViewPage::commit() {
    return state_->commit();
}

}  // namespace gsim::apps
