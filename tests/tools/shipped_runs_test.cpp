// One run of every shipped scene: its claims hold, something moves, and what its claims name stays in the frame.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "process.hpp"
#include "render/view/box.hpp"
#include "scene/shipped.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;
namespace fs = std::filesystem;

namespace {

constexpr double kAspect = 16.0 / 9.0;  // of the frames
constexpr double kStill = 0.05;         // of the frame's height: a displacement too small to see

// In these, bodies roll or fall out of the frame at the end, when there is no more to see of them.
const std::set<std::string> kRollAway{"breakable_bridge", "cliff", "ghost_bumps"};

struct Found {
    std::vector<std::string> failed;        // claims
    std::map<std::string, double> cut_off;  // named by claims: when (s) a part leaves the frame
    double moved = 0.0;                     // the largest displacement of a body, over the frame's height
};

bool shows(const Camera& camera, const render::Box& box) {
    const DVec2 half = 0.5 * camera.height * DVec2{kAspect, 1.0};
    return render::Box{camera.center - half, camera.center + half}.contains(box);
}

class Watched {
public:
    explicit Watched(const fs::path& file) : scene_(load_scene(file)), run_(scene_), claims_(scene_, run_.built()) {
        for (const SceneExpectation& claim : scene_.expect) named_.insert(claim.body);
        camera_ = make_camera(scene_, run_.built(), kAspect);
    }

    Found run() {
        const auto steps = count_steps(scene_);
        observe();
        while (run_.world().step_count() < steps && !run_.is_stopped()) {
            run_.step();
            camera_ = move_camera(camera_, scene_, run_.built());
            observe();
        }
        for (const ExpectationResult& result : claims_.results())
            if (!result.passed) found_.failed.push_back(result.claim + ": " + result.finding);
        return found_;
    }

private:
    void observe() {
        claims_.observe(run_.built());
        const World& world = run_.world();
        for (const SceneInstance& body : run_.built().bodies) {
            if (!world.is_valid(body.id)) continue;
            const DVec2 position = world.state(body.id).pose.position;
            const DVec2 start = starts_.try_emplace(body.id, position).first->second;
            found_.moved = std::max(found_.moved, length(position - start) / camera_.height);
            const bool is_named = named_.contains(body.name) && world.type(body.id) != BodyType::static_body;
            if (!is_named) continue;
            if (shows(camera_, render::box_of(world, body.id)))
                has_entered_.insert(body.name);
            else if (has_entered_.contains(body.name))
                found_.cut_off.try_emplace(body.name, world.time());
        }
    }

    Scene scene_;
    SceneRun run_;
    ExpectationWatch claims_;
    std::set<std::string> named_;
    std::map<BodyId, DVec2> starts_;
    std::set<std::string> has_entered_;  // the frame
    Camera camera_;
    Found found_;
};

// In the order of the files; on all processors.
std::map<std::string, Found> run_all(const std::vector<fs::path>& files) {
    std::vector<Found> found(files.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < files.size(); i = next++) found[i] = Watched(files[i]).run();
    };
    std::vector<std::thread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::thread& thread : threads) thread = std::thread(work);
    for (std::thread& thread : threads) thread.join();
    std::map<std::string, Found> named;
    for (std::size_t i = 0; i < files.size(); ++i) named[files[i].stem().string()] = found[i];
    return named;
}

}  // namespace

TEST_CASE("the claims of all shipped scenes hold, their bodies move, and what claims name stays in the frame") {
    const std::vector<fs::path> files = test::shipped_scenes();
    REQUIRE(files.size() > 50);
    const std::size_t stride = test::case_stride();
    std::vector<fs::path> chosen;
    for (std::size_t i = 0; i < files.size(); i += stride) chosen.push_back(files[i]);
    std::set<std::string> still;
    for (const auto& entry : run_all(chosen)) {
        const std::string& name = entry.first;
        const Found& found = entry.second;
        CAPTURE(name);
        for (const std::string& claim : found.failed) FAIL_CHECK(claim);
        if (found.moved < kStill) still.insert(name);
        if (kRollAway.contains(name)) continue;
        for (const auto& [body, time] : found.cut_off) FAIL_CHECK(body << " leaves the frame at " << time << " s");
    }
    std::string names;
    for (const std::string& name : still) names += name + " ";
    CHECK_MESSAGE(still.size() <= 3, names);  // the subject of some scenes is that nothing moves
}
