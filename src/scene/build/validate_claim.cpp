#include "scene/build/validate_claim.hpp"

#include <utility>

#include "scene/build/validate_expression.hpp"
#include "scene/claims/claims.hpp"

namespace tumble::scene {

void validate_claim(const SceneExpectation& claim, const std::string& pointer, const References& references,
                    Diagnostics& diagnostics) {
    if (diagnostics.has_errors_in(pointer)) return;
    const bool of_body = claim.inside || claim.outside || claim.height || claim.speed || claim.angle ||
                         !claim.touches.empty() || !claim.never_touches.empty();
    const bool of_some = claim.count || claim.event_count;  // of a body, its copies or all bodies
    const bool of_state = claim.inside || claim.outside || claim.height || claim.speed || claim.angle || claim.count ||
                          (!claim.that.empty() && claim.before.empty());
    const auto refuse = [&](bool present, const std::string& key, const std::string& reason) {
        if (present) diagnostics.error(pointer + '/' + key, reason);
    };
    if (of_body) references.body_or_copies(claim.body, pointer, "body");
    if (of_some && !claim.body.empty()) references.body_or_copies(claim.body, pointer, "body");
    refuse(!of_body && !of_some && !claim.body.empty(), "body", "belongs to claims on a body, counts and event counts");
    if (!claim.touches.empty()) references.body_or_copies(claim.touches, pointer, "touches");
    if (!claim.never_touches.empty()) references.body_or_copies(claim.never_touches, pointer, "never_touches");
    if (!claim.joint.empty()) references.joint(claim.joint, pointer, "joint", true);
    refuse(!claim.joint.empty() && !claim.max_joint_error, "joint", "belongs to 'max_joint_error'");
    if (claim.count && !claim.region)
        diagnostics.error(pointer, "the key 'region' is missing: the box in which bodies are counted");
    refuse(claim.region && !claim.count, "region", "belongs to 'count'");
    refuse(claim.frame && !can_have_frame(claim), "frame",
           "belongs to claims on positions, heights and angles, and to conditions");
    if (!claim.that.empty()) validate_condition(claim.that, pointer + "/that", references, diagnostics);
    if (!claim.before.empty()) validate_condition(claim.before, pointer + "/before", references, diagnostics);
    refuse(!claim.before.empty() && claim.that.empty(), "before", "belongs to 'that'");
    refuse(!claim.reference.empty() && !claim.max_time_ratio, "reference", "belongs to 'max_time_ratio'");
    if (claim.max_time_ratio && claim.reference.empty())
        diagnostics.error(pointer, "the key 'reference' is missing: the scene file that is compared with");
    refuse(claim.tolerance && claim.picture.empty(), "tolerance", "belongs to 'picture'");
    if (claim.event_count && !claim.event)
        diagnostics.error(pointer, "the key 'event' is missing: the kind of event that is counted");
    refuse(claim.event && !claim.event_count, "event", "belongs to 'event_count'");
    refuse(claim.when != SceneMoment::end && (!of_state || claim.at), "when",
           "belongs to claims on a state without 'at'");
    const bool at_one_time = of_state || claim.event_count || !claim.state_hash.empty() || !claim.picture.empty();
    refuse(claim.at && !at_one_time, "at", "belongs to claims that are evaluated at one time");
    const bool over_a_time = !claim.at && !claim.at_rest_by && claim.state_hash.empty() && !claim.event_count &&
                             claim.picture.empty() && claim.before.empty() && !claim.max_time_ratio &&
                             !(of_state && claim.when == SceneMoment::end);
    const std::string hint = of_state && !claim.at ? R"(add "when": "always" or "sometime")" : "";
    if (claim.from && !over_a_time) diagnostics.error(pointer + "/from", "belongs to claims over a time span", hint);
    if (claim.until && !over_a_time) diagnostics.error(pointer + "/until", "belongs to claims over a time span", hint);
    if (claim.from && claim.until && *claim.until < *claim.from)
        diagnostics.error(pointer + "/until", "must not be before 'from'");
    for (const auto& [box, key] :
         {std::pair{&claim.inside, "inside"}, {&claim.outside, "outside"}, {&claim.region, "region"}}) {
        if (!*box) continue;
        const auto& [lower, upper] = **box;
        if (lower.x > upper.x || lower.y > upper.y)
            diagnostics.error(pointer + '/' + key, "must be the lower left and the upper right corner of a box");
    }
}

}  // namespace tumble::scene
