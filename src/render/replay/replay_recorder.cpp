#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

#include "render/replay/body_tracks.hpp"
#include "render/replay/camera_track.hpp"
#include "render/replay/contact_tracks.hpp"
#include "render/replay/event_marks.hpp"
#include "render/replay/header_json.hpp"
#include "render/replay/joint_tracks.hpp"
#include "render/replay/notes_json.hpp"
#include "render/replay/pair_json.hpp"
#include "render/replay/replay_page.hpp"
#include "render/style/theme.hpp"
#include "tumble/recording.hpp"

namespace tumble {

namespace {

constexpr int kFormat = 2;

}  // namespace

struct ReplayRecorder::Impl {
    Impl(const Scene& scene, const ReplaySettings& settings_)
        : name(scene.name),
          steps_per_second(scene.world.steps_per_second),
          timeline(render::timeline_marks(scene)),
          conditions(scene),
          notes(render::notes_json(scene.camera.notes)),
          theme(settings_.theme.value_or(scene.camera.style.theme)),
          is_theme_stated(settings_.theme || theme != Theme::light),
          is_hatched(scene.camera.style.hatching),
          settings(settings_),
          quantum(render::position_quantum(scene.world.scale)),
          bodies(scene, quantum, fill_colors()),
          joints(quantum),
          contacts(quantum) {}

    // The page darkens the light fills itself, because its reader may switch to dark and back.
    const render::Colors& fill_colors() const { return render::colors_of(theme == Theme::dark ? Theme::light : theme); }

    void record(const SceneWorld& built, const Camera& camera, std::uint64_t step) {
        const World& world = built.world;
        whole = whole && bodies.pose_count() + world.bodies().size() <= settings.most_poses;
        if (!whole) return;
        if (settings.contacts) {
            const std::vector<ContactPoint> points = world.contacts();
            whole = contacts.cost() + points.size() <= settings.most_contact_points;
            if (!whole) return;
            bodies.record(built, step);
            contacts.record(world, points, bodies.numbers());
        } else {
            bodies.record(built, step);
        }
        joints.record(built, step, bodies.numbers());
        views.record(camera, world, step, bodies.numbers());
        broken.record(built);
        conditions.record(built);
        last_step = step;
    }

    nlohmann::ordered_json claim_json(const ReplayClaim& claim) const {
        nlohmann::ordered_json json{{"claim", claim.result.claim},
                                    {"finding", claim.result.finding},
                                    {"passed", claim.result.passed},
                                    {"step", claim.result.step},
                                    {"regions", nlohmann::ordered_json::array()},
                                    {"bodies", nlohmann::ordered_json::array()}};
        for (const auto& region : claim.marking.regions) json["regions"].push_back(render::numbers(region));
        for (const BodyId body : claim.marking.bodies)
            if (const auto number = render::find_number(bodies.numbers(), body)) json["bodies"].push_back(*number);
        return json;
    }

    // The events up to the last step, in the order of time.
    nlohmann::ordered_json event_json() const {
        std::vector<render::EventMark> marks = broken.marks();
        marks.insert(marks.end(), timeline.begin(), timeline.end());
        marks.insert(marks.end(), conditions.marks().begin(), conditions.marks().end());
        std::ranges::stable_sort(marks, {}, &render::EventMark::step);
        nlohmann::ordered_json json = nlohmann::ordered_json::array();
        for (const render::EventMark& mark : marks)
            if (mark.step <= last_step) json.push_back({{"step", mark.step}, {"text", mark.text}});
        return json;
    }

    std::string header(std::span<const ReplayClaim> claims, bool complete) const {
        nlohmann::ordered_json json{{"format", kFormat},
                                    {"name", name},
                                    {"steps_per_second", steps_per_second},
                                    {"last_step", last_step},
                                    {"complete", complete && whole},
                                    {"quantum", quantum},
                                    {"angles_per_turn", render::kAnglesPerTurn},
                                    {"contact_quantum", render::kContactQuantum * quantum},
                                    {"normals_per_turn", render::kNormalsPerTurn},
                                    {"least_impulse", render::kLeastImpulse},
                                    {"impulses_per_octave", render::kImpulsesPerOctave},
                                    {"aspect_ratio", settings.aspect_ratio},
                                    {"theme", is_theme_stated ? render::name_of(theme) : ""},
                                    {"hatching", is_hatched},
                                    {"views", views.to_json()},
                                    {"island_colors", nlohmann::ordered_json::array()},
                                    {"shapes", bodies.shapes_json()},
                                    {"bodies", bodies.bodies_json()},
                                    {"joints", joints.to_json()},
                                    {"notes", notes},
                                    {"events", event_json()},
                                    {"claims", nlohmann::ordered_json::array()}};
        for (const Color color : fill_colors().bodies) json["island_colors"].push_back(render::to_hex(color));
        for (const ReplayClaim& claim : claims) json["claims"].push_back(claim_json(claim));
        return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    }

    // As format 2 has them.
    std::string states(std::span<const ReplayClaim> claims, bool complete) const {
        const std::string json = header(claims, complete);
        std::string bytes;
        render::append_varint(bytes, json.size());
        return bytes + json + bodies.pose_bytes();
    }

    std::string name;  // of the scene, which may be gone when the page is made
    double steps_per_second;
    std::vector<render::EventMark> timeline;
    render::ConditionMarks conditions;
    nlohmann::ordered_json notes;
    Theme theme;
    bool is_theme_stated;
    bool is_hatched;
    ReplaySettings settings;
    double quantum;
    render::BodyTracks bodies;
    render::JointTracks joints;
    render::ContactTracks contacts;
    render::CameraTrack views;
    render::BrokenJoints broken;
    std::uint64_t last_step = 0;
    bool whole = true;
};

ReplayRecorder::ReplayRecorder(const Scene& scene, const ReplaySettings& settings)
    : impl_(std::make_unique<Impl>(scene, settings)) {}
ReplayRecorder::~ReplayRecorder() = default;
ReplayRecorder::ReplayRecorder(ReplayRecorder&&) noexcept = default;
ReplayRecorder& ReplayRecorder::operator=(ReplayRecorder&&) noexcept = default;

void ReplayRecorder::record(const SceneWorld& built, const Camera& camera) {
    impl_->record(built, camera, built.world.step_count());
}

void ReplayRecorder::record_as(std::uint64_t step, const SceneWorld& built, const Camera& camera) {
    impl_->record(built, camera, step);
}

bool ReplayRecorder::is_whole() const noexcept { return impl_->whole; }

std::string ReplayRecorder::page(std::span<const ReplayClaim> claims, bool complete) const {
    return render::replay_page(impl_->states(claims, complete),
                               impl_->settings.contacts ? impl_->contacts.bytes() : std::string());
}

std::string pair_page(const ReplayPair& pair) {
    return render::pair_page(
        pair.a.impl_->states({}, true), pair.b.impl_->states({}, true),
        render::pair_json(pair).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace tumble
