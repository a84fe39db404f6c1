#include "tools/shrink/shrinker.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <limits>
#include <utility>

#include "tools/shrink/delta_debugging.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::tools {

namespace {

// Rounding makes a scene easier to read, not smaller: it gets a part of the runs that one can wait for.
constexpr std::size_t kMostRoundingRuns = 48;
constexpr int kMostDigits = 6;

constexpr std::size_t kMostSeparated = 2000;  // bodies of a scene whose copies are written as single bodies

// The shortest decimal that is nearest to a step, as a duration (s).
double duration_of(std::uint64_t step, double steps_per_second) {
    const double exact = static_cast<double>(step) / steps_per_second;
    for (int decimals = 0; decimals < 12; ++decimals) {
        char text[64];
        std::snprintf(text, sizeof text, "%.*f", decimals, exact);
        double duration = exact;
        std::from_chars(text, text + std::char_traits<char>::length(text), duration);
        if (nearest_step(duration, steps_per_second) == step) return duration;
    }
    return exact;
}

// Smaller numbers of copies, ascending: 1, a half, three quarters, ..., one less.
std::vector<std::int64_t> fewer_than(std::int64_t count) {
    std::vector<std::int64_t> fewer;
    if (count > 2) fewer.push_back(1);
    for (std::int64_t gap = count / 2; gap > 0; gap /= 2) fewer.push_back(count - gap);
    return fewer;
}

std::vector<Pointer> dropped(const std::vector<Pointer>& parts, const KeptParts& kept) {
    std::vector<Pointer> rest;
    std::size_t next = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (next < kept.size() && kept[next] == i)
            ++next;
        else
            rest.push_back(parts[i]);
    }
    return rest;
}

}  // namespace

Shrinker::Shrinker(const std::string& text, Failure failure, std::vector<std::string> kept_names,
                   Candidates& candidates, Keep keep, Report report)
    : failure_(std::move(failure)),
      kept_names_(std::move(kept_names)),
      candidates_(candidates),
      keep_(std::move(keep)),
      report_(std::move(report)) {
    accept(text);
    step_ = failure_.step;
}

void Shrinker::shrink() {
    if (failure_.claim >= 0) remove(PartKind::claims, false);  // all others
    if (failure_.claim >= 0 || step_ > 0) shorten();  // what comes later cannot hide the failure, and costs time
    remove_structure(false);
    separate_copies();
    shorten();
    remove(PartKind::keys, false);
    round_numbers();
    while (remove_structure(true) || shorten()) {
    }
}

bool Shrinker::remove_structure(bool singly) {
    bool removes = false;
    if (failure_.claim < 0) removes = remove(PartKind::claims, singly);
    for (const PartKind kind : {PartKind::events, PartKind::bodies, PartKind::joints, PartKind::shapes,
                                PartKind::points, PartKind::materials})
        removes = remove(kind, singly) || removes;
    return lower_repeats() || removes;
}

// The parts that may be missing: the failure needs its claim, and the user the bodies to keep.
std::vector<Pointer> Shrinker::removable_parts(PartKind kind) const {
    std::vector<Pointer> parts = parts_of(document_, kind);
    if (kind == PartKind::claims && failure_.claim >= 0) parts.erase(parts.begin() + failure_.claim);
    if (kind == PartKind::bodies)
        std::erase_if(parts, [&](const Pointer& body) {
            const std::string name = document_.at(body).value("name", "");
            return std::ranges::find(kept_names_, name) != kept_names_.end();
        });
    return parts;
}

std::optional<std::string> Shrinker::smaller_text(SceneJson document, PartKind kind) const {
    if (kind == PartKind::keys || kind == PartKind::points) return valid_text(document);
    std::optional<std::string> text = repaired_text(document);
    const bool lost_claim = failure_.claim >= 0 && (!document.contains("expect") || document["expect"].empty());
    return lost_claim ? std::nullopt : text;
}

bool Shrinker::remove(PartKind kind, bool singly) {
    const std::vector<Pointer> parts = removable_parts(kind);
    if (parts.empty()) return false;
    const SceneJson base = document_;
    const auto first_failing = [&](std::size_t count, const std::function<KeptParts(std::size_t)>& candidate) {
        return try_first(count, [&](std::size_t index) {
            return smaller_text(without(base, dropped(parts, candidate(index))), kind);
        });
    };
    const std::size_t kept = minimize(parts.size(), singly ? 1 : parts.size(), first_failing).size();
    if (kept == parts.size()) return false;
    report_(std::string(name_of(kind)) + ": " + std::to_string(parts.size()) + " -> " + std::to_string(kept));
    return true;
}

