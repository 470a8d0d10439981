#include "controller/module/rcs_process.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "controller/module/rcs_link.h"
#include "controller/module/rcs_unset_output.h"

namespace gsim::rrs {

namespace {

bool is_target_service(std::int32_t opcode) {
    return opcode == GSIM_RCS_SET_NEXT_TARGET || opcode == GSIM_RCS_SET_NEXT_NAMED_TARGET ||
           opcode == GSIM_RCS_SET_NEXT_ARC_TARGET || opcode == GSIM_RCS_SET_NEXT_REST;
}

/// A controller in a separate process.
class RcsProcess final : public RcsCalls {
  public:
    RcsProcess(std::string name, std::unique_ptr<RcsLink> link)
        : name_(std::move(name)), link_(std::move(link)), shared_(link_->shared()) {}

    const std::string& name() const override { return name_; }
    std::int32_t call(std::int32_t opcode, const void* input, void* output) override;
    void announce(RcsPrefetch prefetch, bool queries_targets) override {
        prefetch_ = prefetch;
        queries_targets_ = queries_targets;
    }
    std::optional<std::string> loss() const override { return loss_; }
    double cpu_s() const override { return link_->cpu_s(); }

  private:
    std::int32_t send_request(std::int32_t opcode, const void* input, void* output);
    std::int32_t next_step(void* output);
    std::int32_t step_target(void* output);
    std::int32_t enqueue(std::int32_t opcode, const void* input);
    std::int32_t retry_result();
    void prepare_request(RcsPrefetch prefetch);
    void fetch_steps();
    std::int32_t lost();
    bool all_consumed() const { return queried_count_ == fetched_count_; }

    std::string name_;
    std::unique_ptr<RcsLink> link_;
    RcsShared& shared_;
    RcsPrefetch prefetch_ = RcsPrefetch::unknown;
    bool queries_targets_ = false;
    std::uint32_t fetched_count_ = 0;   ///< Steps that were made ahead,
    std::uint32_t queried_count_ = 0;   ///< and those of them that were asked for.
    std::int32_t retried_service_ = 0;  ///< Target that was then enqueued once more; 0: none.
    std::optional<std::string> loss_;
};

/// The process may have been lost ahead of the request; then the caller notices it here.
std::int32_t RcsProcess::lost() {
    const RcsLoss& loss = *link_->loss();
    const std::string_view service = rcs_service_name(loss.service);
    const std::string where = service.empty() ? " between two services" : fmt::format(" in {}", service);
    if (!loss_) loss_ = loss.what + where + loss.reason;
    return GSIM_RCS_FAULT;
}

std::int32_t RcsProcess::send_request(std::int32_t opcode, const void* input, void* output) {
    const RcsSizes sizes = rcs_sizes(opcode);
    shared_.prefetch = static_cast<std::int32_t>(RcsPrefetch::unknown);
    if (input != nullptr) std::memcpy(shared_.input.data(), input, sizes.input);
    if (output != nullptr) std::memcpy(shared_.output.data(), output, sizes.output);
    const auto status = link_->send_request(RcsRequest::call, opcode);
    if (!status) return lost();
    if (output != nullptr) std::memcpy(output, shared_.output.data(), sizes.output);
    return *status;
}

void RcsProcess::prepare_request(RcsPrefetch prefetch) {
    shared_.prefetch = static_cast<std::int32_t>(prefetch);
    shared_.queries_targets = queries_targets_ ? 1 : 0;
    shared_.step_count = 0;
    shared_.was_full = 0;
    shared_.has_retry = 0;
    shared_.empty_step = make_unset_output<gsim_rcs_step>();
    shared_.empty_target = make_unset_output<gsim_rcs_target_id>();
}

void RcsProcess::fetch_steps() {
    fetched_count_ =
        std::min<std::uint32_t>(shared_.step_count.load(std::memory_order_acquire), kMaxPrefetchedSteps);
    queried_count_ = 0;
}

std::int32_t RcsProcess::next_step(void* output) {
    if (all_consumed()) {
        prepare_request(prefetch_);
        const auto status = link_->send_request(RcsRequest::steps);
        fetch_steps();
        if (all_consumed()) return status ? GSIM_RCS_FAULT : lost();
    }
    const RcsSharedStep& step = shared_.steps[queried_count_++];
    std::memcpy(output, &step.step, sizeof step.step);
    return step.status;
}

/// Returns the target of the step that was consumed last.
std::int32_t RcsProcess::step_target(void* output) {
    const RcsSharedStep& step = shared_.steps[queried_count_ - 1];
    const std::int32_t status = step.target_status.load(std::memory_order_acquire);
    if (status == kPending && link_->loss()) return lost();
    std::memcpy(output, &step.target, sizeof step.target);
    return status;
}

std::int32_t RcsProcess::enqueue(std::int32_t opcode, const void* input) {
    prepare_request(RcsPrefetch::if_full);
    std::memcpy(shared_.input.data(), input, rcs_sizes(opcode).input);
    const auto status = link_->send_request(RcsRequest::call, opcode);
    if (shared_.was_full.load() == 0) return status ? *status : lost();
    fetch_steps();
    if (status && shared_.has_retry.load() != 0) retried_service_ = opcode;
    return GSIM_RCS_QUEUE_FULL;
}

std::int32_t RcsProcess::retry_result() {
    retried_service_ = 0;
    return shared_.retry_status;
}

std::int32_t RcsProcess::call(std::int32_t opcode, const void* input, void* output) {
    if (loss_) return GSIM_RCS_FAULT;
    if (opcode == GSIM_RCS_GET_NEXT_STEP && (prefetch_ != RcsPrefetch::unknown || !all_consumed()))
        return next_step(output);
    if (opcode == GSIM_RCS_GET_TARGET_OF_LAST_STEP && queried_count_ > 0 &&
        shared_.steps[queried_count_ - 1].target_status.load() != kNotQueried)
        return step_target(output);
    if (!all_consumed()) throw std::logic_error("a service is called between prefetched steps");
    if (link_->loss()) return lost();
    if (retried_service_ == opcode) return retry_result();
    fetched_count_ = queried_count_ = 0;
    retried_service_ = 0;
    if (prefetch_ != RcsPrefetch::if_full || !is_target_service(opcode))
        return send_request(opcode, input, output);
    return enqueue(opcode, input);
}

Unexpected load_failure(const std::string& name, const RcsLoss& loss) {
    return Unexpected(
        fmt::format("the controller module {} {}{} while it was loaded", name, loss.what, loss.reason));
}

}  // namespace

Result<RcsModule> start_rcs_process(const std::filesystem::path& program, const std::string& path,
                                    const gsim_rcs_machine& machine, RcsProcessLimits limits) {
    auto link = RcsLink::begin(program, path, machine, limits);
    if (!link) return tl::unexpected(std::move(link.error()));
    std::string name = std::filesystem::path(path).filename().string();
    const auto loaded = (*link)->send_request(RcsRequest::load);
    if (!loaded) return load_failure(name, *(*link)->loss());
    const auto& module_output = (*link)->shared().output;
    if (*loaded != 0) return tl::unexpected(rcs_text(module_output.data(), module_output.size()));
    return RcsModule(std::make_unique<RcsProcess>(std::move(name), *std::move(link)));
}

}  // namespace gsim::rrs
