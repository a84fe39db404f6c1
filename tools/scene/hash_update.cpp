#include "tools/scene/hash_update.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tumble/file.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

void update_hashes(SceneCheck& check) {
    // The file itself, so that a link to it stays one.
    const std::filesystem::path file = std::filesystem::canonical(check.file);
    std::string text = read_file(file);
    std::vector<UpdatedHash> updated;
    for (std::size_t i = 0; i < check.expectations.size(); ++i) {
        const ExpectationResult& result = check.expectations[i];
        if (result.passed || result.state_hash.empty()) continue;
        const std::string pointer = pointer_of_claim(i) + "/state_hash";
        text = replace_text(text, pointer, result.state_hash);
        updated.push_back({pointer, check.claimed_hashes[i], result.state_hash});
    }
    if (updated.empty()) return;
    OutputFile output(file);
    output.write(text);
    output.commit();
    check.updated = std::move(updated);
    for (ExpectationResult& result : check.expectations)
        if (!result.state_hash.empty()) result.passed = true;
    if (std::ranges::all_of(check.expectations, &ExpectationResult::passed)) check.code = ExitCode::ok;
}

}  // namespace tumble::tools
