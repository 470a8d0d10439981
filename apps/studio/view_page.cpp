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

constexpr const char* kPageFile = "studio/view.html";
constexpr const char* kStandardInputName = "stdin";  // as the run calls its program then
constexpr std::size_t kMaxPageBytes = std::size_t{64} << 20U;
constexpr std::size_t kMaxSourceBytes = std::size_t{512} << 20U;
constexpr std::string_view kRunPlaceholder = "<!-- run -->";
constexpr std::string_view kRunPrefix = "<script type=\"application/octet-stream\" id=\"run\">";
constexpr std::string_view kRunSuffix = "</script>";

Result<void> with_message(const tl::expected<void, engine::Error>& done) {
    if (done) return {};
    return tl::unexpected(done.error().message);
}

}  // namespace

class ViewPage::State {
  public:
    State(std::string name, std::string page) : name_(std::move(name)), page_(std::move(page)) {}

    const studio::Post& post() const { return post_; }
    studio::RunSeries& series() { return series_; }

    Result<void> begin() {
        return os::OutputFile::open(name_).map([this](os::OutputFile file) {
            file_.emplace(std::move(file));
            file_->write(std::string_view(page_).substr(0, page_.find(kRunPlaceholder)));
            file_->write(kRunPrefix);
        });
    }

    Result<void> end() {
        text_.clear();
        compressed_.clear();
        gzip_.end(compressed_);
        base64_.add(compressed_, text_);
        base64_.end(text_);
        file_->write(text_);
        file_->write(kRunSuffix);
        file_->write(std::string_view(page_).substr(page_.find(kRunPlaceholder) + kRunPlaceholder.size()));
        return file_->prepare_commit();
    }
    Result<void> commit() { return file_->commit(); }

  private:
    void write_compressed(const std::string& bytes) {
        text_.clear();
        compressed_.clear();
        gzip_.add(bytes, compressed_);
        base64_.add(compressed_, text_);
        file_->write(text_);
    }

    std::string name_;
    std::string page_;
    std::optional<os::OutputFile> file_;
    Gzip gzip_;
    text::Base64 base64_;
    std::string compressed_, text_;
    studio::RunSeries series_;
    studio::Post post_ = [this](const std::string& bytes) { write_compressed(bytes); };
};

ViewPage::ViewPage(std::unique_ptr<State> state) : state_(std::move(state)) {}
ViewPage::~ViewPage() = default;

Result<std::unique_ptr<ViewPage>> ViewPage::open(const std::string& file) {
    std::string reason = "the folder of the program is unknown";
    for (const auto& folder : os::data_folders(os::program_folder())) {
        const std::string page = folder / kPageFile;
        auto text = os::read_input(page, os::NameSource::in_file, kMaxPageBytes);
        if (text && text->find(kRunPlaceholder) != std::string::npos)
            return std::unique_ptr<ViewPage>(new ViewPage(std::make_unique<State>(file, *std::move(text))));
        reason = text ? fmt::format("'{}' has no placeholder for a run", page) : text.error().message;
    }
    return Unexpected(fmt::format(
        "--view requires the Studio page, which is not installed ({}); `make studio` builds it", reason));
}

Result<void> ViewPage::attach(engine::Run& run) {
    return state_->begin().and_then(
        [&] { return with_message(studio::send_run(run, state_->series(), state_->post())); });
}

// Input from a pipe can be read only once, so such a run is shown without its source. The text is that of the
// file after the run, as far as the run may still read it.
Result<void> ViewPage::finish(const engine::Run& run, const engine::Report& report) {
    std::vector<std::string> sources;
    for (std::size_t robot = 0; robot < run.robots().size(); ++robot) {
        for (const std::string& name : run.files(robot)) {
            const bool is_pipe = run.request().program == os::kStandardStream && name == kStandardInputName;
            if (!is_pipe && std::find(sources.begin(), sources.end(), name) == sources.end())
                sources.push_back(name);
        }
    }
    for (const std::string& name : sources) {
        const auto text = os::read_input(name, os::NameSource::in_file, kMaxSourceBytes);
        if (!text) continue;
        studio::Message message("source");
        message.header()["name"] = name;
        message.add("text", *text);
        state_->post()(message.bytes());
    }
    return with_message(studio::send_end(run, state_->series(), report, state_->post())).and_then([&] {
        return state_->end();
    });
}

Result<void> ViewPage::commit() {
    return state_->commit();
}

}  // namespace gsim::apps
