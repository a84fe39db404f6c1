#include "tools/shrink/candidates.hpp"

#include <algorithm>
#include <utility>

#include "tools/cli/interrupt.hpp"

namespace tumble::tools {

Candidates::Candidates(TrialSettings settings, std::string wanted, int jobs, std::filesystem::path folder,
                       TrialLog& log)
    : settings_(std::move(settings)),
      wanted_(std::move(wanted)),
      folder_(std::move(folder)),
      log_(log),
      busy_(static_cast<std::size_t>(jobs), false) {}

std::size_t Candidates::first_failing(std::size_t count, const Make& make) {
    busy_.assign(busy_.size(), false);
    std::vector<Asked> asked;  // those before `decided` do not fail the same
    for (std::size_t decided = 0; decided < count;) {
        const bool has_found =
            std::ranges::any_of(asked, [](const Asked& one) { return one.result && one.result->fails; });
        const bool has_slot = std::ranges::find(busy_, false) != busy_.end();
        if (asked.size() < count && (asked.size() == decided || (has_slot && !has_found))) {
            asked.push_back(ask(asked.size(), make));
            continue;
        }
        Asked& next = asked[decided];
        if (!next.result) {
            if (is_interrupted()) throw SearchInterrupted{};
            take_results(asked);
            if (!next.result) wait_briefly();
            continue;
        }
        if (next.text) needed_.insert(next.hash);
        if (next.result->fails) {
            text_ = *next.text;
            step_ = next.result->step;
            return decided;
        }
        ++decided;
    }
    return count;
}

Candidates::Asked Candidates::ask(std::size_t index, const Make& make) {
    Asked asked;
    asked.text = make(index);
    if (!asked.text) {
        asked.result = TrialLog::Result{};
        return asked;
    }
    asked.hash = hash_of(*asked.text);
    asked.result = log_.find(asked.hash);
    if (!asked.result) start(asked);
    return asked;
}

void Candidates::start(Asked& asked) {
    asked.slot = static_cast<std::size_t>(std::ranges::find(busy_, false) - busy_.begin());
    busy_[asked.slot] = true;
    asked.trial = std::make_unique<Trial>(*asked.text, settings_, file_of(asked.slot));
    ++new_run_count_;
}

void Candidates::take_results(std::vector<Asked>& asked) {
    for (Asked& one : asked) {
        if (!one.trial || !one.trial->has_ended()) continue;
        one.result = TrialLog::Result{};
        for (const Failure& failure : one.trial->failures())
            if (failure.text == wanted_) one.result = TrialLog::Result{true, failure.step};
        one.trial.reset();
        busy_[one.slot] = false;
        log_.add(one.hash, *one.result);
    }
}

std::filesystem::path Candidates::file_of(std::size_t slot) const {
    return folder_ / std::to_string(slot) / "scene.json";
}

}  // namespace tumble::tools
