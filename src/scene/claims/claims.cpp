#include "scene/claims/claims.hpp"

#include <utility>

#include "scene/format/fields.hpp"
#include "scene/json/json_text.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

bool is_one_value(const SceneInterval& allowed) { return allowed.lower == allowed.upper; }

// "4", "between 3 and 5".
std::string between(const SceneInterval& allowed) {
    if (is_one_value(allowed)) return number_text(allowed.lower);
    return "between " + number_text(allowed.lower) + " and " + number_text(allowed.upper);
}
// "exactly 4".
std::string amount(const SceneInterval& allowed) {
    return (is_one_value(allowed) ? "exactly " : "") + between(allowed);
}

// "the height of 'crate' is between 1 and 2 m".
std::string measure_text(const char* what, const SceneExpectation& claim, const SceneInterval& allowed,
                         const char* unit) {
    return std::string("the ") + what + " of '" + claim.body + "' is " + between(allowed) + " " + unit;
}
std::string box_text(const SceneBox& box) { return brief(box.first) + " to " + brief(box.second); }

// "in the frame at [1, 2] turned by 30 degrees".
std::string frame_text(const SceneExpectation& claim) {
    if (!claim.frame) return "";
    const std::string turn =
        claim.frame->angle == 0.0 ? "" : " turned by " + number_text(claim.frame->angle) + " degrees";
    return " in the frame at " + brief(claim.frame->position) + turn;
}

// " from 2 s until 3 s", or nothing.
std::string window_text(const SceneExpectation& claim) {
    std::string window;
    if (claim.from) window += " from " + number_text(*claim.from) + " s" + (claim.until ? "" : " on");
    if (claim.until) window += " until " + number_text(*claim.until) + " s";
    return window;
}

// "at 4 s", "always from 2 s on".
std::string time_text(const SceneExpectation& claim) {
    if (claim.at) return " at " + number_text(*claim.at) + " s";
    std::string window = window_text(claim);
    switch (claim.when) {
        case SceneMoment::end: return " at the end" + window;
        case SceneMoment::always: return " always" + window;
        case SceneMoment::sometime: return " sometime" + window;
    }
    return window;
}

// "exactly 1 body is in [0, 0] to [1, 1]", "between 2 and 3 of 'crate' are in ...".
std::string count_text(const SceneExpectation& claim) {
    const SceneInterval& count = claim.count.value();
    const bool is_one = is_one_value(count) && count.lower == 1.0;
    const std::string bodies = claim.body.empty() ? (is_one ? "body" : "bodies") : "of '" + claim.body + "'";
    return amount(count) + " " + bodies + (is_one ? " is" : " are") + " in " + box_text(claim.region.value());
}

// "exactly 1 'joint_broke' happens by the end".
std::string event_count_text(const SceneExpectation& claim) {
    const SceneInterval& count = claim.event_count.value();
    const bool is_one = is_one_value(count) && count.lower == 1.0;
    const std::string by = claim.at ? number_text(*claim.at) + " s" : "the end";
    return amount(count) + " '" + std::string(enum_name(claim.event.value())) + "'" +
           (claim.body.empty() ? "" : " of '" + claim.body + "'") + (is_one ? " happens by " : " happen by ") + by;
}

}  // namespace

std::unique_ptr<Claim> make_claim(const SceneExpectation& claim, const KnownNames& names, const SceneWorld& built) {
    if (std::unique_ptr<Claim> of_world = make_claim_of_world(claim, built)) return of_world;
    if (std::unique_ptr<Claim> of_conditions = make_claim_of_conditions(claim, names)) return of_conditions;
    if (std::unique_ptr<Claim> of_runs = make_claim_of_runs(claim)) return of_runs;
    if (std::unique_ptr<Claim> of_touches = make_claim_of_touches(claim, names.bodies)) return of_touches;
    if (std::unique_ptr<Claim> of_counts = make_claim_of_counts(claim)) return of_counts;
    return make_claim_of_bodies(claim, names.bodies);
}

bool can_have_frame(const SceneExpectation& claim) {
    return claim.inside || claim.outside || claim.height || claim.angle || claim.count || !claim.that.empty();
}

std::string claim_text(const SceneExpectation& claim) {
    const std::string body = "'" + claim.body + "'";
    if (claim.at_rest_by) return "everything is at rest from " + number_text(*claim.at_rest_by) + " s on";
    if (claim.max_penetration) return "no overlap is deeper than " + number_text(*claim.max_penetration) + " m";
    if (claim.max_joint_error)
        return "the anchors of " + (claim.joint.empty() ? "all joints" : "'" + claim.joint + "'") + " stay within " +
               number_text(*claim.max_joint_error) + " m";
    if (claim.max_energy_gain)
        return "the energy does not grow by more than " + number_text(*claim.max_energy_gain) + " J" +
               window_text(claim);
    if (claim.inside) return body + " is inside " + box_text(*claim.inside) + frame_text(claim) + time_text(claim);
    if (claim.outside) return body + " is outside " + box_text(*claim.outside) + frame_text(claim) + time_text(claim);
    if (claim.height) return measure_text("height", claim, *claim.height, "m") + frame_text(claim) + time_text(claim);
    if (claim.speed) return measure_text("speed", claim, *claim.speed, "m/s") + time_text(claim);
    if (claim.angle)
        return measure_text("angle", claim, *claim.angle, "degrees") + frame_text(claim) + time_text(claim);
    if (!claim.touches.empty()) return body + " touches '" + claim.touches + "'";
    if (!claim.never_touches.empty()) return body + " never touches '" + claim.never_touches + "'";
    if (claim.count) return count_text(claim) + frame_text(claim) + time_text(claim);
    if (claim.event_count) return event_count_text(claim);
    if (!claim.before.empty()) return claim.that + frame_text(claim) + " before " + claim.before;
    if (!claim.that.empty()) return claim.that + frame_text(claim) + time_text(claim);
    if (claim.max_ms_per_step)
        return "a step takes at most " + number_text(*claim.max_ms_per_step) + " ms" + window_text(claim);
    if (claim.max_time_ratio)
        return "a step takes at most " + number_text(*claim.max_time_ratio) + " times as long as one of " +
               claim.reference;
    if (!claim.picture.empty())
        return "the frame equals " + claim.picture + " up to " + number_text(claim.tolerance.value_or(0.0)) +
               " levels" + time_text(claim);
    return "the state hash is " + claim.state_hash + time_text(claim);
}

}  // namespace tumble::scene
