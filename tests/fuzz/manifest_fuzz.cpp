// libFuzzer target over manifests of sweeps: any text is read, or refused with an error. What was read is written and
// read again without a change.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "scratch_file.hpp"
#include "sweep/store/manifest.hpp"
#include "tumble/file.hpp"

using namespace tumble;

namespace {

bool leaves_folder(const sweep::StoredFile& stored) { return stored.name.find('/') != std::string::npos; }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile file("manifest.jsonl");
    const std::filesystem::path folder = file.write(fuzz::text_of(data, size)).parent_path();
    try {
        const sweep::Manifest manifest = sweep::read_manifest(folder);
        for (const auto& [shard, entry] : manifest.shards) {
            if (!manifest.header || shard >= manifest.header->shards()) std::abort();
            if (leaves_folder(entry.table) || std::ranges::any_of(entry.files, leaves_folder)) std::abort();
        }
        if (manifest.table && leaves_folder(*manifest.table)) std::abort();
        sweep::write_manifest(folder, manifest);
        const sweep::Manifest again = sweep::read_manifest(folder);
        if (again.damaged_lines != 0 || again.header != manifest.header) std::abort();
        const std::string written = read_file(sweep::manifest_file(folder));
        sweep::write_manifest(folder, again);
        if (read_file(sweep::manifest_file(folder)) != written) std::abort();
    } catch (const FileError&) {
    }
    return 0;
}
