// libFuzzer target over plans of sweeps: any text is a plan whose first runs can be chosen, or an error.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "scratch_file.hpp"
#include "sweep/plan/plan.hpp"
#include "tumble/file.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;

namespace {

// With the scene that the seeds name beside it.
struct PlanFile : fuzz::ScratchFile {
    PlanFile() : ScratchFile("fuzzed.plan.json") {
        const char* const scene = R"({"format": 1, "bodies": [{"name": "a", "shapes": [{"circle": {"radius": 1}}]}]})";
        save_scene(parse_scene(scene, "scene"), write("").parent_path() / "scene.json");
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const PlanFile file;
    try {
        const sweep::Plan plan = sweep::read_plan(file.write(fuzz::text_of(data, size)));
        if (plan.runs == 0 || sweep::shard_count(plan) == 0) std::abort();
        for (const std::uint64_t run : {std::uint64_t{0}, plan.runs / 2, plan.runs - 1}) {
            const sweep::RunChoice choice = sweep::choose_run(plan, run);
            if (choice.run != run || choice.values.size() != plan.parameters.size()) std::abort();
            if (choice.scene >= plan.scenes.size()) std::abort();
        }
    } catch (const SceneError&) {
    } catch (const FileError&) {
    }
    return 0;
}
