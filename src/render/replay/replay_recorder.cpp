#include <nlohmann/json.hpp>

#include <utility>

#include "render/replay/body_tracks.hpp"
#include "render/replay/contact_tracks.hpp"
#include "render/replay/event_marks.hpp"
#include "render/replay/header_json.hpp"
#include "render/replay/joint_tracks.hpp"
#include "render/replay/replay_page.hpp"
#include "tumble/replay.hpp"

namespace tumble {

namespace {

constexpr int kFormat = 1;

}  // namespace

struct ReplayRecorder::Impl {
    Impl(const Scene& scene_, const ReplaySettings& settings_)
        : scene(scene_),
          settings(settings_),
          quantum(render::position_quantum(scene_.world.scale)),
          bodies(scene_, quantum),
          joints(quantum),
          contacts(quantum) {}

    void record(const SceneWorld& built) {
        whole = whole && bodies.pose_count() + built.world.bodies().size() <= kMostReplayPoses;
        if (!whole) return;
        bodies.record(built);
        joints.record(built, bodies.numbers());
        broken.record(built);
        if (settings.contacts) contacts.record(built.world, bodies.numbers());
        last_step = built.world.step_count();
    }

    nlohmann::ordered_json claim_json(const ReplayClaim& claim) const {
        nlohmann::ordered_json json{{"claim", claim.claim},
                                    {"finding", claim.finding},
                                    {"passed", claim.passed},
                                    {"step", claim.step},
                                    {"regions", nlohmann::ordered_json::array()},
                                    {"bodies", nlohmann::ordered_json::array()}};
        for (const auto& region : claim.regions) json["regions"].push_back(render::numbers(region));
        for (const BodyId body : claim.bodies) json["bodies"].push_back(bodies.numbers()[body.index]);
        return json;
    }

    nlohmann::ordered_json event_json() const {
        nlohmann::ordered_json json = nlohmann::ordered_json::array();
        for (const auto& marks : {render::timeline_marks(scene, last_step), broken.marks()})
            for (const render::EventMark& mark : marks) json.push_back({{"step", mark.step}, {"text", mark.text}});
        return json;
    }

    std::string header(std::span<const ReplayClaim> claims, bool complete) const {
        const Camera& camera = settings.camera;
        const bool follows = camera.follows.index < bodies.numbers().size();
        nlohmann::ordered_json json{
            {"format", kFormat},
            {"name", scene.name},
            {"steps_per_second", scene.world.steps_per_second},
            {"last_step", last_step},
            {"complete", complete && whole},
            {"quantum", quantum},
            {"angles_per_turn", render::kAnglesPerTurn},
            {"contact_quantum", render::kContactQuantum * quantum},
            {"normals_per_turn", render::kNormalsPerTurn},
            {"least_impulse", render::kLeastImpulse},
            {"impulses_per_octave", render::kImpulsesPerOctave},
            {"camera",
             {{"center", {camera.center.x, camera.center.y}},
              {"height", camera.height},
              {"follows", follows ? static_cast<int>(bodies.numbers()[camera.follows.index]) : -1}}},
            {"shapes", bodies.shapes_json()},
            {"bodies", bodies.bodies_json()},
            {"joints", joints.to_json()},
            {"events", event_json()},
            {"claims", nlohmann::ordered_json::array()}};
        for (const ReplayClaim& claim : claims) json["claims"].push_back(claim_json(claim));
        return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    }

    const Scene& scene;
    ReplaySettings settings;
    double quantum;
    render::BodyTracks bodies;
    render::JointTracks joints;
    render::ContactTracks contacts;
    render::BrokenJoints broken;
    std::uint64_t last_step = 0;
    bool whole = true;
};

ReplayRecorder::ReplayRecorder(const Scene& scene, const ReplaySettings& settings)
    : impl_(std::make_unique<Impl>(scene, settings)) {}
ReplayRecorder::~ReplayRecorder() = default;
ReplayRecorder::ReplayRecorder(ReplayRecorder&&) noexcept = default;
ReplayRecorder& ReplayRecorder::operator=(ReplayRecorder&&) noexcept = default;

void ReplayRecorder::record(const SceneWorld& built) { impl_->record(built); }

bool ReplayRecorder::is_whole() const noexcept { return impl_->whole; }

std::string ReplayRecorder::page(std::span<const ReplayClaim> claims, bool complete) const {
    const std::string header = impl_->header(claims, complete);
    std::string states;
    render::append_varint(states, header.size());
    states += header;
    states += impl_->bodies.pose_bytes();
    return render::replay_page(states, impl_->settings.contacts ? impl_->contacts.bytes() : std::string());
}

}  // namespace tumble
