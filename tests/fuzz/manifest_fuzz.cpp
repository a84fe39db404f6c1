// libFuzzer target over manifests of sweeps: any text is read, or refused with an error. What was read is written and
// read again without a change.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "scratch_file.hpp"
#include "sweep/store/manifest.hpp"
#include "tumble/file.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile file("manifest.jsonl");
    const std::filesystem::path folder = file.write(fuzz::text_of(data, size)).parent_path();
    try {
        const sweep::Manifest manifest = sweep::read_manifest(folder);
        for (const auto& [shard, entry] : manifest.shards) {
            if (!manifest.header || shard >= manifest.header->shards()) std::abort();
            for (const sweep::StoredFile& stored : entry.files)
                if (stored.name.find('/') != std::string::npos) std::abort();
        }
        sweep::write_manifest(folder, manifest);
        const sweep::Manifest again = sweep::read_manifest(folder);
        if (again.damaged_lines != 0 || again.header != manifest.header) std::abort();
        if (again.shards.size() != manifest.shards.size()) std::abort();
    } catch (const FileError&) {
    }
    return 0;
}
