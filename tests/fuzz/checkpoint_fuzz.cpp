// libFuzzer target over checkpoints, as `run --resume` reads them: any file is refused with an error, or continues a
// run. Bytes that begin with { are a whole file. Others change bytes of a saved run or watch, and the checksum is made
// to match.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "bytes.hpp"
#include "scratch_file.hpp"
#include "tools/output/input_error.hpp"
#include "tools/run/checkpoint.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

const Scene& scene() {
    static const Scene scene = parse_scene(R"({"format": 1, "bodies": [
        {"name": "ball", "position": [0, 2], "shapes": [{"circle": {"radius": 0.5}}]},
        {"name": "floor", "type": "static", "shapes": [{"box": {"size": [9, 1]}}]}],
        "timeline": [{"at": 0.01, "spawn": {"name": "late", "shapes": [{"circle": {"radius": 0.2}}]}},
                     {"when": "ball.y < 1.5", "body": "ball", "impulse": [0, 1]}],
        "expect": [{"max_energy_gain": 1}, {"body": "ball", "touches": "floor"}, {"count": [0, 3], "when": "always"}]})",
                                           "");
    return scene;
}

struct Saved {
    std::vector<std::byte> run, watch;
};

const Saved& saved() {
    static const Saved saved = [] {
        SceneRun run(scene());
        ExpectationWatch watch(scene(), run.built());
        for (int i = 0; i < 3; ++i) {
            run.step();
            watch.observe(run.built());
        }
        return Saved{run.save(scene()), watch.save()};
    }();
    return saved;
}

// The bytes with changes of 3 bytes each: where, as 16 bits, and the new value.
std::vector<std::byte> changed(std::vector<std::byte> bytes, fuzz::Bytes changes, std::size_t count) {
    constexpr std::size_t kHashBytes = sizeof(std::uint64_t);
    std::byte* const data = bytes.data();
    if (!data || bytes.size() <= kHashBytes) return bytes;
    const std::size_t size = bytes.size() - kHashBytes;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = changes.take<std::uint16_t>() % size;
        data[at] = static_cast<std::byte>(changes.take<std::uint8_t>());
    }
    const std::uint64_t hash = XXH64(data, size, 0);
    std::memcpy(data + size, &hash, sizeof hash);
    return bytes;
}

void continue_run(SceneRun run) {
    ExpectationWatch watch(scene(), run.built());
    for (int i = 0; i < 2; ++i) {
        run.step();
        watch.observe(run.built());
    }
    watch.results();
}

void read(const std::uint8_t* data, std::size_t size) {
    if (data[0] == '{') {
        const tools::Checkpoint checkpoint = tools::parse_checkpoint(fuzz::text_of(data, size));
        continue_run(tools::load_run(scene(), checkpoint, "folder"));
    } else if (data[0] % 2 == 0) {
        const auto run = changed(saved().run, {data + 1, size - 1}, (size - 1) / 3);
        continue_run(SceneRun::load(scene(), run));
    } else {
        const SceneRun run(scene());
        const auto watch = changed(saved().watch, {data + 1, size - 1}, (size - 1) / 3);
        ExpectationWatch::load(scene(), run.built(), watch).results();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    try {
        read(data, size);
    } catch (const tools::InputError&) {
    } catch (const SnapshotError&) {
    } catch (const SceneError&) {
    } catch (const SimulationDiverged&) {
    }
    return 0;
}