bool Shrinker::lower_repeats() {
    bool lowers = false;
    for (std::size_t i = 0; i < repeats_of(document_).size();) {
        const Repeat repeat = repeats_of(document_)[i];
        std::vector<SceneJson> smaller{without(document_, {repeat.repeat})};
        for (const Pointer& count : repeat.counts)
            for (const std::int64_t fewer : fewer_than(document_.at(count).get<std::int64_t>())) {
                smaller.push_back(document_);
                smaller.back()[count] = fewer;
            }
        const std::size_t found = try_first(
            smaller.size(), [&](std::size_t index) { return smaller_text(smaller[index], PartKind::bodies); });
        if (found == smaller.size())
            ++i;
        else
            lowers = true;
    }
    return lowers;
}

// Of a repeated body of which a claim or a joint needs the last copy, no copy can go before it is single.
void Shrinker::separate_copies() {
    for (std::size_t i = 0; i < scene_.bodies.size();) i = separate_copies_of(i) ? 0 : i + 1;
}

bool Shrinker::separate_copies_of(std::size_t body) {
    const SceneBody& repeated = scene_.bodies[body];
    const bool is_kept = std::ranges::find(kept_names_, repeated.name) != kept_names_.end();
    const std::size_t before = count_bodies(scene_);
    if (!repeated.repeat || is_kept || before > kMostSeparated) return false;
    const std::string text = to_json(scene_);
    const std::uint64_t step = step_;
    const std::size_t found = try_first(
        1, [&](std::size_t) { return smaller_text(with_single_copies(document_, scene_, body), PartKind::bodies); });
    if (found > 0) return false;
    remove(PartKind::bodies, false);
    if (count_bodies(scene_) < before) return true;
    accept(text);
    step_ = step;
    return false;
}

bool Shrinker::shorten_to(std::uint64_t step) {
    SceneJson shorter = document_;
    shorter["world"]["duration"] = duration_of(step, scene_.world.steps_per_second);
    return try_first(1, [&](std::size_t) { return valid_text(shorter); }) == 0;
}

// A claim that the last step decides speaks of the end of the run, which therefore stays.
bool Shrinker::shorten() {
    const std::uint64_t last = count_steps(scene_);
    if (failure_.claim < 0 && step_ == 0) return search_shorter();
    if (step_ >= last || !shorten_to(step_)) return false;
    report_("steps: " + std::to_string(last) + " -> " + std::to_string(count_steps(scene_)));
    return true;
}

// The step of the failure is not known: by bisection, because the shorter run is the beginning of the longer one.
bool Shrinker::search_shorter() {
    const std::uint64_t last = count_steps(scene_);
    std::uint64_t too_short = 0;
    if (last == 0 || shorten_to(0)) return last > 0;
    while (count_steps(scene_) - too_short > 1) {
        const std::uint64_t middle = too_short + (count_steps(scene_) - too_short) / 2;
        if (!shorten_to(middle)) too_short = middle;
    }
    return count_steps(scene_) < last;
}

void Shrinker::round_numbers() {
    const std::size_t most_runs = candidates_.run_count() + kMostRoundingRuns;
    for (int digits = 1; digits <= kMostDigits; ++digits) {
        const SceneJson base = document_;
        std::vector<Pointer> numbers = fractions_of(base);
        std::erase_if(numbers, [&](const Pointer& at) {
            const double number = base.at(at).get<double>();
            return rounded(number, digits) == number;
        });
        const auto make = [&](const KeptParts& kept) {
            SceneJson document = base;
            for (const Pointer& at : dropped(numbers, kept)) document[at] = rounded(base.at(at).get<double>(), digits);
            return valid_text(document);
        };
        minimize(numbers.size(), numbers.size(),
                 [&](std::size_t count, const std::function<KeptParts(std::size_t)>& candidate) {
                     const std::size_t used = candidates_.run_count();
                     const std::size_t most = used < most_runs ? std::min(count, most_runs - used) : 0;
                     const std::size_t found =
                         try_first(most, [&](std::size_t index) { return make(candidate(index)); });
                     return found == most ? count : found;
                 });
    }
}

std::size_t Shrinker::try_first(std::size_t count, const Candidates::Make& make) {
    const std::size_t found = candidates_.first_failing(count, make);
    if (found < count) {
        step_ = candidates_.step();
        accept(candidates_.text());
    }
    return found;
}

void Shrinker::accept(const std::string& text) {
    scene_ = parse_scene(text, "candidate");
    document_ = SceneJson::parse(text);
    keep_(text);
}

}  // namespace tumble::tools
