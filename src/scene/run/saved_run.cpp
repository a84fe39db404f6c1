#include "scene/run/saved_run.hpp"

#include <bit>

#include "scene/model/saved_bytes.hpp"
#include "tumble/world.hpp"

namespace tumble::scene {

namespace {

constexpr std::uint64_t kMagic = 0x33'4e'55'52'4c'42'4d'54;  // "TMBLRUN3"

}  // namespace

std::vector<std::byte> to_bytes(const SavedRun& run) {
    SaveWriter writer;
    writer.number(kMagic);
    writer.number(run.scene_hash);
    writer.number(run.bodies.size());
    for (const SceneInstance& body : run.bodies) {
        writer.number(body.id.index);
        writer.number(body.id.generation);
        writer.number(body.source);
        writer.text(body.name);
    }
    writer.number(run.events.size());
    for (const SavedEvent& event : run.events) {
        writer.number(event.count);
        writer.number(event.spawned);
        writer.number(event.held);
    }
    writer.number(std::bit_cast<std::uint64_t>(run.work));
    writer.block(run.world);
    return writer.finish();
}

SavedRun read_saved_run(std::span<const std::byte> bytes) {
    SaveReader reader(bytes, "run");
    SavedRun run;
    if (reader.number() != kMagic) throw SnapshotError("these bytes are no saved run of this version");
    run.scene_hash = reader.number();
    for (std::size_t left = reader.count(4 * sizeof(std::uint64_t)); left > 0; --left) {
        SceneInstance& body = run.bodies.emplace_back();
        body.id.index = static_cast<std::uint32_t>(reader.number());
        body.id.generation = static_cast<std::uint32_t>(reader.number());
        body.source = reader.number();
        body.name = reader.text();
    }
    for (std::size_t left = reader.count(3 * sizeof(std::uint64_t)); left > 0; --left) {
        SavedEvent& event = run.events.emplace_back();
        event.count = reader.number();
        event.spawned = reader.number();
        event.held = reader.number();
    }
    run.work = std::bit_cast<double>(reader.number());
    const std::span<const std::byte> world = reader.block();
    run.world.assign(world.begin(), world.end());
    reader.finish();
    return run;
}

}  // namespace tumble::scene
