#include "sweep/store/stored_file.hpp"

#ifndef __clang_analyzer__
#define XXH_INLINE_ALL
#endif
#include <xxhash.h>

#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "sweep/store/durable.hpp"
#include "tumble/file.hpp"

namespace tumble::sweep {

namespace {

struct FreeState {
    void operator()(XXH64_state_t* state) const { XXH64_freeState(state); }
};

class Hash {
public:
    Hash() { XXH64_reset(state_.get(), 0); }
    void update(std::string_view bytes) { XXH64_update(state_.get(), bytes.data(), bytes.size()); }
    std::uint64_t digest() const { return XXH64_digest(state_.get()); }

private:
    std::unique_ptr<XXH64_state_t, FreeState> state_{XXH64_createState()};
};

}  // namespace

struct StoredFileWriter::Impl {
    std::string name;
    OutputFile file;
    Hash hash{};
};

StoredFileWriter::StoredFileWriter(const std::filesystem::path& folder, const std::string& name)
    : impl_(new Impl{name, OutputFile(folder / name)}) {}

StoredFileWriter::~StoredFileWriter() = default;

void StoredFileWriter::write(std::string_view bytes) {
    impl_->file.write(bytes);
    impl_->hash.update(bytes);
    size_ += bytes.size();
}

StoredFile StoredFileWriter::commit() {
    impl_->file.save_so_far();
    make_durable(impl_->file.temporary());
    const std::uint64_t bytes = impl_->file.commit();
    return {impl_->name, bytes, impl_->hash.digest()};
}

StoredFile read_stored_file(const std::filesystem::path& folder, const std::string& name) {
    if (!std::filesystem::is_regular_file(folder / name)) throw FileError(folder / name, "is no regular file");
    std::ifstream stream(folder / name, std::ios::binary);
    if (!stream) throw FileError(folder / name, std::generic_category().message(errno));
    Hash hash;
    StoredFile file{.name = name};
    std::string block(1 << 20, '\0');
    while (stream) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        const auto count = static_cast<std::size_t>(stream.gcount());
        hash.update(std::string_view(block).substr(0, count));
        file.bytes += count;
    }
    file.hash = hash.digest();
    return file;
}

}  // namespace tumble::sweep
