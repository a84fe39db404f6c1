#include "tools/tables/table_file.hpp"

#ifndef __clang_analyzer__  // it assumes null pointers that a string of some size does not have
#define XXH_INLINE_ALL
#endif
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "tools/cli/output_path.hpp"

namespace tumble::tools {

namespace {

struct FreeState {
    void operator()(XXH64_state_t* state) const { XXH64_freeState(state); }
};

}  // namespace

class TableFile::Hash {
public:
    Hash() { XXH64_reset(state_.get(), 0); }

    void update(std::string_view text) { XXH64_update(state_.get(), text.data(), text.size()); }
    std::uint64_t digest() const { return XXH64_digest(state_.get()); }

    // Adds the first bytes of a file; false if it has fewer.
    bool update_from(const std::filesystem::path& file, std::uint64_t count) {
        std::ifstream stream(file, std::ios::binary);
        if (!stream) throw FileError(file, std::generic_category().message(errno));
        std::string block(1 << 16, '\0');
        while (count > 0) {
            const auto part = static_cast<std::streamsize>(std::min<std::uint64_t>(block.size(), count));
            if (!stream.read(block.data(), part)) return false;
            update(std::string_view(block).substr(0, static_cast<std::size_t>(part)));
            count -= static_cast<std::uint64_t>(part);
        }
        return true;
    }

private:
    std::unique_ptr<XXH64_state_t, FreeState> state_{XXH64_createState()};
};

TableFile::TableFile(const std::filesystem::path& file, bool force)
    : file_(open_output(file, force)), hash_(std::make_unique<Hash>()) {}

TableFile::~TableFile() = default;

void TableFile::write(std::string_view text) {
    file_.write(text);
    hash_->update(text);
}

TableBytes TableFile::save_so_far() {
    const std::uint64_t count = file_.save_so_far();
    return {count, hash_->digest()};
}

bool TableFile::continue_from(const std::filesystem::path& earlier, const TableBytes& expected) {
    auto hash = std::make_unique<Hash>();
    if (!hash->update_from(earlier, expected.count) || hash->digest() != expected.hash) return false;
    file_.append_from(earlier, file_.save_so_far(), expected.count);
    hash_ = std::move(hash);
    return true;
}

}  // namespace tumble::tools
